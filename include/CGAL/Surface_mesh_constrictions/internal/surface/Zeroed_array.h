// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_ZEROED_ARRAY_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_ZEROED_ARRAY_H

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// An array with an element for each element of a mesh, all bits of which are zero at first. The system hands out such
// memory page by page, when it is first touched. So a search that touches a small part of a large mesh pays, in time
// and in memory, for that part only.
template <class T>
class Zeroed_array
{
  static_assert(std::is_trivially_destructible<T>::value, "elements are neither made nor destroyed one by one");

public:
  // Constant for large arrays.
  explicit Zeroed_array(std::size_t size)
    : m_elements(static_cast<T*>(std::calloc(size > 0 ? size : 1, sizeof(T)))), m_size(size)
  {
    if(!m_elements)
      throw std::bad_alloc();
  }

  T& operator[](std::size_t i) { return m_elements.get()[i]; }
  const T& operator[](std::size_t i) const { return m_elements.get()[i]; }

  std::size_t size() const { return m_size; }

private:
  struct Free
  {
    void operator()(T* elements) const { std::free(elements); }
  };

  std::unique_ptr<T, Free> m_elements;
  std::size_t m_size;
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_ZEROED_ARRAY_H
