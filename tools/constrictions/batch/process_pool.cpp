// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/process_pool.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace constrictions {

namespace {

// What a child sends is what libraries may print, and then its result: this character, the text, the end of the line
// (RFC 7464).
const char record_separator = '\x1e';

// Output without a result that is kept, from its end.
const std::size_t longest_output = std::size_t(1) << 16;

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
    kill_child_process(child.process);
  for(const Child& child : m_children)
    wait_for_end(child.process);
}

std::vector<Child_process> Process_pool::processes() const
{
  std::vector<Child_process> result;
  for(const Child& child : m_children)
    result.push_back(child.process);
  return result;
}

void Process_pool::start(std::size_t task, const std::function<std::string()>& function)
{
  const Child_process process =
      start_child_process([&] { return record_separator + function() + '\n'; }, m_limits.bytes, processes());
  m_children.push_back({task, process, Clock::now(), std::string(), false});
}

void Process_pool::kill_overdue()
{
  const Clock::time_point now = Clock::now();
  for(Child& child : m_children)
    if(!child.is_out_of_time && std::chrono::duration<double>(now - child.begin).count() >= m_limits.seconds)
    {
      kill_child_process(child.process);
      child.is_out_of_time = true;
    }
}

bool Process_pool::is_read_to_the_end(Child& child)
{
  return read_output(child.process, [&](std::string_view text) {
    child.output.append(text);
    if(child.output.size() > 2 * longest_output && child.output.find(record_separator) == std::string::npos)
      child.output.erase(0, child.output.size() - longest_output);
  });
}

Task_end Process_pool::reap(const Child& child)
{
  const Child_process_end process_end = wait_for_end(child.process);
  Task_end end;
  end.task = child.task;
  end.seconds = std::chrono::duration<double>(Clock::now() - child.begin).count();
  end.peak_rss_bytes = process_end.peak_rss_bytes;
  const std::size_t separator = child.output.rfind(record_separator);
  if(separator != std::string::npos && child.output.back() == '\n')
    end.result = child.output.substr(separator + 1, child.output.size() - separator - 2);
  else
  {
    end.is_out_of_time = child.is_out_of_time;
    end.signal = process_end.signal;
    end.last_words = last_line(child.output);
  }
  return end;
}

std::vector<Task_end> Process_pool::wait(std::chrono::milliseconds longest)
{
  Clock::duration timeout = longest;
  for(const Child& child : m_children)
  {
    const double left = m_limits.seconds - std::chrono::duration<double>(Clock::now() - child.begin).count();
    if(!child.is_out_of_time && left < std::chrono::duration<double>(timeout).count())
      timeout = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>((std::max)(left, 0.)));
  }
  // rounded up, so that what is waited for has come
  const std::vector<bool> is_ready =
      wait_for_output(processes(), std::chrono::ceil<std::chrono::milliseconds>(timeout));
  kill_overdue();

  std::vector<Task_end> ended;
  for(std::size_t i = is_ready.size(); i-- > 0;)
    if(is_ready[i] && is_read_to_the_end(m_children[i]))
    {
      ended.push_back(reap(m_children[i]));
      m_children.erase(m_children.begin() + static_cast<std::ptrdiff_t>(i));
    }
  return ended;
}

} // namespace constrictions
