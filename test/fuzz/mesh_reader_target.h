// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_MESH_READER_TARGET_H
#define FUZZ_MESH_READER_TARGET_H

#include "failure.h"
#include "files.h"

#include "input/mesh_file.h"
#include "output/mesh_as_text.h"
#include "zip_archive.h"

#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz {

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

} // namespace fuzz

#endif // FUZZ_MESH_READER_TARGET_H
