// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_STAGE_MONITOR_H
#define CONSTRICTIONS_STAGE_MONITOR_H

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <memory>

namespace boost {
namespace timer {
class progress_display;
} // namespace timer
} // namespace boost

namespace constrictions {

/// Takes the time of the stages of a computation and shows their progress.
class Stage_monitor
{
public:
  typedef CGAL::Surface_mesh_constrictions::Detection_stage Stage;

  /// \param show_progress whether to draw a bar for each stage on the standard error output
  explicit Stage_monitor(bool show_progress);
  ~Stage_monitor();

  void begin(Stage stage, std::size_t steps);
  void step(std::size_t done);
  void end(Stage stage);

  double seconds(Stage stage) const { return m_seconds[static_cast<std::size_t>(stage)]; }

  CGAL::Surface_mesh_constrictions::Detection_statistics statistics;

private:
  bool m_show_progress;
  std::unique_ptr<boost::timer::progress_display> m_bar;
  std::chrono::steady_clock::time_point m_begin;
  std::array<double, 6> m_seconds = {0, 0, 0, 0, 0, 0};
};

/// Tells a monitor what `detect_constrictions()` does.
struct Monitoring_visitor : public CGAL::Surface_mesh_constrictions::Detection_visitor_base
{
  typedef CGAL::Surface_mesh_constrictions::Detection_stage Stage;

  explicit Monitoring_visitor(Stage_monitor& monitor) : monitor(&monitor) {}

  void on_stage_begin(Stage stage, std::size_t steps) const { monitor->begin(stage, steps); }
  void on_step(Stage, std::size_t done) const { monitor->step(done); }
  void on_stage_end(Stage stage) const { monitor->end(stage); }
  void on_end(const CGAL::Surface_mesh_constrictions::Detection_statistics& s) const { monitor->statistics = s; }

  Stage_monitor* monitor;
};

} // namespace constrictions

#endif // CONSTRICTIONS_STAGE_MONITOR_H
