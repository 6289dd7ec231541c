// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_LABEL_BORDERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_LABEL_BORDERS_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Split_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_splitter.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Labels_beside_arc.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

struct Border_splitting_parameters : Point_parameters::With<internal_np::edge_is_constrained_t, internal_np::visitor_t>
{};

// What `split_along_label_borders()` does with arguments of the right kind.
template <class TriangleMesh, class BorderRange, class NamedParameters>
Split_curves<TriangleMesh> split_along_label_borders_checked(TriangleMesh& tm, const BorderRange& borders,
                                                             const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// splits the faces of a mesh so that the borders that `tighten_label_borders()` has tightened run along its edges, and
/// marks these. `extract_parts()` then makes a closed mesh of each part. How faces are split is said of
/// `split_along_constrictions()`.
///
/// Edges along which the same label is on both sides, as nothing is left between borders that lie on each other, are
/// not marked.
///
/// \tparam TriangleMesh a model of `MutableFaceGraph`
/// \tparam BorderRange a range of `Label_border`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm the mesh on which the borders were tightened; the borders do not fit it any more afterwards
/// \param borders of which the locations and the labels count
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadWritePropertyMap` whose value type is a 3D point of a CGAL kernel}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{the edges of the borders are put to `true`. The pieces of an edge get what the edge had,
///                           new edges inside of faces `false`.}
///     \cgalParamType{a class model of `ReadWritePropertyMap` with the edges of `tm` as key type and `bool` as value
///                    type}
///     \cgalParamDefault{edges are not marked}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told which faces and edges are split, and into what}
///     \cgalParamType{a model of `ConstrictionSplitVisitor`; it is copied}
///     \cgalParamDefault{`Split_visitor_base<TriangleMesh>`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return for each border the halfedges along it, and whether the mesh was split along it: that it was not if it is
///         gone
/// \throws Invalid_input for a border that is no sequence of locations on triangles of `tm`, which is then not changed
/// \cost that of `split_along_constrictions()`
template <class TriangleMesh, class BorderRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
Split_curves<TriangleMesh> split_along_label_borders(TriangleMesh& tm, const BorderRange& borders,
                                                     const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Border_splitting_parameters, NamedParameters>();
  if constexpr(internal::check_mutable_mesh<TriangleMesh>() && knows_all)
    return internal::split_along_label_borders_checked(tm, borders, np);
  else
    return internal::no_result<Split_curves<TriangleMesh>>();
}

namespace internal {

template <class TriangleMesh, class BorderRange, class NamedParameters>
Split_curves<TriangleMesh> split_along_label_borders_checked(TriangleMesh& tm, const BorderRange& borders,
                                                             const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(CGAL::vertex_point, tm));
  const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Split_visitor_base<TriangleMesh>());
  auto mark = edge_mark<TriangleMesh>(np);

  Curve_arrangement<TriangleMesh> arrangement(tm);
  Split_curves<TriangleMesh> result;
  for(const auto& border : borders)
  {
    const std::size_t number = result.outcomes.size();
    std::optional<std::size_t> crossed;
    if(!border.locations.empty())
      crossed = arrangement.insert(border.locations, number, border.is_closed);
    result.outcomes.push_back({!border.locations.empty() && !crossed, crossed.value_or(Cut_outcome::none)});
  }
  Curve_splitter splitter(tm, arrangement, vpm, mark, visitor);
  splitter.split();
  result.halfedges.resize(result.outcomes.size());
  for(std::size_t c = 0; c < arrangement.number_of_curves(); ++c)
    result.halfedges[arrangement.curve_number(c)] = splitter.halfedges(c);

  // what the borders along an edge name on its two sides
  typedef std::decay_t<decltype(borders.begin()->labels[0])> Label;
  std::map<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, Labels_beside_arc<Label>> beside;
  std::size_t number = 0;
  for(const auto& border : borders)
  {
    for(auto h : result.halfedges[number])
    {
      const auto o = opposite(h, tm);
      if(h < o)
        beside[h].add(border.labels[0], border.labels[1]);
      else
        beside[o].add(border.labels[1], border.labels[0]);
    }
    ++number;
  }
  for(const auto& [h, labels] : beside)
    if(labels.is_no_border())
      mark.mark(edge(h, tm), false);
  return result;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SPLIT_ALONG_LABEL_BORDERS_H
