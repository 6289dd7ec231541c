// SPDX-License-Identifier: GPL-3.0-or-later
// What the program asks of the operating system beyond the standard library of C++: a terminal, memory, signals, locked
// files, child processes. No other file of the program includes a header of POSIX.
#ifndef CONSTRICTIONS_POSIX_H
#define CONSTRICTIONS_POSIX_H

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace constrictions {

/// whether what is printed on the standard error output is read on a terminal.
bool is_error_output_terminal();

/// the most memory that this process has used so far, in bytes; 0 if it is not known.
std::uint64_t peak_rss_bytes();

/// from now on writing beyond the limit of file sizes fails, and does not end this process.
void fail_beyond_limit_of_file_sizes();

/// the name of a signal, such as `Segmentation fault`.
std::string signal_name(int signal);

/// whether `signal` is the one that no process can catch, which the system sends, for example, when memory is used up.
bool is_kill(int signal);

/// While an object of this class lives, SIGINT, SIGTERM and SIGHUP wait; after that they do what they did before. No
/// two objects live at a time.
class Held_signals
{
public:
  Held_signals();
  ~Held_signals();
  Held_signals(const Held_signals&) = delete;
  Held_signals& operator=(const Held_signals&) = delete;
};

/// from now on SIGINT, SIGTERM and SIGHUP are only noted. A signal that is ignored, as under nohup, remains ignored.
void note_signals();

/// the last signal that was noted, or 0.
int noted_signal();

/// ends this process as the noted signal would have.
void end_by_noted_signal();

/// A file that only one process at a time writes to, of those that open it with this class. The functions return 0, or
/// an error as in `errno`.
class Locked_file
{
public:
  Locked_file() = default;
  Locked_file(const Locked_file&) = delete;
  Locked_file& operator=(const Locked_file&) = delete;
  /// closes it.
  ~Locked_file();

  /// opens a file to append to, which is created if missing.
  int open(const std::string& name);

  /// locks the file. Tries for a second, as a process that was just killed may take a moment to end. See
  /// `is_locked_error()`.
  int lock() const;

  int append(std::string_view text) const;
  int shorten(std::uintmax_t size) const;

private:
  int m_file = -1;
};

/// whether an error of `Locked_file::lock()` says that another process has locked the file.
bool is_locked_error(int error);

/// A process that runs a function, and the pipe from which all that it prints is read.
struct Child_process
{
  int process;
  int pipe;
};

struct Child_process_end
{
  int signal; ///< the one that has ended the process, or 0
  std::uint64_t peak_rss_bytes;
};

/// starts a child, a copy of this process, which runs `function`, sends the text that `function` returns, and ends.
/// `function` must not throw. The child has no standard input, dumps no core, may have at most `bytes` of address
/// space, and closes the pipes of `others`. It takes no notice of SIGINT, SIGTERM, SIGHUP and SIGQUIT: a terminal sends
/// these signals to all processes, but it is for this process to end its children. On Linux the child ends when this
/// process ends, for whatever reason, and is the first to be killed when the memory is used up. Throws
/// `std::system_error` if no process can be started.
Child_process start_child_process(const std::function<std::string()>& function,
                                  const std::optional<std::uint64_t>& bytes, const std::vector<Child_process>& others);

void kill_child_process(const Child_process& child);

/// waits until the child has ended, and closes the pipe.
Child_process_end wait_for_end(const Child_process& child);

/// waits until there is something to read from one of the children, a child has ended, a signal is caught, or the time
/// is over. Returns for each child whether there is something to read or it has ended.
std::vector<bool> wait_for_output(const std::vector<Child_process>& children, std::chrono::milliseconds longest);

/// calls `f` with what can be read at the moment, piece by piece. Returns whether no more will come.
bool read_output(const Child_process& child, const std::function<void(std::string_view)>& f);

} // namespace constrictions

#endif // CONSTRICTIONS_POSIX_H
