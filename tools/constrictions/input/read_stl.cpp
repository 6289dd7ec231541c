// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/text_scanner.h"
#include "input/triangle_soup.h"

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

  Index operator()(double x, double y, double z, Triangle_soup& soup)
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
  Index& find(const Point& p, const Triangle_soup& soup)
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

  void grow(const Triangle_soup& soup)
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

template <class T>
T little_endian(const char* bytes)
{
  std::uint32_t bits = 0;
  for(int i = 3; i >= 0; --i)
    bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
  T value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

} // namespace

Triangle_soup read_ascii_stl(const Input_file& file)
{
  const std::size_t bytes_per_face = 250; // about
  Triangle_soup soup;
  Vertex_numbering number(file.content.size() / bytes_per_face);
  Text_scanner scanner(file);
  bool in_solid = false, in_face = false;
  std::size_t face = 0;
  unsigned long long corners = 0; // of the face
  const auto face_name = [&face] { return "face " + std::to_string(face); };
  while(scanner.next_line())
  {
    const std::string_view word = scanner.word();
    if(in_face && is_keyword(word, "vertex"))
    {
      double x, y, z;
      if(!scanner.read(x) || !scanner.read(y) || !scanner.read(z))
        scanner.fail_at_word(face_name(), "a coordinate");
      if(++corners <= 3)
        soup.corners.push_back(number(x, y, z, soup));
    }
    else if(in_face && is_keyword(word, "outer"))
      scanner.skip_line();
    else if(in_face && is_keyword(word, "endfacet"))
    {
      if(corners != 3)
        throw_not_triangular(face, corners);
      in_face = false;
      ++face;
    }
    else if(in_solid && !in_face && is_keyword(word, "facet"))
    {
      in_face = true;
      corners = 0;
      scanner.skip_line(); // the normal follows from the corners
    }
    else if(!in_face && is_keyword(word, in_solid ? "endsolid" : "solid"))
    {
      in_solid = !in_solid;
      scanner.skip_line(); // its name
    }
    else if(!in_face || !is_keyword(word, "endloop"))
      scanner.fail(face_name() + ": unexpected word " + quoted(word));
  }
  if(in_solid)
    scanner.fail("the file ends at " + face_name() + ", before endsolid");
  return soup;
}

Triangle_soup read_binary_stl(const Input_file& file)
{
  const std::size_t header = 84, bytes_per_face = 50, normal = 12;
  const std::string& content = file.content;
  if(content.size() < header)
    file.fail("not an STL file: too short for the header");
  const std::size_t nf = little_endian<std::uint32_t>(content.data() + 80);
  const std::size_t complete = (content.size() - header) / bytes_per_face;
  if(complete < nf)
    file.fail("the file ends at face " + std::to_string(complete) + " of the " + std::to_string(nf) +
              " that its header announces");

  Triangle_soup soup;
  Vertex_numbering number(nf);
  soup.corners.reserve(3 * nf);
  for(std::size_t f = 0; f < nf; ++f)
    for(int i = 0; i < 3; ++i)
    {
      const char* corner = content.data() + header + f * bytes_per_face + normal + 12 * i;
      soup.corners.push_back(number(little_endian<float>(corner), little_endian<float>(corner + 4),
                                    little_endian<float>(corner + 8), soup));
    }
  return soup;
}

} // namespace constrictions
