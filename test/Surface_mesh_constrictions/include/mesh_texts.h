// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MESH_TEXTS_H
#define MESH_TEXTS_H

#include "input/input_file.h"
#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>

// The same small mesh in every format, and a folder for files of it.
namespace mesh_texts {

using CGAL::Surface_mesh_constrictions::Input_defect;
using CGAL::Surface_mesh_constrictions::Invalid_input;
using constrictions::Mesh;

typedef std::array<double, 3> Position;
typedef std::array<std::uint32_t, 3> Triangle;

struct Soup
{
  std::vector<Position> points;
  std::vector<Triangle> triangles;
};

// Every vertex is numbered by its first appearance in the faces, as in an STL file, and the coordinates are floats, so
// that all formats can hold the same mesh.
inline Soup octahedron()
{
  return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -0.25}},
          {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}}};
}

inline std::string points_as_text(const Soup& soup, const std::string& prefix = "")
{
  std::ostringstream out;
  for(const Position& p : soup.points)
    out << prefix << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  return out.str();
}

inline std::string faces_as_text(const Soup& soup, const std::string& prefix, int first = 0)
{
  std::ostringstream out;
  for(const Triangle& t : soup.triangles)
    out << prefix << ' ' << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first << '\n';
  return out.str();
}

inline std::string off(const Soup& soup)
{
  return "OFF\n" + std::to_string(soup.points.size()) + ' ' + std::to_string(soup.triangles.size()) + " 0\n" +
         points_as_text(soup) + faces_as_text(soup, "3");
}

inline std::string obj(const Soup& soup) { return points_as_text(soup, "v ") + faces_as_text(soup, "f", 1); }

inline std::string ply_header(const Soup& soup, const std::string& format)
{
  return "ply\nformat " + format + " 1.0\ncomment x y z\nelement vertex " + std::to_string(soup.points.size()) +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         std::to_string(soup.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class T>
inline std::string bytes(T value, bool big_endian = false)
{
  std::string result(sizeof(T), '\0');
  std::memcpy(&result[0], &value, sizeof(T));
  if(big_endian)
    std::reverse(result.begin(), result.end());
  return result;
}

inline std::string binary_ply(const Soup& soup, bool big_endian)
{
  std::string result = ply_header(soup, big_endian ? "binary_big_endian" : "binary_little_endian");
  for(const Position& p : soup.points)
    for(double x : p)
      result += bytes(static_cast<float>(x), big_endian);
  for(const Triangle& t : soup.triangles)
  {
    result += '\3';
    for(std::uint32_t v : t)
      result += bytes(v, big_endian);
  }
  return result;
}

inline std::string ascii_stl(const Soup& soup)
{
  std::ostringstream out;
  out << "solid facet of a name\n";
  for(const Triangle& t : soup.triangles)
  {
    out << "  facet normal nan 0 0\n    outer loop\n";
    for(std::uint32_t v : t)
      out << "      vertex " << soup.points[v][0] << ' ' << soup.points[v][1] << ' ' << soup.points[v][2] << '\n';
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid facet of a name\n";
  return out.str();
}

inline std::string binary_stl(const Soup& soup, const std::string& title = "made by a test")
{
  std::string result = title;
  result.resize(80, '\0');
  result += bytes(static_cast<std::uint32_t>(soup.triangles.size()));
  for(const Triangle& t : soup.triangles)
  {
    result += std::string(12, '\0');
    for(std::uint32_t v : t)
      for(double x : soup.points[v])
        result += bytes(static_cast<float>(x));
    result += std::string(2, '\0');
  }
  return result;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

inline std::string with_crlf(const std::string& text)
{
  std::string result;
  for(char c : text)
    result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

class Mesh_file : public testing::Test
{
protected:
  Mesh_file()
  {
    std::string name = testing::TempDir() + "mesh_file_XXXXXX";
    folder = mkdtemp(&name[0]);
  }

  ~Mesh_file() override
  {
    std::error_code error;
    std::filesystem::remove_all(folder, error);
  }

  std::string file(const std::string& name, const std::string& content) const
  {
    const std::string path = (folder / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  Mesh read(const std::string& name, const std::string& content) const
  {
    return constrictions::read_mesh_file(file(name, content));
  }

  void expect_mesh(const Soup& expected, const std::string& name, const std::string& content) const
  {
    SCOPED_TRACE(name);
    Mesh mesh;
    ASSERT_NO_THROW(mesh = read(name, content));
    ASSERT_EQ(mesh.num_vertices(), expected.points.size());
    ASSERT_EQ(mesh.num_faces(), expected.triangles.size());
    EXPECT_TRUE(mesh.is_valid(false));
    for(Mesh::Vertex_index v : mesh.vertices())
      for(int i = 0; i < 3; ++i)
        EXPECT_EQ(mesh.point(v)[i], expected.points[v][static_cast<std::size_t>(i)]) << v;
    for(Mesh::Face_index f : mesh.faces())
    {
      Mesh::Halfedge_index h = mesh.halfedge(f);
      for(std::uint32_t v : expected.triangles[f])
      {
        EXPECT_EQ(mesh.source(h).idx(), v) << f;
        h = mesh.next(h);
      }
    }
  }

  // The message is one line and holds each of `parts`.
  static void expect_message(const std::string& message, const std::vector<std::string>& parts)
  {
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    for(const std::string& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  }

  void expect_file_error(const std::string& name, const std::string& content,
                         const std::vector<std::string>& parts) const
  {
    SCOPED_TRACE(name);
    try
    {
      read(name, content);
      ADD_FAILURE() << "no error, but expected: " << parts.front();
    }
    catch(const constrictions::Input_file_error& e)
    {
      expect_message(e.what(), parts);
      expect_message(e.what(), {name});
    }
  }

  void expect_defect(Input_defect defect, std::size_t element, const std::string& name, const std::string& content,
                     const std::vector<std::string>& parts) const
  {
    SCOPED_TRACE(name);
    try
    {
      read(name, content);
      ADD_FAILURE() << "no error, but expected: " << parts.front();
    }
    catch(const Invalid_input& e)
    {
      EXPECT_EQ(e.defect(), defect);
      EXPECT_EQ(e.element(), element);
      expect_message(e.what(), parts);
    }
  }

  std::filesystem::path folder;
};

} // namespace mesh_texts

#endif // MESH_TEXTS_H
