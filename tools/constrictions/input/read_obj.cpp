// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/readers.h"
#include "input/text_scanner.h"

#include <string>
#include <string_view>

namespace constrictions {

namespace {

// The next word of a statement, which goes on behind a line that ends in a backslash.
std::string_view next_word(Text_scanner& scanner)
{
  std::string_view word = scanner.word();
  while(word == "\\")
  {
    scanner.skip_line();
    word = scanner.word();
  }
  if(!word.empty() && word.back() == '\\')
  {
    word.remove_suffix(1);
    scanner.skip_line();
  }
  return word;
}

double read_coordinate(Text_scanner& scanner, std::size_t vertex)
{
  double value = 0;
  if(!Text_scanner::parse(next_word(scanner), value))
    scanner.fail_at_word("vertex " + std::to_string(vertex), "a coordinate");
  return value;
}

// The numbers behind the first slash of "v/vt/vn" are those of a texture and a normal.
long long read_corner(Text_scanner& scanner, std::string_view word, std::size_t face, std::size_t number_of_vertices)
{
  long long v = 0;
  if(!Text_scanner::parse(word.substr(0, word.find('/')), v))
    scanner.fail_at_word("face " + std::to_string(face), "a vertex number");
  if(v == 0)
    scanner.fail("face " + std::to_string(face) + ": vertex number 0, but OBJ counts from 1");
  // negative: counted back from the vertex read last
  return v > 0 ? v - 1 : static_cast<long long>(number_of_vertices) + v;
}

} // namespace

Polygon_soup read_obj(const Input_file& file)
{
  using namespace CGAL::Surface_mesh_constrictions;

  Polygon_soup soup;
  Text_scanner scanner(file);
  while(scanner.next_line())
  {
    const std::string_view keyword = scanner.word();
    if(keyword == "v" || keyword == "V")
    {
      const std::size_t v = soup.points.size();
      const double x = read_coordinate(scanner, v), y = read_coordinate(scanner, v), z = read_coordinate(scanner, v);
      soup.points.emplace_back(x, y, z);
    }
    else if(keyword == "f" || keyword == "F" || keyword == "fo") // as it was called before version 3
    {
      const std::size_t f = soup.number_of_faces();
      for(std::string_view word = next_word(scanner); !word.empty() && word[0] != '#'; word = next_word(scanner))
      {
        // a vertex may follow the face that names it, so only what can never be right is refused here
        const long long v = read_corner(scanner, word, f, soup.points.size());
        soup.corners.push_back(v < 0 ? checked_index(f, v, soup.points.size()) : checked_index(f, v, null_index));
      }
      soup.end_face();
    }
    scanner.skip_line();
  }
  if(soup.points.empty())
    file.fail("not an OBJ file, or one without vertices");
  for(std::size_t f = 0, c = 0; f < soup.number_of_faces(); ++f)
    for(; c < soup.begin(f + 1); ++c)
      checked_index(f, soup.corners[c], soup.points.size());
  return soup;
}

} // namespace constrictions
