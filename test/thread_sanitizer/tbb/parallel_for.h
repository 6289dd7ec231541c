// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef THREAD_SANITIZER_TBB_PARALLEL_FOR_H
#define THREAD_SANITIZER_TBB_PARALLEL_FOR_H

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

// Each thread takes the next element that none has taken. An exception of the body is thrown again when all threads have
// ended.
template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
  std::atomic<Value> next(range.begin());
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto work = [&] {
    for(Value i = next++; i < range.end(); i = next++)
      try
      {
        body(blocked_range<Value>(i, i + 1));
      }
      catch(...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        if(thrown == nullptr)
          thrown = std::current_exception();
        return;
      }
  };
  std::vector<std::thread> threads;
  for(std::size_t i = 1; i < global_control::active_value(global_control::max_allowed_parallelism); ++i)
    threads.emplace_back(work);
  work();
  for(std::thread& thread : threads)
    thread.join();
  if(thrown != nullptr)
    std::rethrow_exception(thrown);
}

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_PARALLEL_FOR_H
