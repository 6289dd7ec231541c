// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/number_type.h"
#include "input/readers.h"
#include "input/text_scanner.h"
#include "input/triangle_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

std::optional<Number_type> type_of(const std::string& word)
{
  const std::array<std::pair<std::string_view, Number_type>, 14> names = {{{"char", Number_type::INT8},
                                                                           {"signed_char", Number_type::INT8},
                                                                           {"unsigned_char", Number_type::UINT8},
                                                                           {"short", Number_type::INT16},
                                                                           {"unsigned_short", Number_type::UINT16},
                                                                           {"int", Number_type::INT32},
                                                                           {"unsigned_int", Number_type::UINT32},
                                                                           {"vtkidtype", Number_type::INT32},
                                                                           {"long", Number_type::INT64},
                                                                           {"unsigned_long", Number_type::UINT64},
                                                                           {"vtktypeint64", Number_type::INT64},
                                                                           {"vtktypeuint64", Number_type::UINT64},
                                                                           {"float", Number_type::FLOAT32},
                                                                           {"double", Number_type::FLOAT64}}};
  for(const auto& [name, type] : names)
    if(word == name)
      return type;
  return std::nullopt;
}

// Reads the words of a file, and the numbers behind them, in words or in bytes.
class Vtk_reader
{
public:
  explicit Vtk_reader(const Input_file& file) : m_file(file), m_scanner(file, 0, '\0') {}

  Polygon_soup read()
  {
    read_header();
    // data of points and cells stand behind the cells
    for(std::string word = keyword(); !word.empty() && word != "point_data" && word != "cell_data"; word = keyword())
      if(word == "points")
        read_points();
      else if(word == "polygons" || word == "triangle_strips" || word == "vertices" || word == "lines" ||
              word == "cells")
        read_cells(word);
      else if(word == "cell_types")
        read_cell_types();
      else if(word == "field")
        skip_field();
      else if(word == "metadata")
        skip_metadata();
      else
        m_scanner.fail("unknown keyword " + constrictions::quoted(word));
    make_faces();
    return std::move(m_soup);
  }

private:
  struct Cells
  {
    std::vector<long long> corners;
    std::vector<std::size_t> ends;
  };

  std::string keyword() { return lower_case(m_scanner.word_of_text()); }

  // The first line says that it is a VTK file, the second is a title.
  void read_header()
  {
    m_scanner.next_line();
    m_scanner.skip_line();
    m_scanner.skip_line();
    const std::string encoding = keyword();
    m_is_binary = encoding == "binary";
    if(!m_is_binary && encoding != "ascii")
      m_scanner.fail_at_word("VTK header", "ASCII or BINARY");
    if(keyword() != "dataset")
      m_scanner.fail_at_word("VTK header", "DATASET");
    const std::string type = lower_case(m_scanner.word());
    if(type != "polydata" && type != "unstructured_grid")
      m_scanner.fail("a VTK file of type " + constrictions::quoted(type) + ", not POLYDATA or UNSTRUCTURED_GRID");
  }

  std::size_t count(const std::string& of)
  {
    std::size_t result = 0;
    if(!m_scanner.read(result))
      m_scanner.fail_at_word(of, "a number");
    return result;
  }

  Number_type type(const std::string& of)
  {
    const std::optional<Number_type> result = type_of(lower_case(m_scanner.word()));
    if(!result)
      m_scanner.fail_at_word(of, "a type of VTK");
    return *result;
  }

  // Calls f with n numbers; bytes have the most significant first, and begin in the line behind the present one.
  template <class F>
  void for_each_number(const std::string& what, std::size_t n, Number_type type, F f)
  {
    if(!m_is_binary)
    {
      for(std::size_t i = 0; i < n; ++i)
      {
        double x = 0;
        if(!Text_scanner::parse(m_scanner.word_of_text(), x))
          m_scanner.fail_at_word(what + ", number " + std::to_string(i) + " of " + std::to_string(n), "a number");
        f(x);
      }
      return;
    }
    m_scanner.skip_line();
    const std::size_t begin = m_scanner.offset(), size = size_of(type);
    if(m_scanner.remaining() / size < n)
      m_file.fail(what + ": the file ends at number " + std::to_string(m_scanner.remaining() / size) + " of " +
                  std::to_string(n));
    for(std::size_t i = 0; i < n; ++i)
      f(number_of_type(type, m_file.content.data() + begin + i * size, false));
    m_scanner = Text_scanner(m_file, begin + n * size, '\0');
  }

  void read_points()
  {
    const std::size_t n = count("POINTS");
    const Number_type of_coordinates = type("POINTS");
    if(n > m_file.content.size())
      m_scanner.fail("POINTS: the file is too short for " + std::to_string(n));
    std::array<double, 3> p = {0, 0, 0};
    std::size_t i = 0;
    for_each_number("POINTS", 3 * n, of_coordinates, [&](double x) {
      p[i++ % 3] = x;
      if(i % 3 == 0)
        m_soup.points.emplace_back(p[0], p[1], p[2]);
    });
  }

  static long long integer(double x)
  {
    return std::abs(x) < 1e15 && x == std::floor(x) ? static_cast<long long>(x) : -1;
  }

  // Since version 5 there are two arrays, of offsets and of corners; before, the number of corners of each cell stands
  // in front of them.
  void read_cells(const std::string& section)
  {
    const std::size_t n = count(section), size = count(section);
    if((std::max)(n, size) > m_file.content.size())
      m_scanner.fail(section + ": the file is too short for " + std::to_string((std::max)(n, size)) + " numbers");
    Cells& cells = section == "polygons"          ? m_polygons
                   : section == "triangle_strips" ? m_strips
                   : section == "cells"           ? m_cells
                                                  : m_others;
    cells = Cells();
    Text_scanner ahead = m_scanner;
    if(lower_case(ahead.word_of_text()) == "offsets")
      read_offsets(section, n, size, cells);
    else
      read_counted(section, n, size, cells);
  }

  void read_offsets(const std::string& section, std::size_t n, std::size_t size, Cells& cells)
  {
    keyword();
    Number_type of_numbers = type(section);
    for_each_number(section, n, of_numbers,
                    [&](double x) { cells.ends.push_back(static_cast<std::size_t>(integer(x))); });
    if(keyword() != "connectivity")
      m_scanner.fail_at_word(section, "CONNECTIVITY");
    of_numbers = type(section);
    for_each_number(section, size, of_numbers, [&](double x) { cells.corners.push_back(integer(x)); });
    if(!cells.ends.empty())
      cells.ends.erase(cells.ends.begin()); // where the first cell begins
    std::size_t begin = 0;
    for(std::size_t end : cells.ends)
    {
      if(end < begin || end > size)
        m_file.fail(section + ": a cell goes from corner " + std::to_string(begin) + " to " + std::to_string(end) +
                    " of " + std::to_string(size));
      begin = end;
    }
  }

  void read_counted(const std::string& section, std::size_t n, std::size_t size, Cells& cells)
  {
    long long left = 0;
    for_each_number(section, size, Number_type::INT32, [&](double x) {
      if(left > 0)
      {
        cells.corners.push_back(integer(x));
        --left;
        return;
      }
      left = integer(x);
      cells.ends.push_back(cells.corners.size() + static_cast<std::size_t>((std::max)(left, 0ll)));
      if(left < 0)
        m_file.fail(section + ": cell " + std::to_string(cells.ends.size() - 1) + " has " + std::to_string(x) +
                    " corners");
    });
    if(left > 0 || cells.ends.size() != n)
      m_file.fail(section + ": " + std::to_string(size) + " numbers are not those of " + std::to_string(n) + " cells");
  }

  void read_cell_types()
  {
    const std::size_t n = count("CELL_TYPES");
    for_each_number("CELL_TYPES", n, Number_type::INT32, [&](double x) { m_types.push_back(integer(x)); });
  }

  // Arrays that belong to the whole.
  void skip_field()
  {
    m_scanner.word();
    const std::size_t n = count("FIELD");
    for(std::size_t i = 0; i < n; ++i)
    {
      const std::string_view word_of_name = m_scanner.word_of_text();
      if(word_of_name.empty())
        m_scanner.fail_at_word("FIELD", "an array");
      const std::string name = constrictions::quoted(word_of_name);
      const std::size_t components = count(name), tuples = count(name);
      if(components > 0 && tuples > m_file.content.size() / components)
        m_scanner.fail(name + ": the file is too short for it");
      const std::string word = lower_case(m_scanner.word());
      if(word == "string")
        skip_strings(components * tuples);
      else if(const std::optional<Number_type> of_numbers = type_of(word))
        for_each_number(name, components * tuples, *of_numbers, [](double) {});
      else
        m_scanner.fail_at_word(name, "a type of VTK");
      Text_scanner ahead = m_scanner;
      if(lower_case(ahead.word_of_text()) == "metadata")
      {
        m_scanner = ahead;
        skip_metadata();
      }
    }
  }

  // In bytes a string has its length in front, in as many bytes as its two highest bits say.
  void skip_strings(std::size_t n)
  {
    m_scanner.skip_line();
    for(std::size_t i = 0; i < n; ++i)
    {
      if(!m_is_binary)
      {
        m_scanner.skip_line();
        continue;
      }
      std::size_t begin = m_scanner.offset();
      if(m_scanner.remaining() == 0)
        m_file.fail("FIELD: the file ends within a string");
      const unsigned char first = static_cast<unsigned char>(m_file.content[begin]);
      const std::size_t bytes = std::size_t(1) << (3 - (first >> 6));
      std::size_t length = first & 63;
      for(std::size_t b = 1; b < bytes && begin + b < m_file.content.size(); ++b)
        length = length << 8 | static_cast<unsigned char>(m_file.content[begin + b]);
      if(bytes > m_scanner.remaining() || length > m_scanner.remaining() - bytes)
        m_file.fail("FIELD: the file ends within a string");
      m_scanner = Text_scanner(m_file, begin + bytes + length, '\0');
    }
  }

  // It ends with an empty line.
  void skip_metadata()
  {
    m_scanner.skip_line();
    while(m_scanner.remaining() > 0)
    {
      const std::size_t begin = m_scanner.offset();
      const bool is_empty = m_scanner.word().empty();
      m_scanner.skip_line();
      if(is_empty || m_scanner.offset() == begin)
        return;
    }
  }

  template <class F>
  void for_each_corner(const Cells& cells, F f) const
  {
    std::size_t begin = 0;
    for(std::size_t c = 0; c < cells.ends.size(); ++c)
    {
      for(std::size_t i = begin; i < cells.ends[c]; ++i)
        f(c, i - begin, cells.ends[c] - begin, cells.corners[i]);
      begin = cells.ends[c];
    }
  }

  Index vertex(long long v) const { return checked_index(m_soup.number_of_faces(), v, m_soup.points.size()); }

  void make_faces()
  {
    const auto add_to_face = [this](std::size_t corner, std::size_t size, long long v) {
      m_soup.corners.push_back(vertex(v));
      if(corner + 1 == size)
        m_soup.end_face();
    };
    for_each_corner(m_polygons, [&](std::size_t, std::size_t corner, std::size_t size, long long v) {
      add_to_face(corner, size, v);
    });
    Triangle_strip strip(m_soup);
    const auto add_to_strip = [&](std::size_t corner, long long v) {
      if(corner == 0)
        strip.begin();
      strip.add(vertex(v));
    };
    for_each_corner(m_strips,
                    [&](std::size_t, std::size_t corner, std::size_t, long long v) { add_to_strip(corner, v); });

    if(m_types.size() != m_cells.ends.size())
      m_file.fail(std::to_string(m_types.size()) + " CELL_TYPES for " + std::to_string(m_cells.ends.size()) + " CELLS");
    // of points, lines and surfaces; others are solids
    const long long triangle = 5, triangle_strip = 6, polygon = 7, quad = 9, polyline = 4;
    for(std::size_t c = 0; c < m_types.size(); ++c)
      if(m_types[c] > polyline && m_types[c] != triangle && m_types[c] != triangle_strip && m_types[c] != polygon &&
         m_types[c] != quad)
        m_file.fail("cell " + std::to_string(c) + " is of type " + std::to_string(m_types[c]) +
                    ", not a triangle, quad, polygon or triangle strip; extract the surface first");
    for_each_corner(m_cells, [&](std::size_t c, std::size_t corner, std::size_t size, long long v) {
      if(m_types[c] == triangle_strip)
        add_to_strip(corner, v);
      else if(m_types[c] > polyline)
        add_to_face(corner, size, v);
    });
  }

  const Input_file& m_file;
  Text_scanner m_scanner;
  bool m_is_binary = false;
  Polygon_soup m_soup;
  Cells m_polygons, m_strips, m_cells, m_others;
  std::vector<long long> m_types;
};

} // namespace

Polygon_soup read_vtk(const Input_file& file) { return Vtk_reader(file).read(); }

} // namespace constrictions
