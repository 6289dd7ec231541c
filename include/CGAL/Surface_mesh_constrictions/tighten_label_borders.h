// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_LABEL_BORDERS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_LABEL_BORDERS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Label_border.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Label_border_tightener.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <iterator>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

struct Label_border_parameters : Mesh_parameters::With<internal_np::certify_t>
{};

// The labels of a map from faces.
template <class FaceLabelMap>
using Label_of_map = std::decay_t<typename boost::property_traits<FaceLabelMap>::value_type>;

// What `tighten_label_borders()` does with arguments of the right kind.
template <class TriangleMesh, class FaceLabelMap, class NewFaceLabelMap, class NamedParameters>
Tightened_labels<TriangleMesh, Label_of_map<FaceLabelMap>>
tighten_label_borders_checked(const TriangleMesh& tm, FaceLabelMap labels, NewFaceLabelMap new_labels,
                              const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// tightens the borders between the labels of faces, such as a learned or a hand-made segmentation has, and labels the
/// faces anew. The mesh is not changed.
///
/// A border lies between the faces of two labels. It is closed, or it is held at both ends: at vertices where three
/// labels meet, and where it ends on the rim of a hole. Where faces of two labels alternate around a vertex those of
/// the greater label are taken not to hang together there.
///
/// A closed border is tightened as by `tighten_closed_curve()`, until it is a constriction, or degenerate. One that is
/// held becomes a geodesic between its ends: straight in the planar unfolding of the faces that it crosses, with side
/// angles of at least pi at each vertex between. `Label_border::outcome` tells what has become of each.
///
/// Borders are tightened one by one, so that some may cross in the end. Of closed ones that cross the more prominent
/// stays, see `compute_prominences()`; a closed one stays before one that is held; of two that are held the shorter
/// stays. The other one is `CROSSING` and remains where it was, or is gone if it crosses another one there, too.
///
/// The borders divide the surface into parts, each with the label that the borders around it name on its side. So a
/// face changes its label only if it lies between an old border and what has become of it; with a degenerate border a
/// label vanishes there, and its area goes to the label on the other side. Borders may come to lie on each other, for
/// the whole of their length or a piece of it: what was between them is gone there. If all borders of a part are
/// degenerate, the label that had most of its area is left. A face gets the label of the part in which most of it lies.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam FaceLabelMap a model of `ReadablePropertyMap` with the faces of `tm` as key type; its value type has
///         `operator<`
/// \tparam NewFaceLabelMap a model of `WritablePropertyMap` with the faces of `tm` as key type, and the value type of
///         `FaceLabelMap`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary, any genus, any number of connected components
/// \param labels of the faces. The faces of one label need not hang together.
/// \param new_labels is given the new labels of the faces; may be the same map
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
///   \cgalParamNBegin{certify}
///     \cgalParamDescription{whether borders are certified with exact arithmetic; closed ones are corrected where
///                           rounding has led them astray}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the borders, those that are held first; the parts, of which the areas add up to that of the mesh; and their
///         labels
/// \throws Invalid_input for a mesh that cannot be used, and, with `certify`, for a coordinate that is no rational
///         number of moderate size
/// \cost linear in the size of the mesh, times the logarithm of the number of labels, plus, for each border, linear in
///       the lengths of the strips that it is led through, plus, with `certify`, that of `certify_constriction()`, plus
///       that of `segment_by_constrictions()`; if closed borders cross also that of `compute_prominences()`
///
/// \sa `split_along_label_borders()`
/// \sa `tighten_closed_curve()`
template <class TriangleMesh, class FaceLabelMap, class NewFaceLabelMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Tightened_labels<TriangleMesh, std::decay_t<typename boost::property_traits<FaceLabelMap>::value_type>>
tighten_label_borders(const TriangleMesh& tm, FaceLabelMap labels, NewFaceLabelMap new_labels,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Label_border_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<TriangleMesh>() && knows_all)
    return internal::tighten_label_borders_checked(tm, labels, new_labels, np);
  else
    return internal::no_result<Tightened_labels<TriangleMesh, internal::Label_of_map<FaceLabelMap>>>();
}

namespace internal {

template <class TriangleMesh, class FaceLabelMap, class NewFaceLabelMap, class NamedParameters>
Tightened_labels<TriangleMesh, Label_of_map<FaceLabelMap>>
tighten_label_borders_checked(const TriangleMesh& tm, FaceLabelMap labels, NewFaceLabelMap new_labels,
                              const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef Label_of_map<FaceLabelMap> Label;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  const bool certifies = choose_parameter(get_parameter(np, internal_np::certify), true);

  Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  std::map<Label, Index> number;
  const auto face_of = [&](Index f) { return face(imported.halfedge_of(3 * f), tm); };
  const Index faces = static_cast<Index>(imported.number_of_faces());
  for(Index f = 0; f < faces; ++f)
    number.emplace(get(labels, face_of(f)), 0);
  std::vector<Label> label;
  for(auto& [l, n] : number)
  {
    n = static_cast<Index>(label.size());
    label.push_back(l);
  }
  std::vector<Index> old_numbers(faces);
  for(Index f = 0; f < faces; ++f)
    old_numbers[f] = number.at(get(labels, face_of(f)));

  const auto prominences = [&](const std::vector<Constriction<TriangleMesh>>& curves) {
    std::vector<Constriction<TriangleMesh>> result;
    compute_prominences(tm, curves, std::back_inserter(result),
                        CGAL::parameters::vertex_point_map(vpm).vertex_index_map(vim));
    return result;
  };
  Label_border_tightener<TriangleMesh, std::decay_t<decltype(vpm)>, Label> tightener(imported, vpm, certifies, label,
                                                                                     std::move(old_numbers));
  Tightened_labels<TriangleMesh, Label> result = tightener.tighten(prominences);
  for(Index f = 0; f < faces; ++f)
    put(new_labels, face_of(f), label[tightener.new_labels()[f]]);
  return result;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_TIGHTEN_LABEL_BORDERS_H
