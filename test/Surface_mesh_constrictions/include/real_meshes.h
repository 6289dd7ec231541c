// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REAL_MESHES_H
#define REAL_MESHES_H

// Meshes of CGAL's data set, from Debian's package libcgal-demo.

#include "test_meshes.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <gtest/gtest.h>

#include <string>

namespace real_meshes {

template <class Mesh = test_meshes::Mesh>
Mesh read(const std::string& name)
{
  Mesh mesh;
  EXPECT_TRUE(CGAL::IO::read_polygon_mesh(CONSTRICTIONS_MESH_DIR "/" + name, mesh)) << "cannot read " << name;
  return mesh;
}

} // namespace real_meshes

#endif // REAL_MESHES_H
