// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_QUERY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_QUERY_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_query_file.h>
#include <CGAL/Surface_mesh_constrictions/Loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/Prepared_surface.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/carry_seeds_to_input.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/constrictions_of_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/held_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/loop_through.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/loops_at_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/query_file.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/section_at_location.h>
#include <CGAL/Surface_mesh_constrictions/internal/detect/tighten_loops.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/Packed_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/seeds/find_seeds.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/policies_asked_for.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_arguments.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <ostream>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {

namespace internal {

struct Query_preparation_parameters
  : Mesh_parameters::With<internal_np::visitor_t, internal_np::get_cost_policy_t, internal_np::get_placement_policy_t,
                          internal_np::simplification_policies_t, internal_np::seed_sources_t>
{};

struct Loop_query_parameters
  : Known_parameters<internal_np::certify_t, internal_np::maximum_number_of_loops_t, internal_np::minimum_loop_angle_t>
{};

struct Tightening_query_parameters : Known_parameters<internal_np::certify_t>
{};

} // namespace internal

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A triangle mesh that is prepared once and asked many times: for its constrictions, for those near a location, for
/// the girth at a location, and to tighten closed curves.
///
/// The constructor copies the mesh, simplifies the copy, finds seed curves, and keeps some levels of the
/// simplification. Each query gives the same answer as the function that it is named after, and pays for what it
/// touches:
/// - `constrictions()`: `detect_constrictions()`
/// - `constrictions_near()`: `detect_constrictions_near()`
/// - `geodesic_loops()` and `girth()`: `geodesic_loops_at_location()`
/// - `tighten()`: `tighten_closed_curves()`
/// - `loop_through()`: `geodesic_loop_through_locations()`
/// - `plane_section()`: `plane_section_at_location()`
///
/// All queries are `const`, and several threads may call them at a time. The mesh and its points must neither change
/// nor be destroyed as long as the object lives.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam ConcurrencyTag enables sequential versus parallel algorithm, in the constructor and in `constrictions()`:
///         `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The answers are the same.
/// \tparam VertexPointMap a model of `ReadablePropertyMap` whose key type is the vertex descriptor of `TriangleMesh`
///         and whose value type is a 3D point
///
/// \cost Memory: about 140 bytes a face of a large closed mesh, plus the seed curves and the constrictions found
template <class TriangleMesh, class ConcurrencyTag = Sequential_tag,
          class VertexPointMap = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>
class Constriction_query
{
public:
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor; ///< of the mesh
  typedef typename Constriction<TriangleMesh>::Face_location Face_location; ///< a face, and barycentric coordinates

  /// prepares a mesh.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tm a triangle mesh, as for `detect_constrictions()`; it is referred to
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `vertex_point_map`,
  ///        `vertex_index_map`, `get_cost`, `get_placement`, `simplification_policies`, `seed_sources` and `visitor` of
  ///        `detect_constrictions()`; of the policies one can be given
  ///
  /// \throws Invalid_input for a mesh that cannot be used; it says what is wrong and where
  /// \throws exceptions of the visitor
  /// \cost that of the simplification and of the seed sources, O(n log n) for n faces
#ifdef DOXYGEN_RUNNING
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
#else
  template <class NamedParameters = CGAL::parameters::Default_named_parameters,
            std::enable_if_t<!std::is_convertible<NamedParameters*, std::istream*>::value, int> = 0>
#endif
  explicit Constriction_query(const TriangleMesh& tm, const NamedParameters& np = CGAL::parameters::default_values())
    : m_prepared(tm, point_map(tm, np), CGAL::get_initialized_vertex_index_map(tm, np)), m_given(given(np))
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    if constexpr(internal::check_parameters<internal::Query_preparation_parameters, NamedParameters>())
    {
      const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
      const auto policies = internal::policies_asked_for(np);
      static_assert(std::tuple_size<std::decay_t<decltype(policies)>>::value == 1,
                    "a query object takes one of the simplification policies");
      m_prepared.template simplify<ConcurrencyTag>(
          std::get<0>(policies), internal::has_seed_sources<NamedParameters>, visitor,
          [&](const Collapse_record& record, Progressive_mesh& pm) {
            visitor.on_stage_begin(Detection_stage::SEEDS, record.collapses.size());
            m_seeds = internal::Packed_seeds(internal::find_seeds<ConcurrencyTag>(record, np, false, visitor, pm));
            visitor.on_stage_end(Detection_stage::SEEDS);
          });
    }
  }

  /// reads what `write()` has written of the same mesh, instead of preparing it. The answers are the same, bit for bit.
  ///
  /// The file tells whether `seed_sources` and one of the parameters for policies were given when the mesh was
  /// prepared, and has to agree with `np` in this, but not which: that is for the caller to know. A file that somebody
  /// made to harm is refused, or leads to answers of a wrong preparation; it does not crash the program.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param tm the mesh: the same points and faces, in the same order; it is referred to
  /// \param in a stream in binary mode, which is read to its end
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", those that the mesh was prepared
  ///        with; `visitor` is not called
  ///
  /// \throws Invalid_input for a mesh that cannot be used
  /// \throws Invalid_query_file for a file of another mesh, another version, or other parameters, one that is damaged
  ///         or cut off, and one that cannot be read
  /// \cost linear in the mesh and the file
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Constriction_query(const TriangleMesh& tm, std::istream& in,
                     const NamedParameters& np = CGAL::parameters::default_values())
    : m_prepared(tm, point_map(tm, np), CGAL::get_initialized_vertex_index_map(tm, np)), m_given(given(np))
  {
    if constexpr(internal::check_parameters<internal::Query_preparation_parameters, NamedParameters>())
    {
      internal::Query_file_key key = m_prepared.key();
      key.given = m_given;
      const internal::Query_record record = internal::Query_file_reader(in).get(key);
      m_prepared.restore(record);
      m_seeds = internal::Packed_seeds(record.seeds);
    }
  }

  /// writes what has been prepared: the order of the faces, the collapses and the seeds. What is found by
  /// `constrictions()` is not written.
  ///
  /// The format is binary and the same on every platform: 16 bytes a face for the collapses, 4 if the simplification in
  /// blocks has ordered the faces anew, plus 12 bytes for each seed and 4 for each of its vertices.
  ///
  /// \param out a stream in binary mode
  ///
  /// \return whether the stream is good afterwards
  /// \cost O(n log n) for n faces, and a copy of the progressive mesh
  bool write(std::ostream& out) const
  {
    std::pair<internal::Query_file_key, internal::Query_record> prepared = m_prepared.record();
    prepared.first.given = m_given;
    prepared.second.seeds = m_seeds.unpacked();
    internal::Query_file_writer(out).put(prepared.first, prepared.second);
    return out.good();
  }

  /// the mesh
  const TriangleMesh& mesh() const { return m_prepared.imported().mesh(); }

  /// writes the constrictions of the mesh, as `detect_constrictions()` does.
  ///
  /// What is found is kept, so that another call that asks for the same, or for thresholds by which less is selected of
  /// it, takes no longer than `select_by_prominence()`. That is so if only `minimum_prominence`, not less than
  /// `default_minimum_prominence`, `minimum_isolation`, the bounds of the length and the number are others than in the
  /// call before.
  ///
  /// \tparam OutputIterator takes `Constriction<TriangleMesh>`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param out the selected constrictions, those that rank highest first
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
  ///        `select_by_prominence()`, `certify`, `certified_only` and `visitor`
  ///
  /// \return the output iterator, past the last constriction
  /// \throws Invalid_input with `certify`, for a coordinate that is not a rational number of moderate size
  /// \throws exceptions of the visitor; then nothing has been written
  /// \cost that of `detect_constrictions()` without that of the simplification and of the seed sources
  template <class OutputIterator, class NamedParameters = CGAL::parameters::Default_named_parameters>
  OutputIterator constrictions(OutputIterator out, const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    constexpr bool knows_all = internal::check_parameters<internal::Near_parameters, NamedParameters>();
    if constexpr(internal::check_output<OutputIterator, Constriction<TriangleMesh>>() && knows_all)
    {
      const auto visitor = choose_parameter(get_parameter(np, internal_np::visitor), Detection_visitor_base());
      const Search search = search_of(np);
      std::shared_ptr<const Found> found;
      {
        const std::lock_guard<std::mutex> lock(m_mutex);
        found = m_found;
      }
      if(!found || !(found->search == search))
      {
        std::shared_ptr<Found> made = std::make_shared<Found>();
        made->search = search;
        internal::Seeds_on_input carried;
        carried.collapses = m_prepared.surface().number_of_collapses();
        Progressive_mesh pm(m_prepared.surface());
        internal::carry_unstraightened<ConcurrencyTag>(pm, m_seeds.unpacked(), np, visitor, carried);
        made->constrictions = internal::constrictions_of_seeds<ConcurrencyTag>(
            m_prepared.imported(), m_prepared.surface(), m_prepared.measuring(), m_prepared.sides(),
            m_prepared.vertex_point_map(), carried, np, visitor, made->statistics);
        found = made;
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_found = found;
      }
      return internal::write_selected(found->constrictions, out, np, visitor, found->statistics);
    }
    else
      return out;
  }

  /// writes the constrictions around a location, the nearest first, as `detect_constrictions_near()` does, with the
  /// levels that are held.
  ///
  /// \tparam Point a 3D point, of any kernel
  /// \tparam OutputIterator takes `Constriction<TriangleMesh>`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param location a point on the surface or near it
  /// \param out the constrictions, the nearest first; none where nothing is narrow
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
  ///        `detect_constrictions_near()` but for those of the mesh and its simplification
  ///
  /// \return the output iterator, past the last constriction
  /// \throws Invalid_input for a location with a coordinate that is not a finite number, and, with `certify`, for a
  ///         coordinate of the mesh that is not a rational number of moderate size
  /// \throws exceptions of the visitor; then nothing has been written
  /// \cost that of the seeds of 64 roots on the level of 1000 vertices, plus, for each constriction that is written,
  ///       that of leading it to the input, `certify_constriction()` and its prominence
  template <class Point, class OutputIterator, class NamedParameters = CGAL::parameters::Default_named_parameters>
  OutputIterator constrictions_near(const Point& location, OutputIterator out,
                                    const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    constexpr bool knows_all = internal::check_parameters<internal::Near_parameters, NamedParameters>();
    if constexpr(internal::check_output<OutputIterator, Constriction<TriangleMesh>>() && knows_all)
      return internal::write_constrictions_near<Sequential_tag>(m_prepared, location, out, np);
    else
      return out;
  }

  /// writes the shortest closed curves through a location around the limb that it is on, as
  /// `geodesic_loops_at_location()` does.
  ///
  /// \tparam Location a vertex descriptor of `TriangleMesh`, or `Face_location`, or a 3D point of any kernel
  /// \tparam OutputIterator takes `Geodesic_loop<TriangleMesh>`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param location where the loops are held
  /// \param out the loops, the shortest first
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among `maximum_number_of_loops`,
  ///        `minimum_loop_angle` and `certify`
  ///
  /// \return the output iterator, past the last element that was written
  /// \throws Invalid_input for a location that is not on the mesh, as `geodesic_loops_at_location()`, and, with
  ///         `certify`, for a coordinate that is not a rational number of moderate size
  /// \cost that of `geodesic_loops_at_location()` without that of the simplification. A location that is not a vertex
  ///       costs a copy of the mesh's connectivity and points.
  template <class Location, class OutputIterator, class NamedParameters = CGAL::parameters::Default_named_parameters>
  OutputIterator geodesic_loops(const Location& location, OutputIterator out,
                                const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    constexpr bool knows_all = internal::check_parameters<internal::Loop_query_parameters, NamedParameters>();
    if constexpr(internal::check_output<OutputIterator, Geodesic_loop<TriangleMesh>>() && knows_all)
      return internal::write_loops_at_location(
          m_prepared, location,
          choose_parameter(get_parameter(np, internal_np::maximum_number_of_loops), std::size_t(1)),
          choose_parameter(get_parameter(np, internal_np::minimum_loop_angle), internal::least_loop_angle),
          choose_parameter(get_parameter(np, internal_np::certify), true), out);
    else
      return out;
  }

  /// the first of `geodesic_loops()`; nothing if there is none.
  template <class Location, class NamedParameters = CGAL::parameters::Default_named_parameters>
  std::optional<Geodesic_loop<TriangleMesh>> girth(const Location& location,
                                                   const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    std::vector<Geodesic_loop<TriangleMesh>> loops;
    geodesic_loops(location, std::back_inserter(loops), np);
    return loops.empty() ? std::nullopt : std::make_optional(std::move(loops.front()));
  }

  /// shortens closed loops of edges until they are closed geodesics, or found degenerate, as `tighten_closed_curves()`
  /// does.
  ///
  /// \tparam LoopRange a range of ranges of vertex descriptors
  /// \tparam OutputIterator takes `Tightened_curve<TriangleMesh>`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param loops closed paths of mesh edges, each the cyclic sequence of its vertices, the first not repeated
  /// \param out one result for each loop, in order
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" that may have `certify`
  ///
  /// \return the output iterator, past the last element that was written
  /// \throws Invalid_input for a loop that is not a closed path of mesh edges, and, with `certify`, for a coordinate
  ///         that is not a rational number of moderate size
  /// \cost for each loop linear in the lengths of the strips that it is led through, plus, with `certify`, that of
  ///       `certify_constriction()`
  template <class LoopRange, class OutputIterator, class NamedParameters = CGAL::parameters::Default_named_parameters>
  OutputIterator tighten(const LoopRange& loops, OutputIterator out,
                         const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    constexpr bool knows_all = internal::check_parameters<internal::Tightening_query_parameters, NamedParameters>();
    if constexpr(internal::check_output<OutputIterator, Tightened_curve<TriangleMesh>>() && knows_all)
      return internal::tighten_loops(m_prepared, loops, choose_parameter(get_parameter(np, internal_np::certify), true),
                                     out);
    else
      return out;
  }

  /// shortens one closed loop of edges: the constriction, or why there is none.
  template <class Loop>
  Tightened_curve<TriangleMesh> tighten(const Loop& loop) const
  {
    std::vector<Tightened_curve<TriangleMesh>> result;
    const Loop* loops = &loop;
    tighten(CGAL::make_range(loops, loops + 1), std::back_inserter(result));
    return result.front();
  }

  /// joins three or more locations by geodesics, in their order and back to the first, as
  /// `geodesic_loop_through_locations()` does.
  ///
  /// \tparam LocationRange a range of vertex descriptors, of `Face_location`, or of 3D points of any kernel
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param locations where the loop is held
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" that may have `certify`
  ///
  /// \return the loop, and what it becomes when it is let go
  /// \throws Invalid_input for locations that cannot be used, as `geodesic_loop_through_locations()`, and, with
  ///         `certify`, for a coordinate that is not a rational number of moderate size
  /// \cost that of `geodesic_loop_through_locations()` without that of the mesh. A location that is not a vertex costs
  ///       a copy of the mesh's connectivity and points.
  template <class LocationRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Loop_through_locations<TriangleMesh>
  loop_through(const LocationRange& locations, const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    if constexpr(internal::check_parameters<internal::Tightening_query_parameters, NamedParameters>())
      return internal::loop_through(m_prepared, internal::given_locations(m_prepared, locations),
                                    choose_parameter(get_parameter(np, internal_np::certify), true));
    else
      return internal::no_result<Loop_through_locations<TriangleMesh>>();
  }

  /// cuts the surface with the plane through a location that is perpendicular to an axis, and tightens the curve through
  /// the location, as `plane_section_at_location()` does.
  ///
  /// \tparam Location a vertex descriptor of `TriangleMesh`, or `Face_location`, or a 3D point of any kernel
  /// \tparam Vector a 3D vector of any kernel
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param location a place on the surface
  /// \param axis the direction of the axis, of any length but 0
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" that may have `certify`
  ///
  /// \return the curve, and the geodesic loop that it becomes
  /// \throws Invalid_input for a location or an axis that cannot be used, as `plane_section_at_location()`, and, with
  ///         `certify`, for a coordinate that is not a rational number of moderate size
  /// \cost linear in the number of faces that the curve crosses, plus that of `tighten()`. A location that is not a
  ///       vertex costs a copy of the mesh's connectivity and points.
  template <class Location, class Vector, class NamedParameters = CGAL::parameters::Default_named_parameters>
  Plane_section<TriangleMesh> plane_section(const Location& location, const Vector& axis,
                                            const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    if constexpr(internal::check_parameters<internal::Tightening_query_parameters, NamedParameters>())
    {
      const internal::Vector3 direction = internal::given_axis(axis);
      return internal::Section_at_location<TriangleMesh, VertexPointMap>(m_prepared, location)
          .section(direction, choose_parameter(get_parameter(np, internal_np::certify), true));
    }
    else
      return internal::no_result<Plane_section<TriangleMesh>>();
  }

private:
  // Which parameters that decide on the preparation are given: 1 for policies, 2 for seed sources.
  template <class NamedParameters>
  static std::uint32_t given(const NamedParameters&)
  {
    using CGAL::parameters::is_default_parameter;
    constexpr bool has_policies = !is_default_parameter<NamedParameters, internal_np::get_cost_policy_t>::value ||
                                  !is_default_parameter<NamedParameters, internal_np::simplification_policies_t>::value;
    return (has_policies ? 1u : 0u) + (internal::has_seed_sources<NamedParameters> ? 2u : 0u);
  }

  template <class NamedParameters>
  static VertexPointMap point_map(const TriangleMesh& tm, const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return choose_parameter(get_parameter(np, internal_np::vertex_point),
                            get_const_property_map(CGAL::vertex_point, tm));
  }

  // What the curves that are found depend on.
  struct Search
  {
    double minimum_prominence, maximum_ratio;
    bool all, with_crossing, with_rims, certifies, certified_only;

    friend bool operator==(const Search& a, const Search& b)
    {
      return a.minimum_prominence == b.minimum_prominence && a.maximum_ratio == b.maximum_ratio && a.all == b.all &&
             a.with_crossing == b.with_crossing && a.with_rims == b.with_rims && a.certifies == b.certifies &&
             a.certified_only == b.certified_only;
    }
  };

  template <class NamedParameters>
  static Search search_of(const NamedParameters& np)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return {(std::min)(choose_parameter(get_parameter(np, internal_np::minimum_prominence), default_minimum_prominence),
                       default_minimum_prominence),
            choose_parameter(get_parameter(np, internal_np::maximum_isoperimetric_ratio),
                             default_maximum_isoperimetric_ratio),
            choose_parameter(get_parameter(np, internal_np::all_constrictions), false),
            choose_parameter(get_parameter(np, internal_np::crossing_constrictions), false),
            choose_parameter(get_parameter(np, internal_np::rim_constrictions), false),
            choose_parameter(get_parameter(np, internal_np::certify), true),
            choose_parameter(get_parameter(np, internal_np::certified_only), false)};
  }

  // The curves of a search, before the selection.
  struct Found
  {
    Search search;
    std::vector<Constriction<TriangleMesh>> constrictions;
    Detection_statistics statistics;
  };

  internal::Prepared_surface<TriangleMesh, VertexPointMap> m_prepared;
  internal::Packed_seeds m_seeds;
  const std::uint32_t m_given;
  mutable std::mutex m_mutex; // of what was found last
  mutable std::shared_ptr<const Found> m_found;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CONSTRICTION_QUERY_H
