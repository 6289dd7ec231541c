// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/vtp_file.h"

#include "output/base64.h"
#include "output/little_endian.h"

namespace constrictions {

namespace {

// An element with the bytes of an array, after their number.
template <class Number>
std::string data_array(const char* type, const std::string& name, std::size_t components,
                       const std::vector<Number>& numbers)
{
  std::string bytes;
  append_little_endian(static_cast<std::uint64_t>(numbers.size() * sizeof(Number)), bytes);
  for(Number n : numbers)
    append_little_endian(n, bytes);
  return std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"binary\">" + as_base64(bytes) + "</DataArray>\n";
}

} // namespace

void Vtp_file::add_point(const Mesh::Point& p) { m_coordinates.insert(m_coordinates.end(), {p.x(), p.y(), p.z()}); }

void Vtp_file::add_cell(const std::vector<std::size_t>& points)
{
  for(std::size_t p : points)
    m_connectivity.push_back(static_cast<std::int64_t>(p));
  m_offsets.push_back(static_cast<std::int64_t>(m_connectivity.size()));
}

void Vtp_file::add_point_data(const std::string& name, const std::vector<std::uint8_t>& data)
{
  m_point_data += data_array("UInt8", name, 1, data);
}

void Vtp_file::add_cell_data(const std::string& name, const std::vector<double>& data)
{
  m_cell_data += data_array("Float64", name, 1, data);
}

void Vtp_file::add_cell_data(const std::string& name, const std::vector<std::int32_t>& data)
{
  m_cell_data += data_array("Int32", name, 1, data);
}

void Vtp_file::add_cell_data(const std::string& name, const std::vector<Colour>& data)
{
  std::vector<std::uint8_t> numbers;
  for(const Colour& c : data)
    numbers.insert(numbers.end(), c.begin(), c.end());
  m_cell_data += data_array("UInt8", name, 3, numbers);
}

std::string Vtp_file::text() const
{
  const std::string number = std::to_string(m_offsets.size());
  const char* const element = m_cells == LINES ? "Lines" : "Polys";
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         "<PolyData>\n"
         "<Piece NumberOfPoints=\"" +
         std::to_string(m_coordinates.size() / 3) + "\" NumberOfVerts=\"0\" NumberOfLines=\"" +
         (m_cells == LINES ? number : "0") + "\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         (m_cells == POLYGONS ? number : "0") +
         "\">\n"
         "<PointData>\n" +
         m_point_data +
         "</PointData>\n"
         "<CellData" +
         (m_shown.empty() ? "" : " Scalars=\"" + m_shown + '"') + ">\n" + m_cell_data +
         "</CellData>\n"
         "<Points>\n" +
         data_array("Float64", "Points", 3, m_coordinates) +
         "</Points>\n"
         "<" +
         element + ">\n" + data_array("Int64", "connectivity", 1, m_connectivity) +
         data_array("Int64", "offsets", 1, m_offsets) + "</" + element +
         ">\n"
         "</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace constrictions
