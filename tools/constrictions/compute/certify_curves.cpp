// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <cstddef>

namespace constrictions {

std::vector<Certified_curve> certify_curves(const Mesh& mesh, const Curves& curves, Stage_monitor& monitor)
{
  using namespace CGAL::Surface_mesh_constrictions;

  std::vector<Certified_curve> result;
  monitor.begin(Detection_stage::CERTIFICATION, curves.curves.size());
  for(std::size_t i = 0; i < curves.curves.size(); ++i)
  {
    const auto& curve = curves.curves[i];
    result.push_back({curves.ids[i], curve.length(), certify_constriction(mesh, curve)});
    monitor.step(i + 1);
  }
  monitor.end(Detection_stage::CERTIFICATION);
  return result;
}

} // namespace constrictions
