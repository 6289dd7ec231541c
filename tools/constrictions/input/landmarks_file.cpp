// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/landmarks_file.h"

#include "input/input_file.h"
#include "input/text_scanner.h"

#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace constrictions {

namespace {

std::string_view without_blanks(std::string_view text)
{
  const std::string_view blanks = " \t\r\"";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> fields(std::string_view line)
{
  std::vector<std::string_view> result;
  for(;;)
  {
    const std::size_t comma = line.find(',');
    result.push_back(without_blanks(line.substr(0, comma)));
    if(comma == std::string_view::npos)
      return result;
    line.remove_prefix(comma + 1);
  }
}

// The last three of the fields, which may follow a name.
std::optional<std::array<double, 3>> coordinates(const std::vector<std::string_view>& given)
{
  if(given.size() != 3 && given.size() != 4)
    return std::nullopt;
  std::array<double, 3> result;
  for(std::size_t i = 0; i < 3; ++i)
    if(!Text_scanner::parse(given[given.size() - 3 + i], result[i]) || !std::isfinite(result[i]))
      return std::nullopt;
  return result;
}

} // namespace

std::vector<Landmark> read_landmarks_file(const std::string& name)
{
  const Input_file file = read_input_file(name);
  std::vector<Landmark> landmarks;
  std::string_view rest = file.content;
  bool is_first = true;
  for(std::size_t line = 1; !rest.empty(); ++line)
  {
    const std::size_t end = rest.find('\n');
    const std::string_view text = without_blanks(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    if(text.empty() || text.front() == '#')
      continue;
    const std::vector<std::string_view> given = fields(text);
    const std::optional<std::array<double, 3>> location = coordinates(given);
    if(location)
      landmarks.push_back({given.size() == 4 ? std::string(given.front()) : std::string(), *location});
    else if(!is_first)
      file.fail("line " + std::to_string(line) + ": " + quoted(text) +
                " is not a place: give three coordinates separated by commas, with a name before them or without");
    is_first = false;
  }
  if(landmarks.empty())
    file.fail("there is no place in it: give three coordinates separated by commas on each line");
  return landmarks;
}

Place_loops read_places_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering)
{
  const Input_file file = read_input_file(name);
  Text_scanner scanner(file);
  Place_loops loops;
  for(; scanner.next_line(); scanner.skip_line())
  {
    std::vector<Mesh::Point> places;
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      const std::optional<std::array<double, 3>> p = coordinates(fields(word));
      std::size_t v = 0;
      if(p)
        places.emplace_back((*p)[0], (*p)[1], (*p)[2]);
      else if(!Text_scanner::parse(word, v))
        scanner.fail(quoted(word) + " is neither a vertex number nor three coordinates separated by commas");
      else if(v >= numbering.vertices)
        scanner.fail("vertex " + std::to_string(v) + " does not exist: the mesh has " +
                     std::to_string(numbering.vertices) + " vertices");
      else
      {
        const Mesh::Vertex_index vertex(numbering.stand_in_of(v));
        if(mesh.is_removed(vertex))
          scanner.fail("vertex " + std::to_string(v) + " is on no face");
        places.push_back(mesh.point(vertex));
      }
    }
    loops.places.push_back(std::move(places));
    loops.lines.push_back(scanner.line());
  }
  return loops;
}

} // namespace constrictions
