// SPDX-License-Identifier: GPL-3.0-or-later
#include "system/posix.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <system_error>
#include <thread>

namespace constrictions {

namespace {

const std::array<int, 3> ending_signals = {{SIGINT, SIGTERM, SIGHUP}};

volatile std::sig_atomic_t held_signal = 0, last_noted_signal = 0;
std::array<struct sigaction, ending_signals.size()> actions_before;

std::uint64_t peak_rss_bytes(const rusage& usage)
{
#ifdef __APPLE__
  const std::uint64_t unit = 1;
#else
  const std::uint64_t unit = 1024;
#endif
  return unit * static_cast<std::uint64_t>(usage.ru_maxrss);
}

template <typename F>
auto uninterrupted(F f)
{
  auto result = f();
  while(result == -1 && errno == EINTR)
    result = f();
  return result;
}

// Returns 0, or the error.
int write_all(int file, std::string_view text)
{
  while(!text.empty())
  {
    const ssize_t n = uninterrupted([&] { return write(file, text.data(), text.size()); });
    if(n < 0)
      return errno;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

// The type of RLIMIT_... differs between systems.
template <typename Resource>
void limit(Resource resource, rlim_t most)
{
  rlimit r;
  if(getrlimit(resource, &r) != 0)
    return;
  r.rlim_cur = (std::min)(most, r.rlim_max);
  setrlimit(resource, &r);
}

void die_with(pid_t parent)
{
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if(getppid() != parent)
    _exit(1);
  if(std::FILE* file = std::fopen("/proc/self/oom_score_adj", "w"))
  {
    std::fputs("1000", file);
    std::fclose(file);
  }
#else
  static_cast<void>(parent);
#endif
}

[[noreturn]] void run_in_child(const std::function<std::string()>& function, int pipe,
                               const std::optional<std::uint64_t>& bytes)
{
  for(int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    std::signal(signal, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  if(bytes)
    limit(RLIMIT_AS, *bytes);
  const int nothing = open("/dev/null", O_RDONLY);
  if(nothing != -1)
    dup2(nothing, STDIN_FILENO);
  dup2(pipe, STDOUT_FILENO);
  dup2(pipe, STDERR_FILENO);

  const std::string result = function();
  std::cout << std::flush;
  _exit(write_all(pipe, result) == 0 ? 0 : 1);
}

} // namespace

bool is_error_output_terminal() { return isatty(STDERR_FILENO) == 1; }

std::uint64_t peak_rss_bytes()
{
  rusage usage;
  return getrusage(RUSAGE_SELF, &usage) == 0 ? peak_rss_bytes(usage) : 0;
}

void fail_beyond_limit_of_file_sizes() { std::signal(SIGXFSZ, SIG_IGN); }

std::string signal_name(int signal) { return strsignal(signal); }

bool is_kill(int signal) { return signal == SIGKILL; }

Held_signals::Held_signals()
{
  held_signal = 0;
  for(std::size_t i = 0; i < ending_signals.size(); ++i)
  {
    sigaction(ending_signals[i], nullptr, &actions_before[i]);
    struct sigaction action = {};
    action.sa_handler = [](int signal) { held_signal = signal; };
    if(actions_before[i].sa_handler != SIG_IGN)
      sigaction(ending_signals[i], &action, nullptr);
  }
}

Held_signals::~Held_signals()
{
  for(std::size_t i = 0; i < ending_signals.size(); ++i)
    sigaction(ending_signals[i], &actions_before[i], nullptr);
  if(held_signal != 0)
    std::raise(held_signal);
}

void note_signals()
{
  for(int signal : ending_signals)
  {
    struct sigaction action = {};
    if(sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
      continue;
    action = {};
    action.sa_handler = [](int s) { last_noted_signal = s; };
    sigaction(signal, &action, nullptr);
  }
}

int noted_signal() { return last_noted_signal; }

void end_by_noted_signal()
{
  std::signal(last_noted_signal, SIG_DFL);
  std::raise(last_noted_signal);
}

Locked_file::~Locked_file()
{
  if(m_file != -1)
    close(m_file);
}

int Locked_file::open(const std::string& name)
{
  m_file = ::open(name.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  return m_file == -1 ? errno : 0;
}

int Locked_file::lock() const
{
  for(int attempt = 0; flock(m_file, LOCK_EX | LOCK_NB) != 0; ++attempt)
  {
    if(errno != EWOULDBLOCK || attempt == 10)
      return errno;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return 0;
}

int Locked_file::append(std::string_view text) const { return write_all(m_file, text); }

int Locked_file::shorten(std::uintmax_t size) const
{
  return ftruncate(m_file, static_cast<off_t>(size)) == 0 ? 0 : errno;
}

bool is_locked_error(int error) { return error == EWOULDBLOCK; }

Child_process start_child_process(const std::function<std::string()>& function,
                                  const std::optional<std::uint64_t>& bytes, const std::vector<Child_process>& others)
{
  std::array<int, 2> ends;
  if(pipe(ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "no pipe can be opened");
  std::cout << std::flush;
  std::cerr << std::flush;
  const pid_t parent = getpid(), process = fork();
  if(process == 0)
  {
    die_with(parent);
    close(ends[0]);
    for(const Child_process& other : others)
      close(other.pipe);
    run_in_child(function, ends[1], bytes);
  }
  const int error = errno;
  close(ends[1]);
  if(process == -1)
  {
    close(ends[0]);
    throw std::system_error(error, std::generic_category(), "no process can be started");
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {process, ends[0]};
}

void kill_child_process(const Child_process& child) { kill(child.process, SIGKILL); }

Child_process_end wait_for_end(const Child_process& child)
{
  int status = 0;
  rusage usage = {};
  uninterrupted([&] { return wait4(child.process, &status, 0, &usage); });
  close(child.pipe);
  return {WIFSIGNALED(status) ? WTERMSIG(status) : 0, peak_rss_bytes(usage)};
}

std::vector<bool> wait_for_output(const std::vector<Child_process>& children, std::chrono::milliseconds longest)
{
  std::vector<pollfd> pipes;
  for(const Child_process& child : children)
    pipes.push_back({child.pipe, POLLIN, 0});
  const int ready = poll(pipes.data(), pipes.size(), static_cast<int>(longest.count()));
  std::vector<bool> result;
  for(const pollfd& pipe : pipes)
    result.push_back(ready > 0 && pipe.revents != 0);
  return result;
}

bool read_output(const Child_process& child, const std::function<void(std::string_view)>& f)
{
  std::array<char, 1 << 16> buffer;
  while(true)
  {
    const ssize_t n = uninterrupted([&] { return read(child.pipe, buffer.data(), buffer.size()); });
    if(n < 0 && errno == EAGAIN)
      return false;
    if(n <= 0)
      return true;
    f({buffer.data(), static_cast<std::size_t>(n)});
  }
}

} // namespace constrictions
