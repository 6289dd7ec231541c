// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/text_scanner.h"
#include "input/triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace constrictions {

namespace {

enum class Type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

struct Property
{
  std::string name;
  bool is_list;
  Type count_type; // of a list
  Type type;       // of the value, or of each value of a list
};

struct Element
{
  std::string name;
  std::size_t count;
  std::vector<Property> properties;

  // the number of properties if there is none of this name
  std::size_t find(std::string_view property) const
  {
    std::size_t i = 0;
    while(i < properties.size() && properties[i].name != property)
      ++i;
    return i;
  }
};

enum class Encoding { ASCII, LITTLE_ENDIAN_BINARY, BIG_ENDIAN_BINARY };

struct Header
{
  Encoding encoding;
  std::vector<Element> elements;
};

Type read_type(Text_scanner& scanner)
{
  const std::array<std::array<std::string_view, 2>, 8> names = {{{"char", "int8"}, {"uchar", "uint8"},
                                                                 {"short", "int16"}, {"ushort", "uint16"},
                                                                 {"int", "int32"}, {"uint", "uint32"},
                                                                 {"float", "float32"}, {"double", "float64"}}};
  const std::string_view word = scanner.word();
  for(std::size_t i = 0; i < names.size(); ++i)
    if(word == names[i][0] || word == names[i][1])
      return static_cast<Type>(i);
  scanner.fail_at_word("PLY header", "a type");
}

Encoding read_encoding(Text_scanner& scanner)
{
  const std::string_view word = scanner.word();
  if(word == "ascii")
    return Encoding::ASCII;
  if(word == "binary_little_endian")
    return Encoding::LITTLE_ENDIAN_BINARY;
  if(word == "binary_big_endian")
    return Encoding::BIG_ENDIAN_BINARY;
  scanner.fail_at_word("PLY header", "a PLY format");
}

// Leaves the scanner at the first byte behind the header.
Header read_header(Text_scanner& scanner)
{
  Header header;
  bool has_format = false;
  scanner.skip_line(); // "ply"
  for(;;)
  {
    if(!scanner.next_line())
      scanner.fail("the file ends within the PLY header");
    const std::string_view keyword = scanner.word();
    if(keyword == "format")
    {
      header.encoding = read_encoding(scanner);
      has_format = true;
    }
    else if(keyword == "element")
    {
      Element element{std::string(scanner.word()), 0, {}};
      if(!scanner.read(element.count))
        scanner.fail_at_word("PLY header", "a number of elements");
      header.elements.push_back(element);
    }
    else if(keyword == "property")
    {
      if(header.elements.empty())
        scanner.fail("PLY header: a property without an element");
      Text_scanner ahead = scanner;
      Property property{std::string(), ahead.word() == "list", Type::UINT8, Type::INT32};
      if(property.is_list)
      {
        scanner = ahead;
        property.count_type = read_type(scanner);
      }
      property.type = read_type(scanner);
      property.name = std::string(scanner.word());
      header.elements.back().properties.push_back(property);
    }
    else if(keyword == "end_header")
    {
      scanner.skip_line();
      if(!has_format)
        scanner.fail("PLY header: no format is given");
      return header;
    }
    else if(keyword != "comment" && keyword != "obj_info")
      scanner.fail("PLY header: unknown keyword " + quoted(keyword));
    scanner.skip_line();
  }
}

// The numbers behind the header, one after the other, whatever their encoding.
class Body
{
public:
  Body(const Input_file& file, const Text_scanner& scanner, Encoding encoding)
    : m_file(file), m_scanner(scanner), m_pos(scanner.offset()), m_encoding(encoding)
  {}

  // Each begin() is followed by the values of one element.
  void begin(const Element& element, std::size_t i)
  {
    m_element = &element;
    m_i = i;
    if(m_encoding == Encoding::ASCII && !m_scanner.next_line())
      fail_at_end();
  }

  void end()
  {
    if(m_encoding == Encoding::ASCII)
      m_scanner.skip_line();
  }

  double read(Type type)
  {
    if(m_encoding == Encoding::ASCII)
    {
      double value = 0;
      if(!m_scanner.read(value))
        m_scanner.fail_at_word(m_element->name + " " + std::to_string(m_i), "a number");
      return value;
    }
    switch(type)
    {
      case Type::INT8: return read_bytes<std::int8_t>();
      case Type::UINT8: return read_bytes<std::uint8_t>();
      case Type::INT16: return read_bytes<std::int16_t>();
      case Type::UINT16: return read_bytes<std::uint16_t>();
      case Type::INT32: return read_bytes<std::int32_t>();
      case Type::UINT32: return read_bytes<std::uint32_t>();
      case Type::FLOAT32: return read_bytes<float>();
      default: return read_bytes<double>();
    }
  }

  // for counts and vertex numbers
  long long read_integer(Type type)
  {
    const double value = read(type), largest = 1e15;
    if(!(std::abs(value) < largest) || value != std::floor(value))
      m_file.fail(m_element->name + " " + std::to_string(m_i) + ": " + std::to_string(value) + " is not an integer");
    return static_cast<long long>(value);
  }

  void skip(const Property& property)
  {
    const long long n = property.is_list ? read_integer(property.count_type) : 1;
    for(long long i = 0; i < n; ++i)
      read(property.type);
  }

  std::size_t remaining() const { return m_file.content.size() - m_pos; }

private:
  template <class T>
  T read_bytes()
  {
    if(remaining() < sizeof(T))
      fail_at_end();
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), m_file.content.data() + m_pos, sizeof(T));
    m_pos += sizeof(T);
    const std::uint16_t one = 1;
    const bool host_is_little_endian = reinterpret_cast<const unsigned char&>(one) == 1;
    if(host_is_little_endian != (m_encoding == Encoding::LITTLE_ENDIAN_BINARY))
      std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  [[noreturn]] void fail_at_end() const
  {
    m_file.fail("the file ends at " + m_element->name + " " + std::to_string(m_i) + " of the " +
                std::to_string(m_element->count) + " that its header announces");
  }

  const Input_file& m_file;
  Text_scanner m_scanner;
  std::size_t m_pos;
  Encoding m_encoding;
  const Element* m_element = nullptr;
  std::size_t m_i = 0;
};

void read_vertices(Body& body, const Element& element, Triangle_soup& soup)
{
  const std::size_t n = element.properties.size();
  std::vector<int> coordinate(n, -1);
  for(int i = 0; i < 3; ++i)
    coordinate[element.find(std::string_view(&"xyz"[i], 1))] = i;

  // a vertex takes at least six bytes, of text or of numbers
  soup.points.reserve((std::min)(element.count, body.remaining() / 6 + 1));
  for(std::size_t v = 0; v < element.count; ++v)
  {
    std::array<double, 3> p = {0, 0, 0};
    body.begin(element, v);
    for(std::size_t i = 0; i < n; ++i)
      if(coordinate[i] != -1)
        p[static_cast<std::size_t>(coordinate[i])] = body.read(element.properties[i].type);
      else
        body.skip(element.properties[i]);
    body.end();
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
}

void read_faces(Body& body, const Element& element, std::size_t corners, std::size_t number_of_vertices,
                Triangle_soup& soup)
{
  soup.corners.reserve(3 * (std::min)(element.count, body.remaining() / 4 + 1));
  for(std::size_t f = 0; f < element.count; ++f)
  {
    body.begin(element, f);
    for(std::size_t i = 0; i < element.properties.size(); ++i)
    {
      const Property& property = element.properties[i];
      if(i != corners)
      {
        body.skip(property);
        continue;
      }
      const long long n = body.read_integer(property.count_type);
      if(n != 3)
        throw_not_triangular(f, static_cast<unsigned long long>(n < 0 ? 0 : n));
      for(int j = 0; j < 3; ++j)
        soup.corners.push_back(checked_index(f, body.read_integer(property.type), number_of_vertices));
    }
    body.end();
  }
}

// The first element of this name, which the file must have.
const Element& find_element(const Header& header, std::string_view name, const Input_file& file)
{
  for(const Element& element : header.elements)
    if(element.name == name)
      return element;
  file.fail("PLY header: no element is named " + quoted(name));
}

} // namespace

Triangle_soup read_ply(const Input_file& file)
{
  // "comment" lines belong to the header, and the body has none
  Text_scanner scanner(file, 0, '\n');
  const Header header = read_header(scanner);

  const Element &vertex = find_element(header, "vertex", file), &face = find_element(header, "face", file);
  for(std::string_view name : {"x", "y", "z"})
  {
    const std::size_t i = vertex.find(name);
    if(i == vertex.properties.size() || vertex.properties[i].is_list)
      file.fail("PLY header: a vertex has no number named " + quoted(name));
  }
  const std::size_t corners = (std::min)(face.find("vertex_indices"), face.find("vertex_index"));
  if(corners == face.properties.size() || !face.properties[corners].is_list)
    file.fail("PLY header: a face has no list named \"vertex_indices\" or \"vertex_index\"");

  Triangle_soup soup;
  Body body(file, scanner, header.encoding);
  for(const Element& element : header.elements)
  {
    if(&element == &vertex)
      read_vertices(body, element, soup);
    else if(&element == &face)
      read_faces(body, element, corners, vertex.count, soup);
    else if(!element.properties.empty())
      for(std::size_t i = 0; i < element.count; ++i)
      {
        body.begin(element, i);
        for(const Property& property : element.properties)
          body.skip(property);
        body.end();
      }
  }
  return soup;
}

} // namespace constrictions
