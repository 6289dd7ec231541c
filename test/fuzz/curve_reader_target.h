// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_CURVE_READER_TARGET_H
#define FUZZ_CURVE_READER_TARGET_H

#include "certificate_comparison.h"
#include "failure.h"
#include "files.h"
#include "oracle.h"

#include "input/curves_file.h"
#include "input/file_numbering.h"
#include "input/labels_file.h"
#include "input/landmarks_file.h"
#include "input/loops_file.h"
#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

namespace fuzz {

// The mesh of a file, and certificates of curves on it.
class Mesh_of_curves
{
public:
  Mesh_of_curves(const std::string& off, Tally& tally)
    : m_mesh(read(off, m_numbering)), m_body(body_of(m_mesh)), m_comparison(m_body, m_mesh, tally)
  {}
  Mesh_of_curves(const Mesh_of_curves&) = delete;

  const Mesh& mesh() const { return m_mesh; }
  const constrictions::File_numbering& numbering() const { return m_numbering; }

  void compare(const Constriction& curve) { m_comparison.compare(curve, certify_constriction(m_mesh, curve)); }

private:
  static Mesh read(const std::string& off, constrictions::File_numbering& numbering)
  {
    constrictions::File_record record;
    const Temporary_file file(".off", off.data(), off.size());
    Mesh mesh = constrictions::read_mesh_file(file.name(), constrictions::Reading(), record);
    numbering = record.numbering;
    return mesh;
  }

  // with the numbers of the mesh
  static Body body_of(const Mesh& mesh)
  {
    Body body;
    for(std::size_t v = 0; v < mesh.number_of_vertices() + mesh.number_of_removed_vertices(); ++v)
    {
      const Mesh::Point& p = mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
      body.points.push_back({{p.x(), p.y(), p.z()}});
    }
    for(Mesh::Face_index f : mesh.faces())
    {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      body.faces.push_back({{static_cast<int>(mesh.source(h)), static_cast<int>(mesh.target(h)),
                             static_cast<int>(mesh.target(mesh.next(h)))}});
    }
    return body;
  }

  constrictions::File_numbering m_numbering;
  const Mesh m_mesh;
  const Body m_body;
  Certificate_comparison m_comparison;
};

// Three rings of four points, one above the other: two frusta joined at a square, which is a constriction of the
// vertices 4 to 7. The frusta are made of triangles, from the vertex that comes first.
inline std::string waist()
{
  std::ostringstream off;
  off << "OFF\n12 20 0\n";
  for(int ring = 0; ring < 3; ++ring)
    for(int i = 0; i < 4; ++i)
    {
      const int r = ring == 1 ? 1 : 3;
      off << (i == 0 || i == 3 ? r : -r) << ' ' << (i < 2 ? r : -r) << ' ' << 5 * ring << '\n';
    }
  for(int ring = 0; ring < 8; ring += 4)
    for(int i = 0; i < 4; ++i)
    {
      const int j = (i + 1) % 4;
      off << "3 " << ring + i << ' ' << ring + j << ' ' << ring + 4 + j << '\n';
      off << "3 " << ring + i << ' ' << ring + 4 + j << ' ' << ring + 4 + i << '\n';
    }
  off << "3 0 2 1\n3 8 9 10\n3 0 3 2\n3 8 10 11\n";
  return off.str();
}

// The same, but open above, and with all that a file can have which its mesh has not: quadrilaterals below, a seam of
// doubled vertices from 4 to 8, a face that is turned round, one of no area, a vertex on no face, and a tetrahedron that
// touches vertex 1.
inline std::string waist_to_be_repaired()
{
  return "OFF\n18 18 0\n"
         "3 3 0\n-3 3 0\n-3 -3 0\n3 -3 0\n"
         "1 1 5\n-1 1 5\n-1 -1 5\n1 -1 5\n"
         "3 3 10\n-3 3 10\n-3 -3 10\n3 -3 10\n"
         "1 1 5\n3 3 10\n0 0 5\n-5 3 0\n-3 5 0\n-3 3 -2\n"
         "4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
         "3 12 5 9\n3 12 9 13\n3 5 10 6\n3 5 10 9\n3 6 7 11\n3 6 11 10\n3 7 4 8\n3 7 8 11\n3 4 4 5\n"
         "3 1 16 15\n3 1 15 17\n3 1 17 16\n3 15 16 17\n";
}

// The first byte chooses among curves, loops, labels, places and loops through places, and the mesh that they are on.
// Curves that are read are compared with the oracle.
class Curve_reader_target
{
public:
  explicit Curve_reader_target(Tally& tally) : m_waist(waist(), tally), m_repaired(waist_to_be_repaired(), tally) {}

  // Returns whether the file was read.
  bool run(const std::uint8_t* data, std::size_t size)
  {
    if(size == 0)
      return false;
    Mesh_of_curves& on = (data[0] & 8) != 0 ? m_repaired : m_waist;
    const Mesh& mesh = on.mesh();
    const constrictions::File_numbering& numbering = on.numbering();
    const Temporary_file file(".txt", data + 1, size - 1);
    switch(data[0] % 8)
    {
    case 0:
      return is_read([&] {
        for(const auto& loop : constrictions::read_loops_file(file.name(), mesh, numbering).vertices)
          for(Mesh::Vertex_index v : loop)
            if(!mesh.has_valid_index(v) || mesh.is_removed(v))
              fail("a loop has a vertex that does not exist");
      });
    case 1:
      return is_read([&] {
        if(constrictions::read_labels_file(file.name(), numbering.faces).size() != numbering.faces)
          fail("there are not as many labels as faces");
      });
    case 4:
      return is_read([&] {
        for(const auto& landmark : constrictions::read_landmarks_file(file.name()))
          for(double x : landmark.location)
            if(!std::isfinite(x))
              fail("a coordinate of a place is not finite");
      });
    case 5:
      return is_read([&] {
        for(const auto& places : constrictions::read_places_file(file.name(), mesh, numbering).places)
          for(const Mesh::Point& p : places)
            if(!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
              fail("a coordinate of a place is not finite");
      });
    default:
    {
      constrictions::Curves curves;
      if(!is_read([&] { curves = constrictions::read_curves_file(file.name(), mesh, numbering); }))
        return false;
      for(const Constriction& c : curves.curves)
        on.compare(c);
      return true;
    }
    }
  }

private:
  Mesh_of_curves m_waist, m_repaired;
};

} // namespace fuzz

#endif // FUZZ_CURVE_READER_TARGET_H
