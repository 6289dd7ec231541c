// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

namespace constrictions {

namespace {

// Appends a number, the least significant byte first.
template <class Unsigned>
void append(Unsigned number, std::string& out)
{
  for(std::size_t i = 0; i < sizeof(Unsigned); ++i)
    out += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xff);
}

void append(double number, std::string& out)
{
  std::uint64_t bits = 0;
  static_assert(sizeof bits == sizeof number);
  std::memcpy(&bits, &number, sizeof bits);
  append(bits, out);
}

// Hues in steps of the golden ratio: whatever the number of parts, those with near numbers differ.
std::array<std::uint8_t, 3> colour(std::size_t part)
{
  const double hue = std::fmod(0.09 + 0.6180339887498949 * static_cast<double>(part), 1.0);
  std::array<std::uint8_t, 3> result;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const double k = std::fmod(hue * 6 + 5 - 2 * static_cast<double>(i), 6.0);
    const double away = (std::min)(k, 4 - k);
    result[i] = static_cast<std::uint8_t>(235 * (1 - 0.65 * (std::max)(0.0, (std::min)(1.0, away))));
  }
  return result;
}

} // namespace

std::string mesh_as_ply(const Mesh& mesh, const std::vector<std::size_t>& part_of_face)
{
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\ncomment parts of a surface cut along its constrictions\n"
         << "element vertex " << mesh.number_of_vertices()
         << "\nproperty double x\nproperty double y\nproperty double z\n"
         << "element face " << mesh.number_of_faces()
         << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
         << "property int patch\nend_header\n";
  std::string out = header.str();

  std::vector<std::uint32_t> number(mesh.num_vertices());
  std::uint32_t n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = n++;
    for(int i = 0; i < 3; ++i)
      append(mesh.point(v)[i], out);
  }
  for(Mesh::Face_index f : mesh.faces())
  {
    append(std::uint8_t(3), out);
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      append(number[v], out);
    for(std::uint8_t c : colour(part_of_face[f]))
      append(c, out);
    append(static_cast<std::uint32_t>(part_of_face[f]), out);
  }
  return out;
}

} // namespace constrictions
