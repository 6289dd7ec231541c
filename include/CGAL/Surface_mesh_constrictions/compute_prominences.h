// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/Trace.h>
#include <CGAL/Surface_mesh_constrictions/internal/curves/crossings_of_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/prominence/prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Gives constrictions of T^0, of which these are the traces, their prominences, and which of the others they cross.
template <class TriangleMesh>
void set_prominences(const Progressive_mesh& pm, const std::vector<std::vector<Trace_point> >& traces,
                     const std::vector<Prominence>& p, std::vector<Constriction<TriangleMesh> >& constrictions)
{
  typedef typename Constriction<TriangleMesh>::Data Data;
  std::vector<Data> data;
  std::vector<Index> not_separating; // by length
  std::vector<double> lengths;
  for(const Constriction<TriangleMesh>& c : constrictions)
  {
    data.push_back(c.data());
    lengths.push_back(c.length());
  }
  for(std::size_t i = 0; i < data.size(); ++i)
  {
    data[i].prominence = p[i].value;
    data[i].dominated_by.reset();
    if(p[i].dominated_by != null_index)
      data[i].dominated_by = p[i].dominated_by;
    data[i].crosses.assign(p[i].crosses.begin(), p[i].crosses.end());
    data[i].crosses_oddly.clear();
  }
  std::vector<std::vector<Trace_point> > their_traces;
  for(Index i : by_length(lengths))
    if(!data[i].separating && p[i].value >= negligible_prominence)
    {
      not_separating.push_back(i);
      their_traces.push_back(traces[i]);
    }
  const Earlier_curves odd = odd_crossings(pm, their_traces), in_faces = crossings_in_faces(pm, their_traces);
  for(std::size_t i = 0; i < odd.size(); ++i)
  {
    Data& d = data[not_separating[i]];
    for(Index j : odd[i])
      d.crosses_oddly.push_back(not_separating[j]);
    for(Index j : in_faces[i])
      if(!std::binary_search(odd[i].begin(), odd[i].end(), j) &&
         std::find(d.crosses.begin(), d.crosses.end(), not_separating[j]) == d.crosses.end())
        d.crosses.push_back(not_separating[j]);
  }
  for(std::size_t i = 0; i < data.size(); ++i)
    constrictions[i] = Constriction<TriangleMesh>(std::move(data[i]));
}

// The points of constrictions of a mesh on its copy.
template <class TriangleMesh, class VertexIndexMap>
std::vector<std::vector<Trace_point> > traces_of(const std::vector<Constriction<TriangleMesh> >& constrictions,
                                                 const Imported_mesh<TriangleMesh>& imported, VertexIndexMap vim,
                                                 const Progressive_mesh& pm)
{
  std::unordered_map<std::size_t, Index> index;
  for(Index v = 0; v < imported.number_of_vertices(); ++v)
    index.emplace(get(vim, imported.vertex(v)), v);
  const TriangleMesh& tm = imported.mesh();
  std::vector<std::vector<Trace_point> > traces;
  for(const Constriction<TriangleMesh>& c : constrictions)
  {
    std::vector<Trace_point> trace;
    for(const auto& l : c.locations())
      if(l.is_pivot)
        trace.push_back({index.at(get(vim, l.vertex)), null_index, 0});
      else
        trace.push_back({null_index,
                         pm.halfedge(index.at(get(vim, source(l.halfedge, tm))),
                                     index.at(get(vim, target(l.halfedge, tm)))),
                         l.parameter});
    traces.push_back(std::move(trace));
  }
  return traces;
}

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// computes the prominence of each of a set of constrictions, and which other one it slides to.
///
/// As for mountain passes, the prominence of a closed geodesic says how much longer it must become before it can slide
/// to where it is shorter: to a shorter constriction of the set, to one that is not in the set, or off over a point. It
/// is \f$b/L - 1\f$, where *L* is the length of the curve and *b* its lowest *barrier*: the greatest length on the way.
///
/// From the curve both sides are swept by the level sets of the distance to it, each a set of closed curves. The
/// barrier of a side is the greatest length of its level sets until they are shorter than *L*; or until a shorter
/// constriction has been swept over at which the sweep, if it stops there, leaves no more than *L* in total. The side
/// whose barrier is lower so far is swept on, and nothing is swept that is higher than the lowest barrier. From a
/// curve that does not separate the sweep goes on until its sides meet. Where the curve slides to another
/// constriction of the set, the way through the curves at which the distances to the two are in a fixed proportion is
/// measured, too, and the lower barrier counts: around a bend of a tube these curves turn with the tube.
///
/// This is an upper bound of the least barrier over all ways on which the curve may split into several. Both kinds of
/// curves are zero sets of functions that are linear in each face, so they are closed polygons on the mesh, whose
/// lengths are measured exactly but for rounding: the bound holds whatever the error of the distances, which come
/// from fast marching and are right to first order in the size of the faces. The lengths are sampled, at 256 level
/// sets on the first stretch of length *L*, and at 31 curves between two constrictions.
///
/// The constrictions and the barriers between them are a hierarchy: from one to the one that it slides to lengths do
/// not grow, so that following `Constriction::dominated_by()` ends. Constrictions of a prominence below 0.01 dominate
/// none.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam OutputIterator takes `Constriction<TriangleMesh>`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param constrictions constrictions of `tm`, as computed on it with the same points
/// \param out the same constrictions in the same order, with `Constriction::prominence()`,
///        `Constriction::dominated_by()`, `Constriction::crosses()` and `Constriction::crosses_oddly()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the output iterator, past the last element that was written
/// \throws Invalid_input for a mesh that cannot be used
/// \cost linear in the size of the mesh, plus, for each curve, O(m log m) for the m faces that are swept
///
/// \sa `select_constrictions()`
template <class TriangleMesh, class ConstrictionRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
OutputIterator compute_prominences(const TriangleMesh& tm, const ConstrictionRange& constrictions, OutputIterator out,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);

  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const Progressive_mesh pm(std::move(imported.table), std::move(imported.points));
  std::vector<Constriction<TriangleMesh> > result(constrictions.begin(), constrictions.end());
  const std::vector<std::vector<internal::Trace_point> > traces = internal::traces_of(result, imported, vim, pm);
  internal::set_prominences(pm, traces, internal::prominences(pm, traces, nullptr), result);
  return std::move(result.begin(), result.end(), out);
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_COMPUTE_PROMINENCES_H
