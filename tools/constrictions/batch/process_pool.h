// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PROCESS_POOL_H
#define CONSTRICTIONS_PROCESS_POOL_H

#include "system/posix.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

struct Process_limits
{
  std::size_t processes = 1;                                ///< at a time
  double seconds = std::numeric_limits<double>::infinity(); ///< wall time of each
  std::optional<std::uint64_t> bytes;                       ///< address space of each
};

/// How a task has ended.
struct Task_end
{
  std::size_t task;
  std::optional<std::string> result; ///< what it returned; nothing if its process has ended before
  bool is_out_of_time = false;       ///< its process has been killed
  int signal = 0;                    ///< that has ended its process, or 0
  std::string last_words;            ///< the last line that a process without a result has printed
  double seconds = 0;
  std::uint64_t peak_rss_bytes = 0;
};

/// Runs tasks in child processes, a process for each, so that what happens to one task is nothing to the others and to
/// this process: a crash, a lack of memory, an endless loop. A child is a copy of this process, which should have one
/// thread, and small memory, when it starts one; see `start_child_process()`.
class Process_pool
{
public:
  explicit Process_pool(const Process_limits& limits) : m_limits(limits) {}
  Process_pool(const Process_pool&) = delete;
  Process_pool& operator=(const Process_pool&) = delete;
  /// kills what is still running.
  ~Process_pool();

  bool is_full() const { return m_children.size() >= m_limits.processes; }
  bool is_empty() const { return m_children.empty(); }

  /// calls `function` in a child process. It must not throw. Throws `std::system_error` if no process can be started.
  void start(std::size_t task, const std::function<std::string()>& function);

  /// waits until a task ends, a signal is caught, or the time is over. Returns the tasks that have ended.
  std::vector<Task_end> wait(std::chrono::milliseconds longest);

private:
  typedef std::chrono::steady_clock Clock;

  struct Child
  {
    std::size_t task;
    Child_process process;
    Clock::time_point begin;
    std::string output;
    bool is_out_of_time;
  };

  void kill_overdue();
  static bool is_read_to_the_end(Child& child);
  static Task_end reap(const Child& child);
  std::vector<Child_process> processes() const;

  Process_limits m_limits;
  std::vector<Child> m_children;
};

} // namespace constrictions

#endif // CONSTRICTIONS_PROCESS_POOL_H
