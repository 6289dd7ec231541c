// SPDX-License-Identifier: GPL-3.0-or-later
#include "include/detect.h"
#include "include/real_meshes.h"
#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Crossed_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/Curves_on_copy.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

namespace test_crossed_curves {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::internal::Trace_point;
using test_meshes::Mesh;
typedef std::vector<std::vector<Trace_point>> Traces;

// For each curve the earlier ones that it crosses there and back.
std::vector<std::vector<SMC::Index>> crossings(const SMC::Progressive_mesh& pm, const Traces& traces)
{
  SMC::internal::Crossed_curves crossed(pm);
  std::vector<std::vector<SMC::Index>> result;
  for(const std::vector<Trace_point>& t : traces)
  {
    result.push_back(crossed.crossed_by(t));
    crossed.add(t);
  }
  return result;
}

// Many curves of these meshes share pivots, where they touch or cross.
TEST(CrossedCurves, TheDirectionsOfCurvesDoNotMatter)
{
  for(const char* name : {"eight.off", "pig.off"})
  {
    const Mesh mesh = real_meshes::read(name);
    const std::vector<SMC::Constriction<Mesh>> curves = detection::detect_all(mesh);
    const auto points = get(CGAL::vertex_point, mesh);
    const auto numbers = get(boost::vertex_index, mesh);
    typedef SMC::internal::Imported_mesh<Mesh> Imported;
    Imported imported(mesh, points, numbers);
    const SMC::Progressive_mesh pm(imported.table, imported.points);
    Traces traces = SMC::internal::curves_on_copy(curves, imported, numbers, pm).traces;
    const std::vector<std::vector<SMC::Index>> expected = crossings(pm, traces);
    std::size_t number = 0;
    for(const std::vector<SMC::Index>& e : expected)
      number += e.size();
    EXPECT_GE(number, 5u) << name;
    std::mt19937 random(1);
    for(int i = 0; i < 4; ++i)
    {
      for(std::vector<Trace_point>& t : traces)
        if(random() % 2 == 0)
          t = SMC::internal::reversed(pm, t);
      EXPECT_EQ(crossings(pm, traces), expected) << name;
    }
  }
}

} // namespace test_crossed_curves
