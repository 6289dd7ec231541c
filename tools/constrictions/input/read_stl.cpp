// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/byte_reader.h"
#include "input/readers.h"
#include "input/text_scanner.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace constrictions {

namespace {

// Gives equal positions the same number, by a hash table with open addressing that holds numbers of points only. Bits
// are compared: a NaN then equals itself, and is found as what it is when the points are checked, not as a hole.
class Vertex_numbering
{
public:
  // room for as many vertices as a closed mesh of genus 0 has; the table grows when that is not enough
  explicit Vertex_numbering(std::size_t number_of_faces)
  {
    std::size_t size = 16;
    while(size < number_of_faces)
      size *= 2;
    m_slots.assign(size, CGAL::Surface_mesh_constrictions::null_index);
  }

  Index operator()(double x, double y, double z, Polygon_soup& soup)
  {
    const Point p(x + 0., y + 0., z + 0.); // adding zero turns -0 into +0
    if(2 * soup.points.size() >= m_slots.size())
      grow(soup);
    Index& slot = find(p, soup);
    if(slot == CGAL::Surface_mesh_constrictions::null_index)
    {
      slot = static_cast<Index>(soup.points.size());
      soup.points.push_back(p);
    }
    return slot;
  }

private:
  typedef std::array<std::uint64_t, 3> Bits;

  static Bits bits(const Point& p)
  {
    const std::array<double, 3> c = {p.x(), p.y(), p.z()};
    Bits result;
    std::memcpy(result.data(), c.data(), sizeof(result));
    return result;
  }

  // the slot of the point, or the free one where it belongs
  Index& find(const Point& p, const Polygon_soup& soup)
  {
    const Bits b = bits(p);
    std::uint64_t hash = 0;
    for(std::uint64_t word : b)
    {
      hash = (hash ^ word) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
    const std::size_t mask = m_slots.size() - 1;
    std::size_t i = static_cast<std::size_t>(hash) & mask;
    while(m_slots[i] != CGAL::Surface_mesh_constrictions::null_index && bits(soup.points[m_slots[i]]) != b)
      i = (i + 1) & mask;
    return m_slots[i];
  }

  void grow(const Polygon_soup& soup)
  {
    m_slots.assign(2 * m_slots.size(), CGAL::Surface_mesh_constrictions::null_index);
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      find(soup.points[v], soup) = static_cast<Index>(v);
  }

  std::vector<Index> m_slots; // their number is a power of two
};

// keyword: lower case letters. Setting bit 5 of a letter makes it lower case, and makes a letter of nothing else that
// a word of a text file holds but control characters.
bool is_keyword(std::string_view word, std::string_view keyword)
{
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char c, char lower) { return (c | 0x20) == lower; });
}

// A statement a line, as the format says. Words behind those that it has, and lines with other keywords where a facet
// could begin ("color"), are skipped; a file may end without "endsolid" where a facet has ended.
Polygon_soup read_lines(const Input_file& file)
{
  const std::size_t bytes_per_face = 250; // about
  Polygon_soup soup;
  Vertex_numbering number(file.content.size() / bytes_per_face);
  Text_scanner scanner(file);
  bool in_face = false;
  const auto face_name = [&soup] { return "face " + std::to_string(soup.number_of_faces()); };
  while(scanner.next_line())
  {
    const std::string_view word = scanner.word();
    if(in_face && is_keyword(word, "vertex"))
    {
      double x, y, z;
      if(!scanner.read(x) || !scanner.read(y) || !scanner.read(z))
        scanner.fail_at_word(face_name(), "a coordinate");
      soup.corners.push_back(number(x, y, z, soup));
    }
    else if(in_face && is_keyword(word, "endfacet"))
    {
      soup.end_face();
      in_face = false;
    }
    else if(!in_face && is_keyword(word, "facet"))
      in_face = true; // the normal follows from the corners
    else if(in_face && !is_keyword(word, "outer") && !is_keyword(word, "endloop"))
      scanner.fail(face_name() + ": unexpected word " + quoted(word));
    else if(!in_face && (is_keyword(word, "vertex") || is_keyword(word, "endfacet")))
      scanner.fail(face_name() + ": " + quoted(word) + " without a facet");
    scanner.skip_line();
  }
  if(in_face)
    scanner.fail("the file ends within " + face_name() + ", before endfacet");
  return soup;
}

// Whatever the lines are: three numbers behind each "vertex", and a face ends where it says so.
Polygon_soup read_words(const Input_file& file)
{
  Polygon_soup soup;
  Vertex_numbering number(16);
  Text_scanner scanner(file);
  bool has_ended = true;
  for(std::string_view word = scanner.word_of_text(); !word.empty(); word = scanner.word_of_text())
    if(is_keyword(word, "vertex"))
    {
      std::array<double, 3> p = {0, 0, 0};
      for(double& x : p)
        if(!Text_scanner::parse(scanner.word_of_text(), x))
          scanner.fail_at_word("face " + std::to_string(soup.number_of_faces()), "a coordinate");
      soup.corners.push_back(number(p[0], p[1], p[2], soup));
      has_ended = false;
    }
    else if(is_keyword(word, "endfacet"))
    {
      soup.end_face();
      has_ended = true;
    }
  if(!has_ended)
    scanner.fail("the file ends within face " + std::to_string(soup.number_of_faces()) + ", before endfacet");
  return soup;
}

} // namespace

Polygon_soup read_ascii_stl(const Input_file& file)
{
  try
  {
    Polygon_soup soup = read_lines(file);
    // all in one line may stand behind "solid"
    return soup.number_of_faces() > 0 ? soup : read_words(file);
  }
  catch(const Input_file_error&)
  {
    try
    {
      return read_words(file);
    }
    catch(const Input_file_error&)
    {}
    throw;
  }
}

Polygon_soup read_binary_stl(const Input_file& file)
{
  const std::size_t header = 84, bytes_per_face = 50, normal = 12;
  const std::string& content = file.content;
  if(content.size() < header)
    file.fail("not an STL file: too short for the header");
  const std::size_t complete = (content.size() - header) / bytes_per_face;
  std::size_t nf = number_from_bytes<std::uint32_t>(content.data() + 80, true);
  // programs that do not know the number in time write one of these
  if((nf == 0 || nf == 0xFFFFFFFFu) && complete > 0 && (content.size() - header) % bytes_per_face == 0)
    nf = complete;
  if(nf < complete && (content.size() - header) % bytes_per_face == 0)
    file.fail("its header announces " + std::to_string(nf) + " faces, but it has the bytes of " +
              std::to_string(complete));
  if(complete < nf)
    file.fail("the file ends at face " + std::to_string(complete) + " of the " + std::to_string(nf) +
              " that its header announces");

  Polygon_soup soup;
  Vertex_numbering number(nf);
  soup.corners.reserve(3 * nf);
  for(std::size_t f = 0; f < nf; ++f)
  {
    for(int i = 0; i < 3; ++i)
    {
      const char* corner = content.data() + header + f * bytes_per_face + normal + 12 * i;
      const auto coordinate = [corner](int k) {
        return static_cast<double>(number_from_bytes<float>(corner + 4 * k, true));
      };
      soup.corners.push_back(number(coordinate(0), coordinate(1), coordinate(2), soup));
    }
    soup.end_face();
  }
  return soup;
}

} // namespace constrictions
