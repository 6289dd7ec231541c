// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_QUERY_FILE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_QUERY_FILE_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// Exception of a `Constriction_query` that is given a file which it cannot be read from. The message is one line that
/// says what does not fit, and where.
class Invalid_query_file : public std::runtime_error
{
public:
  /// \param offset the number of bytes before the place
  /// \param what what does not fit
  Invalid_query_file(std::size_t offset, const std::string& what)
    : std::runtime_error("query file, byte " + std::to_string(offset) + ": " + what), m_offset(offset)
  {}

  /// the number of bytes before the place that does not fit
  std::size_t offset() const noexcept { return m_offset; }

private:
  std::size_t m_offset;
};

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INVALID_QUERY_FILE_H
