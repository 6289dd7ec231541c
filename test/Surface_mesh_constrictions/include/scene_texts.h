// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SCENE_TEXTS_H
#define SCENE_TEXTS_H

#include "include/mesh_texts.h"

#include "output/base64.h"
#include "zip_archive.h"

#include <zlib.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

// Meshes as files of VTK, and of scenes that put meshes somewhere.
namespace scene_texts {

using namespace mesh_texts;

inline std::vector<double> coordinates(const Soup& soup)
{
  std::vector<double> result;
  for(const Position& p : soup.points)
    result.insert(result.end(), p.begin(), p.end());
  return result;
}

template <class To, class From>
std::string bytes_of(const std::vector<From>& numbers, bool big_endian = false)
{
  std::string result;
  for(From x : numbers)
    result += bytes(static_cast<To>(x), big_endian);
  return result;
}

inline std::vector<long long> corners(const Soup& soup)
{
  std::vector<long long> result;
  for(const Triangle& t : soup.triangles)
    result.insert(result.end(), t.begin(), t.end());
  return result;
}

inline std::vector<long long> ends_of_triangles(const Soup& soup)
{
  std::vector<long long> result;
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
    result.push_back(static_cast<long long>(3 * t + 3));
  return result;
}

/// \name Legacy files of VTK
/// @{
inline std::string vtk_header(const std::string& encoding, const std::string& version = "3.0")
{
  return "# vtk DataFile Version " + version + "\nmade by a test\n" + encoding + "\nDATASET POLYDATA\n";
}

inline std::string ascii_vtk(const Soup& soup)
{
  const std::string n = std::to_string(soup.triangles.size());
  return vtk_header("ASCII") + "POINTS " + std::to_string(soup.points.size()) + " float\n" + points_as_text(soup) +
         "POLYGONS " + n + ' ' + std::to_string(4 * soup.triangles.size()) + '\n' + faces_as_text(soup, "3") +
         "CELL_DATA " + n + "\nSCALARS something int\n";
}

inline std::string binary_vtk(const Soup& soup)
{
  std::string result = vtk_header("BINARY") + "POINTS " + std::to_string(soup.points.size()) + " double\n" +
                       bytes_of<double>(coordinates(soup), true) + "\nPOLYGONS " +
                       std::to_string(soup.triangles.size()) + ' ' + std::to_string(4 * soup.triangles.size()) + '\n';
  for(const Triangle& t : soup.triangles)
    result += bytes(3, true) + bytes(t[0], true) + bytes(t[1], true) + bytes(t[2], true);
  return result + '\n';
}

// With two arrays for the cells, and with data in front and between.
inline std::string binary_vtk_5(const Soup& soup)
{
  const std::string n = std::to_string(soup.triangles.size() + 1), m = std::to_string(3 * soup.triangles.size());
  return vtk_header("BINARY", "5.1") + "FIELD FieldData 2\nTimeValue 1 1 double\n" + bytes(0.5, true) +
         "\nName 1 1 string\n" + std::string("\xC5hello\n") + "POINTS " + std::to_string(soup.points.size()) +
         " float\n" + bytes_of<float>(coordinates(soup), true) +
         "\nMETADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1\n\nPOLYGONS " + n + ' ' + m +
         "\nOFFSETS vtktypeint64\n" + bytes(std::int64_t(0), true) +
         bytes_of<std::int64_t>(ends_of_triangles(soup), true) + "\nCONNECTIVITY vtktypeint64\n" +
         bytes_of<std::int64_t>(corners(soup), true) + "\nMETADATA\nINFORMATION 0\n\n";
}
/// @}

/// \name VTP
/// @{
struct Vtp_spelling
{
  std::string format; // ascii, binary, appended
  bool is_raw = false, is_big = false, has_long_header = false, is_compressed = false, has_doubles = false;
};

inline std::string packed(const std::string& bytes)
{
  std::string result(compressBound(static_cast<uLong>(bytes.size())), '\0');
  uLongf size = static_cast<uLongf>(result.size());
  EXPECT_EQ(compress(reinterpret_cast<Bytef*>(&result[0]), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                     static_cast<uLong>(bytes.size())),
            Z_OK);
  result.resize(size);
  return result;
}

class Vtp_text
{
public:
  Vtp_text(const Soup& soup, const Vtp_spelling& spelling) : m_spelling(spelling)
  {
    const std::vector<double> points = coordinates(soup);
    const std::string of_points = spelling.has_doubles
                                      ? array("Float64", "Points", 3, points, bytes_of<double>(points, spelling.is_big))
                                      : array("Float32", "Points", 3, points, bytes_of<float>(points, spelling.is_big));
    const std::vector<long long> of_faces = corners(soup), ends = ends_of_triangles(soup);
    const std::string connectivity = array("Int64", "connectivity", 1, of_faces,
                                           bytes_of<std::int64_t>(of_faces, spelling.is_big)),
                      offsets = array("Int32", "offsets", 1, ends, bytes_of<std::int32_t>(ends, spelling.is_big));
    text = std::string("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"") +
           (spelling.is_big ? "BigEndian" : "LittleEndian") + "\" header_type=\"" +
           (spelling.has_long_header ? "UInt64" : "UInt32") + '"' +
           (spelling.is_compressed ? " compressor=\"vtkZLibDataCompressor\"" : "") +
           ">\n<PolyData><Piece NumberOfPoints=\"" + std::to_string(soup.points.size()) +
           "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
           std::to_string(soup.triangles.size()) + "\">\n<PointData></PointData>\n<Points>\n" + of_points +
           "</Points>\n<Polys>\n" + connectivity + offsets + "</Polys>\n</Piece></PolyData>\n" + appended() +
           "</VTKFile>\n";
  }

  std::string text;

private:
  std::string size(std::size_t n) const
  {
    return m_spelling.has_long_header ? bytes(static_cast<std::uint64_t>(n), m_spelling.is_big)
                                      : bytes(static_cast<std::uint32_t>(n), m_spelling.is_big);
  }

  // What is written of the bytes of an array, and of a compressed one the header by itself.
  std::string written(const std::string& bytes) const
  {
    const auto encoded = [this](const std::string& b) { return m_spelling.is_raw ? b : constrictions::as_base64(b); };
    if(!m_spelling.is_compressed)
      return encoded(size(bytes.size()) + bytes);
    const std::size_t block = 64;
    std::string blocks, sizes;
    std::size_t n = 0;
    for(std::size_t begin = 0; begin < bytes.size(); begin += block, ++n)
    {
      const std::string p = packed(bytes.substr(begin, block));
      blocks += p;
      sizes += size(p.size());
    }
    return encoded(size(n) + size(block) + size(bytes.size() % block) + sizes) + encoded(blocks);
  }

  template <class Number>
  std::string array(const std::string& type, const std::string& name, int components,
                    const std::vector<Number>& numbers, const std::string& bytes)
  {
    const std::string begin = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                              std::to_string(components) + "\" format=\"" + m_spelling.format + '"';
    // what some programs write inside an array
    const std::string inside = "<InformationKey name=\"RANGE\" location=\"vtkDataArray\" length=\"1\">"
                               "<Value index=\"0\">1.7</Value></InformationKey>\n";
    if(m_spelling.format == "appended")
    {
      const std::string result =
          begin + " offset=\"" + std::to_string(m_appended.size()) + "\">" + inside + "</DataArray>\n";
      m_appended += written(bytes);
      return result;
    }
    std::ostringstream out;
    out << begin << ">\n";
    if(m_spelling.format == "ascii")
      for(Number x : numbers)
        out << x << ' ';
    else
      out << "  " << written(bytes);
    out << '\n' << inside << "</DataArray>\n";
    return out.str();
  }

  std::string appended() const
  {
    if(m_spelling.format != "appended")
      return "";
    return std::string("<AppendedData encoding=\"") + (m_spelling.is_raw ? "raw" : "base64") + "\">\n _" + m_appended +
           "\n</AppendedData>\n";
  }

  Vtp_spelling m_spelling;
  std::string m_appended;
};
/// @}

/// \name GLB
/// @{
inline std::string chunk(const std::string& type, std::string data, char padding)
{
  data.resize((data.size() + 3) / 4 * 4, padding);
  return bytes(static_cast<std::uint32_t>(data.size())) + type + data;
}

inline std::string glb_of(const std::string& json, const std::string& numbers)
{
  const std::string chunks = chunk("JSON", json, ' ') + chunk(std::string("BIN\0", 4), numbers, '\0');
  return "glTF" + bytes(std::uint32_t(2)) + bytes(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

// A scene of these nodes, in each of which the mesh may be.
inline std::string glb(const Soup& soup, const std::string& nodes = "[{\"mesh\": 0}]", const std::string& scene = "[0]")
{
  const std::string points = bytes_of<float>(coordinates(soup)), of_faces = bytes_of<std::uint16_t>(corners(soup));
  const std::string json =
      "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": " + scene +
      "}], \"nodes\": " + nodes +
      ", \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}, \"indices\": 1},"
      " {\"attributes\": {\"POSITION\": 0}, \"mode\": 1}]}],"
      " \"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": " +
      std::to_string(soup.points.size()) +
      ", \"type\": \"VEC3\"}, {\"bufferView\": 1, \"componentType\": 5123, \"count\": " +
      std::to_string(3 * soup.triangles.size()) +
      ", \"type\": \"SCALAR\"}], \"bufferViews\": [{\"buffer\": 0, \"byteLength\": " + std::to_string(points.size()) +
      "}, {\"buffer\": 0, \"byteOffset\": " + std::to_string(points.size()) +
      ", \"byteLength\": " + std::to_string(of_faces.size()) +
      "}], \"buffers\": [{\"byteLength\": " + std::to_string(points.size() + of_faces.size()) + "}]}";
  return glb_of(json, points + of_faces);
}
/// @}

/// \name 3MF
/// @{
inline std::string object_3mf(const Soup& soup, const std::string& id)
{
  std::ostringstream out;
  out << "<object id=\"" << id << "\" type=\"model\"><mesh><vertices>";
  for(const Position& p : soup.points)
    out << "<vertex x=\"" << p[0] << "\" y=\"" << p[1] << "\" z=\"" << p[2] << "\"/>";
  out << "</vertices><triangles>";
  for(const Triangle& t : soup.triangles)
    out << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>";
  out << "</triangles></mesh></object>";
  return out.str();
}

// A model in inches.
inline std::string model_3mf(const std::string& objects, const std::string& items)
{
  return "<?xml version=\"1.0\"?>\n<model unit=\"inch\" xmlns="
         "\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" xmlns:p="
         "\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" xmlns:x=\"urn:x\">\n<resources>" +
         objects + "<x:object id=\"1\"/></resources><build>" + items + "</build></model>";
}

inline std::string archive_3mf(const std::string& model, const std::vector<constrictions::Zip_entry>& others = {})
{
  std::vector<constrictions::Zip_entry> entries = {
      {"_rels/.rels", "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                      "<Relationship Target=\"/3D/model.model\" Id=\"r\" Type="
                      "\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
      {"3D/model.model", model}};
  entries.insert(entries.end(), others.begin(), others.end());
  return constrictions::zip_of(entries);
}

// What a mesh file holds, with the numbers as another unit.
inline std::string in_3mf(const std::string& mesh_file, const std::string& unit)
{
  const Mesh mesh = constrictions::read_mesh_file(mesh_file);
  Soup soup;
  for(Mesh::Vertex_index v : mesh.vertices())
    soup.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  for(Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back({mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return archive_3mf(
      replaced(model_3mf(object_3mf(soup, "1"), "<item objectid=\"1\"/>"), "\"inch\"", '"' + unit + '"'));
}
/// @}

} // namespace scene_texts

#endif // SCENE_TEXTS_H
