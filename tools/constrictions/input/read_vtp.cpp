// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/from_base64.h"
#include "input/number_type.h"
#include "input/read_xml.h"
#include "input/readers.h"
#include "input/text_scanner.h"
#include "input/triangle_strip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef std::vector<double> Numbers;

struct Data_array
{
  std::string type, format;
  std::size_t components = 1;
  std::size_t offset = 0; // of what is appended
  std::string text;       // of what is not
};

// Each with its own points. Arrays are known by the element that they are in and their own name.
struct Piece
{
  std::size_t points = 0, polygons = 0, strips = 0;
  std::map<std::string, Data_array> arrays;
};

struct Vtk_file
{
  bool is_little_endian = true;
  std::size_t bytes_of_header = 4;
  std::string compressor;
  bool is_raw = false; // what is appended
  std::vector<Piece> pieces;
};

template <class Number>
Number number(const Xml_element& element, std::string_view name, Number by_default)
{
  const std::optional<std::string_view> text = element.attribute(name);
  Number result = by_default;
  if(text && !Text_scanner::parse(*text, result))
    throw Xml_failure{constrictions::quoted(name) + " of " + std::string(element.name()) + " is " +
                      constrictions::quoted(*text) + ", not a number"};
  return result;
}

std::string word(const Xml_element& element, std::string_view name)
{
  return std::string(element.attribute(name).value_or(""));
}

class Vtp_handler : public Xml_handler
{
public:
  explicit Vtp_handler(Vtk_file& file) : m_file(file) {}

  void begin(const Xml_element& element) override
  {
    const std::string_view name = element.name();
    if(m_array != nullptr)
      ++m_depth; // information about the array
    else if(name == "VTKFile")
      begin_file(element);
    else if(name == "Piece")
    {
      const std::size_t none = 0;
      m_file.pieces.push_back({number(element, "NumberOfPoints", none),
                               number(element, "NumberOfPolys", none),
                               number(element, "NumberOfStrips", none),
                               {}});
    }
    else if(name == "AppendedData")
      m_file.is_raw = word(element, "encoding") == "raw";
    else if(name != "DataArray")
      m_section = name;
    else if(!m_file.pieces.empty() && (m_section == "Points" || m_section == "Polys" || m_section == "Strips"))
      begin_array(element);
  }

  void end(std::string_view name) override
  {
    if(m_array == nullptr)
      m_section = name == m_section ? "" : m_section;
    else if(m_depth > 0)
      --m_depth;
    else
      m_array = nullptr;
  }

  void text(std::string_view text) override
  {
    if(m_array != nullptr && m_depth == 0)
      m_array->text += text;
  }

private:
  void begin_file(const Xml_element& element)
  {
    const std::string type = word(element, "type");
    if(type != "PolyData")
      throw Xml_failure{"a VTK file of type " + constrictions::quoted(type) + ", not PolyData"};
    m_file.is_little_endian = word(element, "byte_order") != "BigEndian";
    m_file.bytes_of_header = word(element, "header_type") == "UInt64" ? 8 : 4;
    m_file.compressor = word(element, "compressor");
  }

  void begin_array(const Xml_element& element)
  {
    const std::string name = m_section == "Points" ? m_section : m_section + ' ' + word(element, "Name");
    m_array = &m_file.pieces.back().arrays[name];
    *m_array = {word(element, "type"), word(element, "format"), number(element, "NumberOfComponents", std::size_t(1)),
                number(element, "offset", std::size_t(0)), ""};
    m_depth = 0;
  }

  Vtk_file& m_file;
  std::string m_section;
  Data_array* m_array = nullptr;
  std::size_t m_depth = 0; // of elements inside the array
};

std::optional<Number_type> type_of(const std::string& name)
{
  const std::array<std::string_view, 10> names = {"Int8",   "UInt8", "Int16",  "UInt16",  "Int32",
                                                  "UInt32", "Int64", "UInt64", "Float32", "Float64"};
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt
                              : std::optional<Number_type>(static_cast<Number_type>(found - names.begin()));
}

// The numbers of arrays, whatever their encoding.
class Array_reader
{
public:
  Array_reader(const Input_file& file, const Vtk_file& vtk, std::string_view appended)
    : m_file(file), m_vtk(vtk), m_appended(appended)
  {}

  // empty if the piece has no such array
  Numbers read(const Piece& piece, const std::string& name) const
  {
    const auto found = piece.arrays.find(name);
    if(found == piece.arrays.end())
      return {};
    const Data_array& array = found->second;
    if(array.format == "ascii" || array.format.empty())
      return numbers_of_text(array, name);
    if(array.format != "binary" && array.format != "appended")
      fail(name, "its format is " + constrictions::quoted(array.format));
    return numbers_of_bytes(bytes(array, name), array, name);
  }

private:
  [[noreturn]] void fail(const std::string& array, const std::string& reason) const
  {
    m_file.fail("array " + constrictions::quoted(array) + ": " + reason);
  }

  Numbers numbers_of_text(const Data_array& array, const std::string& name) const
  {
    Numbers result;
    const Input_file text{m_file.name, array.text};
    Text_scanner scanner(text, 0, '\0');
    for(std::string_view word = scanner.word_of_text(); !word.empty(); word = scanner.word_of_text())
    {
      result.push_back(0);
      if(!Text_scanner::parse(word, result.back()))
        fail(name, constrictions::quoted(word) + " is not a number");
    }
    return result;
  }

  Numbers numbers_of_bytes(const std::string& bytes, const Data_array& array, const std::string& name) const
  {
    const std::optional<Number_type> type = type_of(array.type);
    if(!type)
      fail(name, "its type is " + constrictions::quoted(array.type));
    const std::size_t size = size_of(*type);
    if(bytes.size() % size != 0)
      fail(name, std::to_string(bytes.size()) + " bytes are not a whole number of " + array.type);
    Numbers result(bytes.size() / size);
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = number_of_type(*type, bytes.data() + i * size, m_vtk.is_little_endian);
    return result;
  }

  // The first bytes of what is written for an array.
  std::string first_bytes(const Data_array& array, const std::string& name, std::size_t n) const
  {
    const bool is_appended = array.format == "appended";
    if(is_appended && array.offset > m_appended.size())
      fail(name, "the file ends before its offset " + std::to_string(array.offset));
    const std::string_view written = is_appended ? m_appended.substr(array.offset) : array.text;
    std::string result;
    if(is_appended && m_vtk.is_raw)
      result = written.substr(0, n);
    else if(const std::optional<std::string> decoded = from_base64(written.substr(0, written.find('<')), n))
      result = *decoded;
    else
      fail(name, "it is not in base64");
    if(result.size() < n)
      fail(name, "it ends after " + std::to_string(result.size()) + " of its bytes");
    return result;
  }

  std::size_t size_at(const std::string& header, std::size_t i) const
  {
    const char* const begin = header.data() + i * m_vtk.bytes_of_header;
    return m_vtk.bytes_of_header == 8
               ? static_cast<std::size_t>(number_from_bytes<std::uint64_t>(begin, m_vtk.is_little_endian))
               : number_from_bytes<std::uint32_t>(begin, m_vtk.is_little_endian);
  }

  // An array begins with the number of its bytes or, if it is compressed, with those of its blocks.
  std::string bytes(const Data_array& array, const std::string& name) const
  {
    const std::size_t most = m_file.content.size();
    const std::size_t first = size_at(first_bytes(array, name, m_vtk.bytes_of_header), 0);
    if(first > most)
      fail(name, "it announces " + std::to_string(first) + (m_vtk.compressor.empty() ? " bytes" : " blocks"));
    if(m_vtk.compressor.empty())
      return first_bytes(array, name, m_vtk.bytes_of_header + first).substr(m_vtk.bytes_of_header);
    if(m_vtk.compressor != "vtkZLibDataCompressor")
      m_file.fail("compressed by " + m_vtk.compressor + "; of VTP files only those that zlib has compressed are read");
    return first == 0 ? std::string() : inflated_blocks(array, name, first);
  }

  // The header is the number of blocks, the size of each, that of the last one if it is another, and the compressed
  // sizes.
  std::string inflated_blocks(const Data_array& array, const std::string& name, std::size_t blocks) const
  {
    const std::size_t bytes_of_header = (3 + blocks) * m_vtk.bytes_of_header;
    const std::string header = first_bytes(array, name, bytes_of_header);
    const std::size_t size = size_at(header, 1), last_size = size_at(header, 2) == 0 ? size : size_at(header, 2);
    std::size_t packed_size = 0;
    for(std::size_t b = 0; b < blocks; ++b)
    {
      const std::size_t of_block = size_at(header, 3 + b), unpacked = b + 1 == blocks ? last_size : size;
      // zlib packs 1032 bytes into one, and no more
      if(of_block > m_file.content.size() || unpacked / 1040 > of_block)
        fail(name, "block " + std::to_string(b) + " is damaged");
      packed_size += of_block;
    }
    const std::string packed = first_bytes(array, name, bytes_of_header + packed_size);
    std::string result;
    std::size_t begin = bytes_of_header;
    for(std::size_t b = 0; b < blocks; ++b)
    {
      const std::size_t of_block = size_at(header, 3 + b), filled = result.size();
      uLongf unpacked = b + 1 == blocks ? last_size : size;
      const uLongf announced = unpacked;
      result.resize(filled + unpacked);
      const int status = uncompress(reinterpret_cast<Bytef*>(&result[filled]), &unpacked,
                                    reinterpret_cast<const Bytef*>(packed.data() + begin), of_block);
      if(status != Z_OK || unpacked != announced)
        fail(name, "block " + std::to_string(b) + " is damaged");
      begin += of_block;
    }
    return result;
  }

  const Input_file& m_file;
  const Vtk_file& m_vtk;
  std::string_view m_appended;
};

// Adds the points and faces of pieces to a soup, one after the other.
class Piece_reader
{
public:
  Piece_reader(const Input_file& file, const Array_reader& arrays, Polygon_soup& soup)
    : m_file(file), m_arrays(arrays), m_soup(soup)
  {}

  void read(const Piece& piece, std::size_t number)
  {
    m_place = "piece " + std::to_string(number) + ": ";
    const std::size_t first = m_soup.points.size();
    const Numbers points = m_arrays.read(piece, "Points");
    if(points.size() % 3 != 0 || points.size() / 3 != piece.points)
      m_file.fail(m_place + std::to_string(points.size()) + " coordinates for " + std::to_string(piece.points) +
                  " points");
    for(std::size_t i = 0; i < points.size(); i += 3)
      m_soup.points.emplace_back(points[i], points[i + 1], points[i + 2]);

    for_each_corner(piece, "Polys", piece.polygons, [&](std::size_t corner, std::size_t size, long long v) {
      m_soup.corners.push_back(vertex(first, v));
      if(corner + 1 == size)
        m_soup.end_face();
    });
    Triangle_strip strip(m_soup);
    for_each_corner(piece, "Strips", piece.strips, [&](std::size_t corner, std::size_t, long long v) {
      if(corner == 0)
        strip.begin();
      strip.add(vertex(first, v));
    });
  }

private:
  Index vertex(std::size_t first, long long v) const
  {
    const std::size_t n = m_soup.points.size() - first;
    return static_cast<Index>(first + checked_index(m_soup.number_of_faces(), v, n));
  }

  long long integer(double x, const std::string& name) const
  {
    const double largest = 1e15;
    if(!(std::abs(x) < largest) || x != std::floor(x))
      m_file.fail(m_place + "array " + constrictions::quoted(name) + ": " + std::to_string(x) + " is not an integer");
    return static_cast<long long>(x);
  }

  // Calls f with the place of a corner in its cell, the number of corners of the cell, and the vertex.
  template <class F>
  void for_each_corner(const Piece& piece, const std::string& section, std::size_t cells, F f)
  {
    if(cells == 0)
      return;
    const Numbers corners = m_arrays.read(piece, section + " connectivity");
    const Numbers ends = m_arrays.read(piece, section + " offsets");
    if(ends.size() != cells)
      m_file.fail(m_place + std::to_string(ends.size()) + " offsets for " + std::to_string(cells) + " cells of " +
                  section);
    long long begin = 0;
    for(std::size_t c = 0; c < cells; ++c)
    {
      const long long end = integer(ends[c], section + " offsets");
      if(end < begin || end > static_cast<long long>(corners.size()))
        m_file.fail(m_place + "cell " + std::to_string(c) + " of " + section + " goes from corner " +
                    std::to_string(begin) + " to " + std::to_string(end) + " of " + std::to_string(corners.size()));
      for(long long i = begin; i < end; ++i)
        f(static_cast<std::size_t>(i - begin), static_cast<std::size_t>(end - begin),
          integer(corners[static_cast<std::size_t>(i)], section + " connectivity"));
      begin = end;
    }
  }

  const Input_file& m_file;
  const Array_reader& m_arrays;
  Polygon_soup& m_soup;
  std::string m_place;
};

} // namespace

Polygon_soup read_vtp(const Input_file& file)
{
  // What is appended need not be XML: it may be the bytes themselves.
  std::string_view text = file.content, appended;
  const std::size_t last = text.find("<AppendedData"), mark = text.find('_', text.find('>', last));
  if(last != std::string_view::npos && mark != std::string_view::npos)
  {
    appended = text.substr(mark + 1);
    text = text.substr(0, mark);
  }
  Vtk_file vtk;
  Vtp_handler handler(vtk);
  read_xml(file, text, "", appended.empty(), handler);

  Polygon_soup soup;
  const Array_reader arrays(file, vtk, appended);
  Piece_reader pieces(file, arrays, soup);
  for(std::size_t p = 0; p < vtk.pieces.size(); ++p)
    pieces.read(vtk.pieces[p], p);
  return soup;
}

} // namespace constrictions
