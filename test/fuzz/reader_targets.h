// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_READER_TARGETS_H
#define FUZZ_READER_TARGETS_H

// Files of any content are read, or refused with one line.

#include "bodies.h"
#include "certificate_comparison.h"
#include "failure.h"

#include "input/curves_file.h"
#include "input/input_file.h"
#include "input/labels_file.h"
#include "input/landmarks_file.h"
#include "input/loops_file.h"
#include "input/mesh_file.h"
#include "output/mesh_as_text.h"
#include "zip_archive.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/boost/graph/helpers.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace fuzz {

// A file in the folder for temporary files, which is removed at the end.
class Temporary_file
{
public:
  Temporary_file(const std::string& extension, const void* data, std::size_t size)
    : m_name((std::filesystem::temp_directory_path() / ("fuzz" + std::to_string(getpid()) + extension)).string())
  {
    std::FILE* const file = std::fopen(m_name.c_str(), "wb");
    if(file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0)
      throw std::runtime_error("cannot write " + m_name);
  }

  ~Temporary_file() { std::remove(m_name.c_str()); }
  Temporary_file(const Temporary_file&) = delete;

  const std::string& name() const { return m_name; }

private:
  const std::string m_name;
};

// Whether a file was read; it may also be refused, with one line.
template <class Function>
bool is_read(const Function& function)
{
  std::string message;
  try
  {
    function();
    return true;
  }
  catch(const constrictions::Input_file_error& e)
  {
    message = e.what();
  }
  catch(const SMC::Invalid_input& e)
  {
    message = e.what();
  }
  if(message.empty() || message.size() > 2000 ||
     std::any_of(message.begin(), message.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    fail("a file is refused with the message: " + message);
  return false;
}

// A 3MF file with this model. Bytes that are changed at random would never be an archive.
inline std::string archive_of(const std::string& model)
{
  const std::string relations = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                                "<Relationship Id=\"r\" Target=\"/3D/3dmodel.model\" "
                                "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                                "</Relationships>";
  return constrictions::zip_of({{"_rels/.rels", relations}, {"3D/3dmodel.model", model}});
}

// The bits of the first byte choose: the extension, strictness, whether near points are merged, and whether the rest is
// the model in a 3MF file. What is read is a triangle mesh of finite points; written and read again it is the same, if
// nothing had to be repaired. Returns whether it was read.
inline bool run_mesh_reader_target(const std::uint8_t* data, std::size_t size)
{
  if(size == 0)
    return false;
  const std::array<const char*, 8> extensions = {{".off", ".obj", ".ply", ".stl", ".gz", ".vtk", ".vtp", ".glb"}};
  constrictions::Reading reading;
  reading.is_strict = (data[0] & 8) != 0;
  if((data[0] & 16) != 0)
    reading.merging_distance = 0.5;
  std::string content(reinterpret_cast<const char*>(data) + 1, size - 1);
  if((data[0] & 32) != 0 && constrictions::has_zip())
    content = archive_of(content);
  const Temporary_file file(extensions[data[0] % extensions.size()], content.data(), content.size());
  constrictions::File_record record;
  constrictions::Mesh mesh;
  if(!is_read([&] { mesh = constrictions::read_mesh_file(file.name(), reading, record); }))
    return false;
  if(!mesh.is_valid(false) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
    fail("what was read is no triangle mesh");
  for(auto v : mesh.vertices())
    if(!std::isfinite(mesh.point(v).x()) || !std::isfinite(mesh.point(v).y()) || !std::isfinite(mesh.point(v).z()))
      fail("a coordinate that was read is not finite");
  for(auto f : mesh.faces())
    if(record.numbering.face_of(f) >= record.numbering.faces)
      fail("a face is not of the file");
  mesh.collect_garbage();
  const std::string text = constrictions::mesh_as_text(mesh, "mesh.off");
  const Temporary_file written(".again.off", text.data(), text.size());
  const constrictions::Mesh again = constrictions::read_mesh_file(written.name());
  if(!constrictions::summary_of(record.findings).empty())
    return true;
  if(again.number_of_faces() != mesh.number_of_faces() || again.number_of_vertices() != mesh.number_of_vertices())
    fail("what was read has " + std::to_string(mesh.number_of_faces()) + " faces and " +
         std::to_string(mesh.number_of_vertices()) + " vertices; written and read again " +
         std::to_string(again.number_of_faces()) + " and " + std::to_string(again.number_of_vertices()));
  for(auto v : mesh.vertices())
    if(mesh.point(v) != again.point(v))
      fail("a point is another one after writing and reading");
  return true;
}

// Two frusta that are joined at a square: the vertices 4 to 7, which are a constriction.
inline Body waist()
{
  Body body;
  for(int ring = 0; ring < 3; ++ring)
    for(int i = 0; i < 4; ++i)
    {
      const double r = ring == 1 ? 1 : 3;
      body.points.push_back({{i == 0 || i == 3 ? r : -r, i < 2 ? r : -r, 5. * ring}});
    }
  for(int ring = 0; ring < 8; ring += 4)
    for(int i = 0; i < 4; ++i)
    {
      const int j = (i + 1) % 4;
      body.faces.push_back({{ring + i, ring + j, ring + 4 + j}});
      body.faces.push_back({{ring + i, ring + 4 + j, ring + 4 + i}});
    }
  for(int i = 1; i < 3; ++i)
  {
    body.faces.push_back({{0, i + 1, i}});
    body.faces.push_back({{8, 8 + i, 9 + i}});
  }
  return body;
}

// The first byte chooses among curves, loops, labels, places and loops through places, on two frusta that are joined at
// a square of four edges. Curves that are read are compared with the oracle. Returns whether the file was read.
inline bool run_curve_reader_target(const std::uint8_t* data, std::size_t size, Tally& tally)
{
  if(size == 0)
    return false;
  static const Body body = waist();
  // from a file, so that the corners of faces have the order of the file
  static const constrictions::Mesh mesh = [] {
    std::ostringstream text;
    text << "OFF\n" << body.points.size() << ' ' << body.faces.size() << " 0\n";
    for(const auto& p : body.points)
      text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const auto& f : body.faces)
      text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
    return constrictions::read_mesh_file(Temporary_file(".off", text.str().data(), text.str().size()).name());
  }();
  constrictions::File_numbering numbering;
  numbering.vertices = mesh.number_of_vertices();
  numbering.faces = mesh.number_of_faces();
  const Temporary_file file(".txt", data + 1, size - 1);
  switch(data[0] % 8)
  {
  case 0:
    return is_read([&] {
      for(const auto& loop : constrictions::read_loops_file(file.name(), mesh, numbering).vertices)
        for(auto v : loop)
          if(static_cast<std::size_t>(v) >= mesh.number_of_vertices())
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
    Certificate_comparison comparison(body, mesh, tally);
    for(const Constriction& c : curves.curves)
      comparison.compare(c, certify_constriction(mesh, c));
    return true;
  }
  }
}

} // namespace fuzz

#endif // FUZZ_READER_TARGETS_H
