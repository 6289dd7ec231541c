// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PREFETCH_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PREFETCH_H

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// Has the processor fetch an object into its caches while it goes on, if the compiler can say so.
template <class T>
void prefetch(const T& object)
{
#ifdef __GNUC__
  __builtin_prefetch(&object);
#else
  static_cast<void>(object);
#endif
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_PREFETCH_H
