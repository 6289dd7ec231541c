// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/number_type.h"
#include "input/readers.h"
#include "input/text_scanner.h"
#include "input/triangle_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace constrictions {

namespace {

// 64-bit integers are not of the format, but some programs write them.
typedef Number_type Type;

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

enum class Encoding
{
  ASCII,
  LITTLE_ENDIAN_BINARY,
  BIG_ENDIAN_BINARY
};

struct Header
{
  Encoding encoding;
  std::vector<Element> elements;
};

Type read_type(Text_scanner& scanner)
{
  const std::array<std::array<std::string_view, 2>, 10> names = {{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"long", "int64"},
                                                                  {"ulong", "uint64"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  const std::string word = lower_case(scanner.word());
  for(std::size_t i = 0; i < names.size(); ++i)
    if(word == names[i][0] || word == names[i][1])
      return static_cast<Type>(i);
  scanner.fail_at_word("PLY header", "a type");
}

Encoding read_encoding(Text_scanner& scanner)
{
  const std::string word = lower_case(scanner.word());
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
  scanner.next_line();
  scanner.skip_line(); // "ply"
  for(;;)
  {
    if(!scanner.next_line())
      scanner.fail("the file ends within the PLY header");
    const std::string keyword = lower_case(scanner.word());
    if(keyword == "format")
    {
      header.encoding = read_encoding(scanner);
      has_format = true;
    }
    else if(keyword == "element")
    {
      Element element{lower_case(scanner.word()), 0, {}};
      if(!scanner.read(element.count))
        scanner.fail_at_word("PLY header", "a number of elements");
      header.elements.push_back(element);
    }
    else if(keyword == "property")
    {
      if(header.elements.empty())
        scanner.fail("PLY header: a property without an element");
      Text_scanner ahead = scanner;
      Property property{std::string(), lower_case(ahead.word()) == "list", Type::UINT8, Type::INT32};
      if(property.is_list)
      {
        scanner = ahead;
        property.count_type = read_type(scanner);
      }
      property.type = read_type(scanner);
      property.name = lower_case(scanner.word());
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
      scanner.fail("PLY header: unknown keyword " + constrictions::quoted(keyword));
    scanner.skip_line();
  }
}

// The numbers behind the header, one after the other, whatever their encoding.
class Body
{
public:
  // in_lines: whether each element of a text has a line of its own, and what follows its values there does not matter
  Body(const Input_file& file, const Text_scanner& scanner, Encoding encoding, bool in_lines)
    : m_file(file), m_scanner(scanner), m_pos(scanner.offset()), m_encoding(encoding), m_in_lines(in_lines)
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
    if(m_encoding == Encoding::ASCII && m_in_lines)
      m_scanner.skip_line();
  }

  double read(Type type)
  {
    if(m_encoding == Encoding::ASCII)
    {
      double value = 0;
      if(!Text_scanner::parse(m_in_lines ? m_scanner.word() : m_scanner.word_of_text(), value))
        m_scanner.fail_at_word(m_element->name + " " + std::to_string(m_i), "a number");
      return value;
    }
    const std::size_t size = size_of(type);
    if(remaining() < size)
      fail_at_end();
    m_pos += size;
    return number_of_type(type, m_file.content.data() + m_pos - size, m_encoding == Encoding::LITTLE_ENDIAN_BINARY);
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
  [[noreturn]] void fail_at_end() const
  {
    m_file.fail("the file ends at " + m_element->name + " " + std::to_string(m_i) + " of the " +
                std::to_string(m_element->count) + " that its header announces");
  }

  const Input_file& m_file;
  Text_scanner m_scanner;
  std::size_t m_pos;
  Encoding m_encoding;
  bool m_in_lines;
  const Element* m_element = nullptr;
  std::size_t m_i = 0;
};

void read_vertices(Body& body, const Element& element, Polygon_soup& soup)
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

// The number of a vertex. Programs that run out of small signed numbers go on with those below zero.
long long read_vertex_number(Body& body, Type type, std::size_t number_of_vertices)
{
  const long long v = body.read_integer(type);
  const long long wrapped = v + (type == Type::INT8 ? 1ll << 8 : type == Type::INT16 ? 1ll << 16 : 0);
  return v < 0 && wrapped < static_cast<long long>(number_of_vertices) ? wrapped : v;
}

// Calls f with the lists of each element, once for each.
template <class F>
void for_each_list(Body& body, const Element& element, std::size_t list, F f)
{
  for(std::size_t e = 0; e < element.count; ++e)
  {
    body.begin(element, e);
    for(std::size_t i = 0; i < element.properties.size(); ++i)
      if(i == list)
        f(element.properties[i], body.read_integer(element.properties[i].count_type));
      else
        body.skip(element.properties[i]);
    body.end();
  }
}

void read_faces(Body& body, const Element& element, std::size_t corners, std::size_t number_of_vertices,
                Polygon_soup& soup)
{
  soup.corners.reserve(3 * (std::min)(element.count, body.remaining() / 4 + 1));
  for_each_list(body, element, corners, [&](const Property& property, long long n) {
    for(long long i = 0; i < n; ++i)
      soup.corners.push_back(checked_index(
          soup.number_of_faces(), read_vertex_number(body, property.type, number_of_vertices), number_of_vertices));
    soup.end_face();
  });
}

// -1 begins a new strip.
void read_strips(Body& body, const Element& element, std::size_t corners, std::size_t number_of_vertices,
                 Polygon_soup& soup)
{
  Triangle_strip strip(soup);
  for_each_list(body, element, corners, [&](const Property& property, long long n) {
    strip.begin();
    for(long long i = 0; i < n; ++i)
    {
      const long long number = body.read_integer(property.type);
      if(number == -1)
        strip.begin();
      else
        strip.add(checked_index(soup.number_of_faces(), number, number_of_vertices));
    }
  });
}

// The first element of this name, or null.
const Element* find_element(const Header& header, std::string_view name)
{
  for(const Element& element : header.elements)
    if(element.name == name)
      return &element;
  return nullptr;
}

// The list of vertex numbers, or the number of properties.
std::size_t find_corners(const Element& element)
{
  for(std::string_view name : {"vertex_indices", "vertex_index"})
  {
    const std::size_t i = element.find(name);
    if(i < element.properties.size() && element.properties[i].is_list)
      return i;
  }
  return element.properties.size();
}

Polygon_soup read_body(const Input_file& file, const Text_scanner& scanner, const Header& header, bool in_lines)
{
  const Element* const vertex = find_element(header, "vertex");
  const Element* const face = find_element(header, "face");
  const Element* const strips = find_element(header, "tristrips");
  Polygon_soup soup;
  Body body(file, scanner, header.encoding, in_lines);
  for(const Element& element : header.elements)
  {
    if(&element == vertex)
      read_vertices(body, element, soup);
    else if(&element == face)
      read_faces(body, element, find_corners(element), vertex->count, soup);
    else if(&element == strips)
      read_strips(body, element, find_corners(element), vertex->count, soup);
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

} // namespace

Polygon_soup read_ply(const Input_file& file)
{
  // "comment" lines belong to the header, and the body has none
  Text_scanner scanner(file, 0, '\n');
  const Header header = read_header(scanner);
  // behind a header of lines that end in "\r" alone a binary "\n" is a number
  const std::size_t first_end = file.content.find_first_of("\r\n"), begin = scanner.offset();
  if(header.encoding != Encoding::ASCII && begin >= 2 && file.content.compare(begin - 2, 2, "\r\n") == 0 &&
     file.content.compare(first_end, 2, "\r\n") != 0)
    scanner = Text_scanner(file, begin - 1, '\n');

  const Element* const vertex = find_element(header, "vertex");
  if(vertex == nullptr)
    file.fail("PLY header: no element is named \"vertex\"");
  for(std::string_view name : {"x", "y", "z"})
  {
    const std::size_t i = vertex->find(name);
    if(i == vertex->properties.size() || vertex->properties[i].is_list)
      file.fail("PLY header: a vertex has no number named " + quoted(name));
  }
  const Element* const face = find_element(header, "face");
  const Element* const strips = find_element(header, "tristrips");
  if(face == nullptr && strips == nullptr)
    for(const Element& element : header.elements)
      if(&element != vertex &&
         std::any_of(element.properties.begin(), element.properties.end(), [](const Property& p) { return p.is_list; }))
        file.fail("a point cloud: no element is named \"face\" or \"tristrips\", and the lists of " +
                  constrictions::quoted(element.name) + " cannot be read");
  for(const Element* faces : {face, strips})
    if(faces != nullptr && faces->count > 0 && find_corners(*faces) == faces->properties.size())
      file.fail("PLY header: a " + std::string(faces->name == "face" ? "face" : "strip") +
                " has no list named \"vertex_indices\" or \"vertex_index\"");

  try
  {
    return read_body(file, scanner, header, true);
  }
  catch(const std::exception&)
  {
    if(header.encoding == Encoding::ASCII)
      try
      {
        return read_body(file, scanner, header, false);
      }
      catch(const std::exception&)
      {}
    throw;
  }
}

} // namespace constrictions
