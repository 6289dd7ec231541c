// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/stage_monitor.h"

#include <boost/timer/progress_display.hpp>

#include <algorithm>
#include <iostream>

namespace constrictions {

Stage_monitor::Stage_monitor(bool show_progress) : m_show_progress(show_progress) {}

Stage_monitor::~Stage_monitor()
{
  // a message about what ended the computation starts on a line of its own
  if(m_bar != nullptr && m_bar->count() < m_bar->expected_count())
    std::cerr << std::endl;
}

void Stage_monitor::begin(Stage stage, std::size_t steps)
{
  static const char* const titles[] = {"Simplification\n", "Seeds\n",         "Refinement\n",
                                       "Tightening\n",     "Certification\n", "Selection\n"};
  m_begin = std::chrono::steady_clock::now();
  if(m_show_progress && steps > 0)
    m_bar = std::make_unique<boost::timer::progress_display>(steps, std::cerr, titles[static_cast<std::size_t>(stage)]);
}

void Stage_monitor::step(std::size_t done)
{
  if(m_bar == nullptr)
    return;
  const unsigned long reached = (std::min)(static_cast<unsigned long>(done), m_bar->expected_count());
  if(reached > m_bar->count())
    *m_bar += reached - m_bar->count();
}

void Stage_monitor::end(Stage stage)
{
  // fewer steps than expected are no failure
  if(m_bar != nullptr)
    step(m_bar->expected_count());
  m_bar.reset();
  m_seconds[static_cast<std::size_t>(stage)] +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
}

} // namespace constrictions
