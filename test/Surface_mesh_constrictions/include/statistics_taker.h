// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef STATISTICS_TAKER_H
#define STATISTICS_TAKER_H

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>

namespace statistics_taker {

// A visitor that takes the statistics of a detection.
struct Statistics_taker : public CGAL::Surface_mesh_constrictions::Detection_visitor_base
{
  typedef CGAL::Surface_mesh_constrictions::Detection_statistics Statistics;

  Statistics* statistics;
  explicit Statistics_taker(Statistics& s) : statistics(&s) {}
  void on_end(const Statistics& s) const { *statistics = s; }
};

} // namespace statistics_taker

#endif // STATISTICS_TAKER_H
