// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_STAGE_MONITOR_H
#define CONSTRICTIONS_STAGE_MONITOR_H

#include "output/progress_line.h"

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>

#include <array>
#include <chrono>
#include <cstddef>

namespace constrictions {

/// Takes the time of the stages of a computation and shows their progress.
class Stage_monitor
{
public:
  typedef CGAL::Surface_mesh_constrictions::Detection_stage Stage;

  /// \param show_progress whether to show a line on the standard error output: the stage, how much of the whole is done,
  ///   and how long the rest will take, which is guessed. When this is destroyed the line is erased.
  /// \param last the stage that ends the whole
  explicit Stage_monitor(bool show_progress, Stage last = Stage::SELECTION);
  ~Stage_monitor();

  void begin(Stage stage, std::size_t steps);
  void step(std::size_t done);
  void end(Stage stage);

  double seconds(Stage stage) const { return m_seconds[static_cast<std::size_t>(stage)]; }

  CGAL::Surface_mesh_constrictions::Detection_statistics statistics;

private:
  typedef std::chrono::steady_clock Clock;

  void show(double part_of_stage);

  bool m_show_progress, m_is_shown = false, m_has_begun = false;
  Stages m_all;
  Stage m_stage = Stage::SIMPLIFICATION;
  std::size_t m_steps = 0;
  Clock::time_point m_begin_of_all, m_begin, m_shown_at;
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
