// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_MONITOR_H
#define CONSTRICTIONS_PYTHON_MONITOR_H

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <vector>

namespace constrictions {

/// Thrown through a computation that is to end.
struct Stopped
{};

/// What the thread that computes and the one that waits for it tell each other: how far it is, and that it is to end.
class Monitor
{
public:
  typedef CGAL::Surface_mesh_constrictions::Detection_stage Stage;

  /// How far a stage is.
  struct Progress
  {
    Stage stage;
    std::size_t done, steps;
  };

  /// \name For the thread that computes
  /// All but `finish()` throw `Stopped` once `stop()` has been called.
  /// @{
  void begin(Stage stage, std::size_t steps);
  void step(std::size_t done);
  void check() const;
  void finish();
  /// @}

  /// \name For the thread that waits
  /// @{
  void stop() { m_is_stopped = true; }
  /// waits until the computation has ended, but no longer than the given time. Returns whether it has.
  bool wait(std::chrono::milliseconds time);
  /// for each stage that there was since the last call how far it came
  std::vector<Progress> take();
  /// @}

private:
  std::mutex m_mutex;
  std::condition_variable m_condition;
  std::vector<Progress> m_news;
  Progress m_now = {Stage::SIMPLIFICATION, 0, 0};
  bool m_is_finished = false;
  std::atomic<bool> m_is_stopped = false;
};

/// Tells a monitor what a detection does, and ends it.
struct Monitoring_visitor : public CGAL::Surface_mesh_constrictions::Detection_visitor_base
{
  typedef CGAL::Surface_mesh_constrictions::Detection_stage Stage;

  Monitoring_visitor(Monitor& monitor, CGAL::Surface_mesh_constrictions::Detection_statistics& statistics)
    : monitor(&monitor), statistics(&statistics)
  {}

  void on_stage_begin(Stage stage, std::size_t steps) const { monitor->begin(stage, steps); }
  void on_step(Stage, std::size_t done) const { monitor->step(done); }
  void on_stage_end(Stage) const { monitor->check(); }
  void on_end(const CGAL::Surface_mesh_constrictions::Detection_statistics& s) const { *statistics = s; }

  Monitor* monitor;
  CGAL::Surface_mesh_constrictions::Detection_statistics* statistics;
};

/// computes without the lock of the interpreter, on a thread of its own, and waits. So the thread that called handles
/// signals, and calls `progress`, if it is not None, whichever thread of the computation does a step. What a handler of
/// signals or `progress` throws ends the computation at its next step, and is thrown then.
void compute(const pybind11::object& progress, const std::function<void(Monitor&)>& computation);

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_MONITOR_H
