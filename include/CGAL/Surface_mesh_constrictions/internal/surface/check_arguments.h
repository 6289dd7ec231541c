// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_ARGUMENTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_ARGUMENTS_H

#include <CGAL/Surface_mesh_constrictions/internal/surface/Parameter_chain.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>
#include <utility>

// Checks of the arguments of public functions. A check that fails stops the compiler with one sentence, and returns
// `false`, so that the function leaves code uninstantiated that would give further errors.

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// The tags of the named parameters that a function knows, beside the one that says that none is given.
template <class... Tag>
struct Known_parameters
{
  template <class T>
  static constexpr bool contains = std::is_same_v<T, internal_np::all_default_t> || (std::is_same_v<T, Tag> || ...);

  template <class... More>
  using With = Known_parameters<Tag..., More...>;
};

// Structures, so that the messages of compilers have their names instead of the lists.
struct Point_parameters : Known_parameters<internal_np::vertex_point_t>
{};

struct Mesh_parameters : Point_parameters::With<internal_np::vertex_index_t>
{};

template <class Known, class T, class Tag, class Base>
constexpr bool check_chain(const Named_function_parameters<T, Tag, Base>*)
{
  constexpr bool is_known = check_is_known<Known::template contains<Tag>>(Tag());
  if constexpr(std::is_same_v<Base, internal_np::No_property>)
    return is_known;
  else
    return check_chain<Known>(static_cast<const typename Base::self*>(nullptr)) && is_known;
}

// A named parameter that a function of CGAL's does not know is ignored; here a threshold that was given to the wrong
// function would be believed to be respected.
template <class Known, class NamedParameters>
constexpr bool check_parameters()
{
  return check_chain<Known>(static_cast<const typename NamedParameters::self*>(nullptr));
}

// A FaceListGraph, or a MutableHalfedgeGraph. Functions tell whether a type is neither: for some types the mere
// question whether boost::graph_traits has a member is an error.
template <class Graph, class = void>
constexpr bool has_faces = false;

template <class Graph>
constexpr bool has_faces<Graph, std::void_t<decltype(num_faces(std::declval<const Graph&>()))>> = true;

template <class Graph, class = void>
constexpr bool is_mutable_graph = false;

template <class Graph>
constexpr bool is_mutable_graph<Graph, std::void_t<decltype(add_edge(std::declval<Graph&>()))>> = true;

template <class Mesh>
constexpr bool check_mesh()
{
  constexpr bool is_face_graph = has_faces<Mesh> || is_mutable_graph<std::remove_const_t<Mesh>>;
  static_assert(is_face_graph,
                "the mesh is not a model of FaceGraph, or the header with its boost::graph_traits is not "
                "included");
  return is_face_graph;
}

template <class Mesh>
constexpr bool check_mutable_mesh()
{
  static_assert(!std::is_const_v<Mesh>, "the mesh is changed, so it cannot be const");
  return check_mesh<Mesh>() && !std::is_const_v<Mesh>;
}

template <class OutputIterator, class Value, class = void>
constexpr bool takes = false;

template <class OutputIterator, class Value>
constexpr bool
    takes<OutputIterator, Value, std::void_t<decltype(*std::declval<OutputIterator&>()++ = std::declval<Value>())>> =
        true;

template <class OutputIterator, class Value>
constexpr bool check_output()
{
  static_assert(takes<OutputIterator, Value>,
                "the output is not an iterator that takes the results: for a container of "
                "these pass std::back_inserter(container)");
  return takes<OutputIterator, Value>;
}

// The values of the results are looked at only if there is a mesh: they may have descriptors of it.
template <class Mesh, class OutputIterator, class Value>
constexpr bool check_mesh_and_output()
{
  if constexpr(check_mesh<Mesh>())
    return check_output<OutputIterator, Value>();
  else
    return false;
}

// The result of a call that is not compiled. Not defined.
template <class Result>
Result no_result();

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_CHECK_ARGUMENTS_H
