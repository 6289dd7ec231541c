// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
#define THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <set>

namespace tbb {

// The number of threads is the least that any object asks for.
class global_control
{
public:
  enum parameter
  {
    max_allowed_parallelism
  };

  global_control(parameter, std::size_t threads)
  {
    const std::lock_guard<std::mutex> lock(mutex());
    m_place = limits().insert(threads);
  }

  ~global_control()
  {
    const std::lock_guard<std::mutex> lock(mutex());
    limits().erase(m_place);
  }

  global_control(const global_control&) = delete;

  static std::size_t active_value(parameter)
  {
    const std::lock_guard<std::mutex> lock(mutex());
    return limits().empty() ? 4 : *limits().begin();
  }

private:
  static std::mutex& mutex()
  {
    static std::mutex the_mutex;
    return the_mutex;
  }

  static std::multiset<std::size_t>& limits()
  {
    static std::multiset<std::size_t> the_limits;
    return the_limits;
  }

  std::multiset<std::size_t>::iterator m_place;
};

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_GLOBAL_CONTROL_H
