// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL's edge profile, which does not include all that it calls, before any header of this package.

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_profile.h>

#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <vector>

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;

std::vector<Constriction> constrictions_of(const Mesh& mesh);

std::vector<Constriction> constrictions_of(const Mesh& mesh)
{
  std::vector<Constriction> result;
  CGAL::Surface_mesh_constrictions::detect_constrictions(mesh, std::back_inserter(result));
  return result;
}
