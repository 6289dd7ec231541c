// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PYTHON_CURVES_H
#define CONSTRICTIONS_PYTHON_CURVES_H

#include "surface.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace constrictions {

/// Where a curve runs, as arrays: the points, the face of each, and the barycentric coordinates there.
struct Located_points
{
  pybind11::object points, faces, barycentric;
};

/// The class `Constriction` of Python.
struct Surface_curve
{
  std::shared_ptr<const Surface> surface;
  Constriction curve;
  mutable Located_points located; ///< made when it is first asked for
};

/// The class `GeodesicLoop` of Python.
struct Surface_loop
{
  std::shared_ptr<const Surface> surface;
  Geodesic_loop loop;
  mutable Located_points located; ///< made when it is first asked for
};

/// The class `PlaneSection` of Python.
struct Surface_section
{
  std::shared_ptr<const Surface> surface;
  Plane_section section;
};

/// The class `TightenedCurve` of Python.
struct Tightened_loop
{
  CGAL::Surface_mesh_constrictions::Tightening_verdict verdict;
  std::shared_ptr<Surface_curve> curve; ///< null unless it is a constriction
};

/// The class `Constrictions` of Python.
struct Surface_curves
{
  std::vector<std::shared_ptr<Surface_curve>> curves;
  CGAL::Surface_mesh_constrictions::Detection_statistics statistics;
};

/// the curve that a user gives, and that is called `name` in what is thrown: a `Constriction` of the surface, or a pair
/// of arrays, the faces and the barycentric coordinates
Constriction curve_of_user(const std::shared_ptr<const Surface>& surface, const pybind11::handle& curve,
                           const std::string& name);

/// a sequence of such curves
std::vector<Constriction> curves_of_user(const std::shared_ptr<const Surface>& surface,
                                         const pybind11::iterable& curves);

/// adds the classes to the module
void define_curves(pybind11::module_& module);

} // namespace constrictions

#endif // CONSTRICTIONS_PYTHON_CURVES_H
