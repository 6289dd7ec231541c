// SPDX-License-Identifier: GPL-3.0-or-later
#include "monitor.h"

#include "names.h"

#include <exception>
#include <thread>

namespace constrictions {

namespace py = pybind11;

void Monitor::begin(Stage stage, std::size_t steps)
{
  check();
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_now = {stage, 0, steps};
  m_news.push_back(m_now);
}

void Monitor::step(std::size_t done)
{
  check();
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_now.done = done;
  if(!m_news.empty())
    m_news.back() = m_now;
  else
    m_news.push_back(m_now);
}

void Monitor::check() const
{
  if(m_is_stopped)
    throw Stopped();
}

void Monitor::finish()
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_is_finished = true;
  m_condition.notify_all();
}

bool Monitor::wait(std::chrono::milliseconds time)
{
  std::unique_lock<std::mutex> lock(m_mutex);
  return m_condition.wait_for(lock, time, [this] { return m_is_finished; });
}

std::vector<Monitor::Progress> Monitor::take()
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  std::vector<Progress> result;
  result.swap(m_news);
  return result;
}

void compute(const py::object& progress, const std::function<void(Monitor&)>& computation)
{
  if(!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("progress can not be called");
  Monitor monitor;
  std::exception_ptr failure, interruption;
  std::thread thread([&] {
    try
    {
      computation(monitor);
    }
    catch(const Stopped&)
    {}
    catch(...)
    {
      failure = std::current_exception();
    }
    monitor.finish();
  });

  const std::chrono::milliseconds between_reports(50);
  bool is_finished = false;
  try
  {
    while(!is_finished)
    {
      {
        const py::gil_scoped_release without_lock;
        is_finished = monitor.wait(between_reports);
      }
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      for(const Monitor::Progress& p : monitor.take())
        if(!progress.is_none())
          progress(name_of(p.stage), p.done, p.steps);
    }
  }
  catch(...)
  {
    monitor.stop();
    interruption = std::current_exception();
  }
  {
    const py::gil_scoped_release without_lock;
    thread.join();
  }
  if(interruption)
    std::rethrow_exception(interruption);
  if(failure)
    std::rethrow_exception(failure);
}

} // namespace constrictions
