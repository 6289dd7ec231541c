// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/stage_monitor.h"

#include <iostream>

namespace constrictions {

Stage_monitor::Stage_monitor(bool show_progress, Stage last) : m_show_progress(show_progress), m_all{last, last} {}

Stage_monitor::~Stage_monitor()
{
  if(m_is_shown)
    std::cerr << "\r\x1b[K" << std::flush;
}

void Stage_monitor::begin(Stage stage, std::size_t steps)
{
  m_begin = Clock::now();
  if(!m_has_begun)
  {
    m_has_begun = true;
    m_all.first = stage;
    m_begin_of_all = m_begin;
  }
  m_stage = stage;
  m_steps = steps;
  show(0);
}

void Stage_monitor::step(std::size_t done)
{
  if(m_steps > 0)
    show(static_cast<double>(done) / static_cast<double>(m_steps));
}

void Stage_monitor::end(Stage stage)
{
  m_seconds[static_cast<std::size_t>(stage)] += std::chrono::duration<double>(Clock::now() - m_begin).count();
}

void Stage_monitor::show(double part_of_stage)
{
  if(!m_show_progress)
    return;
  // nobody reads faster, and what takes less time needs no progress
  const double at_least = 0.5, between = 0.1;
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - m_begin_of_all).count();
  const bool shows_stage = m_is_shown && m_shown_at >= m_begin; // a stage that begins is shown at once
  if(elapsed < at_least || (shows_stage && std::chrono::duration<double>(now - m_shown_at).count() < between))
    return;
  m_is_shown = true;
  m_shown_at = now;
  // what is left of a longer line is erased
  std::cerr << '\r' << progress_line(m_all, m_stage, part_of_stage, elapsed) << "\x1b[K" << std::flush;
}

} // namespace constrictions
