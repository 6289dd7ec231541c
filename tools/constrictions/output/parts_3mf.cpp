// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/colours.h"
#include "output/parts.h"
#include "zip_archive.h"

#include <cstddef>
#include <cstdio>
#include <sstream>
#include <vector>

namespace constrictions {

namespace {

std::string colour_as_text(const Colour& colour)
{
  char text[8];
  std::snprintf(text, sizeof(text), "#%02X%02X%02X", colour[0], colour[1], colour[2]);
  return text;
}

void write_object(const Mesh& mesh, std::size_t part, std::ostream& out)
{
  out << "<object id=\"" << part + 2 << "\" type=\"model\" name=\"part_" << part << "\" pid=\"1\" pindex=\"" << part
      << "\"><mesh><vertices>\n";
  std::vector<std::size_t> number(mesh.num_vertices());
  std::size_t n = 0;
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    number[v] = n++;
    const Point& p = mesh.point(v);
    out << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>\n";
  }
  out << "</vertices><triangles>\n";
  for(Mesh::Face_index f : mesh.faces())
  {
    int corner = 0;
    out << "<triangle";
    for(Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << " v" << ++corner << "=\"" << number[v] << '"';
    out << "/>\n";
  }
  out << "</triangles></mesh></object>\n";
}

} // namespace

std::string parts_as_3mf(const Parts& parts)
{
  std::ostringstream model;
  model.precision(17);
  model << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\""
        << (parts.unit.empty() ? "millimeter" : parts.unit)
        << "\" xml:lang=\"en\" "
           "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
           "<metadata name=\"Application\">constrictions</metadata>\n"
           "<resources>\n"
           "<basematerials id=\"1\">\n";
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
    model << "<base name=\"part_" << p << "\" displaycolor=\"" << colour_as_text(part_colour(p)) << "\"/>\n";
  model << "</basematerials>\n";
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
    write_object(parts.parts[p].mesh, p, model);
  model << "</resources>\n<build>\n";
  for(std::size_t p = 0; p < parts.parts.size(); ++p)
    model << "<item objectid=\"" << p + 2 << "\"/>\n";
  model << "</build>\n</model>\n";

  return zip_of(
      {{"[Content_Types].xml",
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
        "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
        "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
        "</Types>\n"},
       {"_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                       "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
                       "</Relationships>\n"},
       {"3D/3dmodel.model", model.str()}});
}

} // namespace constrictions
