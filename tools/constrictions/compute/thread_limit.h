// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_THREAD_LIMIT_H
#define CONSTRICTIONS_THREAD_LIMIT_H

#include <cstddef>
#include <memory>
#include <optional>

namespace constrictions {

/// As long as it lives, no more threads compute than the given number. Without a number, or where the program has been
/// built without oneTBB and computes with one thread anyway, it does nothing.
class Thread_limit
{
public:
  explicit Thread_limit(std::optional<std::size_t> threads);
  ~Thread_limit();

private:
  struct Control;
  std::unique_ptr<Control> m_control;
};

} // namespace constrictions

#endif // CONSTRICTIONS_THREAD_LIMIT_H
