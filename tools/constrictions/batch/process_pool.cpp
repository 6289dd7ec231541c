// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/process_pool.h"

#include <fcntl.h>
#include <poll.h>
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
#include <cstdio>
#include <iostream>
#include <string_view>
#include <system_error>
#include <utility>

namespace constrictions {

namespace {

// What a child sends is what libraries may print, and then its result: this character, the text, the end of the line
// (RFC 7464).
const char record_separator = '\x1e';

// Output without a result that is kept, from its end.
const std::size_t longest_output = std::size_t(1) << 16;

template <typename F>
auto uninterrupted(F f)
{
  auto result = f();
  while(result == -1 && errno == EINTR)
    result = f();
  return result;
}

void write_all(int file, std::string_view text)
{
  while(!text.empty())
  {
    const ssize_t n = uninterrupted([&] { return write(file, text.data(), text.size()); });
    if(n < 0)
      _exit(1);
    text.remove_prefix(static_cast<std::size_t>(n));
  }
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

[[noreturn]] void run_in_child(const std::function<std::string()>& function, int pipe, const Process_limits& limits)
{
  for(int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    std::signal(signal, SIG_IGN);
  limit(RLIMIT_CORE, 0);
  if(limits.bytes)
    limit(RLIMIT_AS, *limits.bytes);
  const int nothing = open("/dev/null", O_RDONLY);
  if(nothing != -1)
    dup2(nothing, STDIN_FILENO);
  dup2(pipe, STDOUT_FILENO);
  dup2(pipe, STDERR_FILENO);

  const std::string result = function();
  std::cout << std::flush;
  write_all(pipe, record_separator + result + '\n');
  _exit(0);
}

std::string last_line(const std::string& text)
{
  const std::size_t end = text.find_last_not_of('\n');
  if(end == std::string::npos)
    return "";
  const std::size_t newline = text.find_last_of('\n', end);
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  return text.substr(begin, end + 1 - begin);
}

} // namespace

Process_pool::~Process_pool()
{
  for(const Child& child : m_children)
    kill(child.process, SIGKILL);
  for(Child& child : m_children)
    reap(child);
}

void Process_pool::start(std::size_t task, const std::function<std::string()>& function)
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
    for(const Child& child : m_children)
      close(child.pipe);
    run_in_child(function, ends[1], m_limits);
  }
  const int error = errno;
  close(ends[1]);
  if(process == -1)
  {
    close(ends[0]);
    throw std::system_error(error, std::generic_category(), "no process can be started");
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  m_children.push_back({task, process, ends[0], Clock::now(), std::string(), false});
}

void Process_pool::kill_overdue()
{
  const Clock::time_point now = Clock::now();
  for(Child& child : m_children)
    if(!child.is_out_of_time && std::chrono::duration<double>(now - child.begin).count() >= m_limits.seconds)
    {
      kill(child.process, SIGKILL);
      child.is_out_of_time = true;
    }
}

bool Process_pool::is_read_to_the_end(Child& child) const
{
  std::array<char, 1 << 16> buffer;
  while(true)
  {
    const ssize_t n = uninterrupted([&] { return read(child.pipe, buffer.data(), buffer.size()); });
    if(n < 0 && errno == EAGAIN)
      return false;
    if(n <= 0)
      return true;
    child.output.append(buffer.data(), static_cast<std::size_t>(n));
    if(child.output.size() > 2 * longest_output && child.output.find(record_separator) == std::string::npos)
      child.output.erase(0, child.output.size() - longest_output);
  }
}

Task_end Process_pool::reap(Child& child) const
{
  int status = 0;
  rusage usage = {};
  uninterrupted([&] { return wait4(child.process, &status, 0, &usage); });
  close(child.pipe);

  Task_end end;
  end.task = child.task;
  end.seconds = std::chrono::duration<double>(Clock::now() - child.begin).count();
#ifdef __APPLE__
  const std::uint64_t unit = 1;
#else
  const std::uint64_t unit = 1024;
#endif
  end.peak_rss_bytes = unit * static_cast<std::uint64_t>(usage.ru_maxrss);
  const std::size_t separator = child.output.rfind(record_separator);
  if(separator != std::string::npos && child.output.back() == '\n')
    end.result = child.output.substr(separator + 1, child.output.size() - separator - 2);
  else
  {
    end.is_out_of_time = child.is_out_of_time;
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.last_words = last_line(child.output);
  }
  return end;
}

std::vector<Task_end> Process_pool::wait(std::chrono::milliseconds longest)
{
  Clock::duration timeout = longest;
  std::vector<pollfd> pipes;
  for(const Child& child : m_children)
  {
    pipes.push_back({child.pipe, POLLIN, 0});
    const double left = m_limits.seconds - std::chrono::duration<double>(Clock::now() - child.begin).count();
    if(!child.is_out_of_time && left < std::chrono::duration<double>(timeout).count())
      timeout = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>((std::max)(left, 0.)));
  }
  // rounded up, so that what is waited for has come
  const auto milliseconds = std::chrono::ceil<std::chrono::milliseconds>(timeout).count();
  const int ready = poll(pipes.data(), pipes.size(), static_cast<int>(milliseconds));
  kill_overdue();

  std::vector<Task_end> ended;
  for(std::size_t i = pipes.size(); ready > 0 && i-- > 0;)
    if(pipes[i].revents != 0 && is_read_to_the_end(m_children[i]))
    {
      ended.push_back(reap(m_children[i]));
      m_children.erase(m_children.begin() + static_cast<std::ptrdiff_t>(i));
    }
  return ended;
}

} // namespace constrictions
