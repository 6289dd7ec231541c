// SPDX-License-Identifier: GPL-3.0-or-later
#include "openmesh_decimater.h"

#ifdef WITH_OPENMESH

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

namespace {

struct Traits : public OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
  typedef OpenMesh::Vec3d Normal;
};

} // namespace

struct Openmesh_decimater::Implementation
{
  typedef OpenMesh::TriMesh_ArrayKernelT<Traits> Mesh;
  Mesh mesh;
};

Openmesh_decimater::Openmesh_decimater(const std::vector<std::array<double, 3>>& points,
                                       const std::vector<std::array<std::size_t, 3>>& triangles)
  : m_implementation(std::make_unique<Implementation>())
{
  Implementation::Mesh& mesh = m_implementation->mesh;
  std::vector<Implementation::Mesh::VertexHandle> vertices;
  for(const std::array<double, 3>& p : points)
    vertices.push_back(mesh.add_vertex(OpenMesh::Vec3d(p[0], p[1], p[2])));
  for(const std::array<std::size_t, 3>& t : triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
}

std::size_t Openmesh_decimater::collapses_of_a_copy() const
{
  Implementation::Mesh mesh = m_implementation->mesh;
  OpenMesh::Decimater::DecimaterT<Implementation::Mesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<Implementation::Mesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  return decimater.decimate_to(4);
}

#else

struct Openmesh_decimater::Implementation
{};

Openmesh_decimater::Openmesh_decimater(const std::vector<std::array<double, 3>>&,
                                       const std::vector<std::array<std::size_t, 3>>&)
{}

std::size_t Openmesh_decimater::collapses_of_a_copy() const { return 0; }

#endif

Openmesh_decimater::~Openmesh_decimater() = default;
