// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_SEGMENT_BY_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_SEGMENT_BY_CONSTRICTIONS_H

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Cut_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Part_finder.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/arrange_curves.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/find_nested_cuts.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Coordinate_unit.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

// What `segment_by_constrictions()` does with arguments of the right kind.
template <class TriangleMesh, class ConstrictionRange, class FacePatchMap, class NamedParameters>
Surface_parts segment_by_constrictions_checked(const TriangleMesh& tm, const ConstrictionRange& curves,
                                               FacePatchMap face_patch_map, const NamedParameters& np);

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// computes the parts into which cuts along closed curves divide a surface. The mesh is not changed: each face gets the
/// number of the part in which most of it lies. The parts themselves are bounded by the curves exactly: a crossed face
/// adds to the area and the volume of each part the piece that lies in it.
///
/// A curve that does not separate cuts, too. Curves may touch at vertices, and share arcs. Of two curves that cross,
/// the more prominent one cuts; of two that are equally prominent, or have no prominence, the earlier one. A curve that
/// crosses itself does not cut.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConstrictionRange a range of `Constriction<TriangleMesh>`
/// \tparam FacePatchMap a model of `WritablePropertyMap` with the faces of `tm` as key type and an integer value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param tm a triangle mesh, closed or with boundary
/// \param curves closed curves on `tm`, of which the locations and the prominence count
/// \param face_patch_map is given, for each face, the number of a part, counted from 0
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map associating points to the vertices of `tm`}
///     \cgalParamType{a class model of `ReadablePropertyMap` whose value type is a 3D point; coordinates that are not
///                    doubles are rounded to the nearest double}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map associating to each vertex of `tm` a unique index}
///     \cgalParamType{a class model of `ReadablePropertyMap`}
///     \cgalParamDefault{an automatically indexed internal map}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_prominence}
///     \cgalParamDescription{the least prominence of a curve that cuts}
///     \cgalParamType{`double`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
///   \cgalParamNBegin{choked_side}
///     \cgalParamDescription{only curves that choke this side cut: with `Side::OBJECT` the surface is cut at its necks,
///                           and not around the holes of its handles}
///     \cgalParamType{`Side`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_parts}
///     \cgalParamDescription{the greatest number of parts; if all curves give more, only the highest-ranking curves
///                           cut, as many as give this number of parts. The curves that cut are some of those that cut
///                           with any greater number, see `nested_parts()`.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{unset: all curves cut}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// The last three are the package's own: see \ref PkgSurfaceMeshConstrictionsNamedParameters "Named Parameters".
///
/// \return the parts, in the order of their first faces; which of them meet at which curve; and for each curve whether
///         it cuts, and if not, why
/// \throws Invalid_input for a mesh that cannot be used, and for a curve that is not a closed sequence of locations
/// \cost linear in the size of the mesh, plus, for each crossing, linear in the number of crossings of the same edge
///       and of strands in the same face, plus, for each stretch on which two curves cross the same edges, linear in
///       its length; with `maximum_number_of_parts` that times the logarithm of the number of curves
///
/// \sa `split_along_constrictions()`
template <class TriangleMesh, class ConstrictionRange, class FacePatchMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Surface_parts segment_by_constrictions(const TriangleMesh& tm, const ConstrictionRange& curves,
                                       FacePatchMap face_patch_map,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  constexpr bool knows_all = internal::check_parameters<internal::Cutting_parameters, NamedParameters>();
  if constexpr(internal::check_mesh<TriangleMesh>() && knows_all)
    return internal::segment_by_constrictions_checked(tm, curves, face_patch_map, np);
  else
    return internal::no_result<Surface_parts>();
}

namespace internal {

template <class TriangleMesh, class ConstrictionRange, class FacePatchMap, class NamedParameters>
Surface_parts segment_by_constrictions_checked(const TriangleMesh& tm, const ConstrictionRange& curves,
                                               FacePatchMap face_patch_map, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const auto vpm =
      choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(CGAL::vertex_point, tm));
  const auto vim = CGAL::get_initialized_vertex_index_map(tm, np);

  internal::Imported_mesh<TriangleMesh> imported(tm, vpm, vim);
  imported.rescale();
  const std::vector<Constriction<TriangleMesh>> given(curves.begin(), curves.end());
  internal::Arranged_curves<TriangleMesh> arranged = internal::arrange_chosen(tm, given, np);
  std::optional<internal::Cut_surface> surface;
  std::optional<internal::Part_finder> found;
  const auto find_parts = [&] {
    surface.emplace(imported, *arranged.arrangement);
    found.emplace(*surface);
  };
  find_parts();
  const std::vector<Nested_cut> nested_cuts = internal::find_nested_cuts(*arranged.arrangement, *found);
  if(internal::limit_parts(tm, given, nested_cuts, np, arranged))
    find_parts();
  const internal::Part_finder& finder = *found;

  Surface_parts result = {finder.parts(), {}, arranged.outcomes, nested_cuts};
  const std::vector<std::size_t> part_of_face = finder.parts_of_faces();
  for(Index f = 0; f < part_of_face.size(); ++f)
  {
    typedef typename boost::property_traits<FacePatchMap>::value_type Patch_id;
    put(face_patch_map, face(imported.halfedge_of(3 * f), tm), static_cast<Patch_id>(part_of_face[f]));
    ++result.parts[part_of_face[f]].number_of_faces;
  }

  const internal::Coordinate_unit& unit = imported.unit();
  for(Surface_part& part : result.parts)
  {
    part.area = unit.restored(part.area, 2);
    part.volume = unit.restored(part.volume, 3);
  }
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, double> lengths;
  for(const internal::Part_finder::Meeting& m : finder.meetings())
    lengths[{arranged.arrangement->curve_of_arc(m.arc), m.parts[0], m.parts[1]}] += m.length;
  for(const auto& [meeting, length] : lengths)
    result.adjacencies.push_back(
        {std::get<0>(meeting), {{std::get<1>(meeting), std::get<2>(meeting)}}, unit.restored(length)});
  return result;
}

} // namespace internal

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_SEGMENT_BY_CONSTRICTIONS_H
