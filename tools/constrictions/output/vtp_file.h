// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_VTP_FILE_H
#define CONSTRICTIONS_VTP_FILE_H

#include "input/mesh_file.h"
#include "output/colours.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace constrictions {

/// Points and cells, lines or polygons, with data, as a file of VTK's XML format for PolyData, which ParaView reads.
/// Numbers are in binary, encoded in base64.
class Vtp_file
{
public:
  enum Cells
  {
    LINES,
    POLYGONS
  };

  explicit Vtp_file(Cells cells) : m_cells(cells) {}

  void add_point(const Mesh::Point& p);

  /// adds a line through points, or a polygon with these corners.
  void add_cell(const std::vector<std::size_t>& points);

  /// \name Data
  /// One number, or colour, for each point or each cell.
  /// @{
  void add_point_data(const std::string& name, const std::vector<std::uint8_t>& data);
  void add_cell_data(const std::string& name, const std::vector<double>& data);
  void add_cell_data(const std::string& name, const std::vector<std::int32_t>& data);
  void add_cell_data(const std::string& name, const std::vector<Colour>& data);
  /// @}

  /// makes data of cells, of one number each, those that a viewer shows in colours at first.
  void show_cell_data(const std::string& name) { m_shown = name; }

  std::string text() const;

private:
  Cells m_cells;
  std::vector<double> m_coordinates;
  std::vector<std::int64_t> m_connectivity, m_offsets;
  std::string m_point_data, m_cell_data, m_shown;
};

} // namespace constrictions

#endif // CONSTRICTIONS_VTP_FILE_H
