// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/loops_file.h"

#include "input/input_file.h"
#include "input/text_scanner.h"

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace constrictions {

namespace {

typedef std::vector<Mesh::Vertex_index> Loop;

// The vertices of the mesh that stand for each vertex of the file, by its number.
class Copies
{
public:
  Copies(const Mesh& mesh, const File_numbering& numbering) : m_numbering(numbering)
  {
    for(Mesh::Vertex_index v : mesh.vertices())
      if(v.idx() >= numbering.vertices)
        m_added.emplace(numbering.vertex_of(v), v);
  }

  Loop of(std::size_t vertex_of_file) const
  {
    const Index v = m_numbering.stand_in_of(vertex_of_file);
    Loop result = {Mesh::Vertex_index(v)};
    for(auto [copy, end] = m_added.equal_range(v); copy != end; ++copy)
      result.push_back(copy->second);
    return result;
  }

private:
  const File_numbering& m_numbering;
  std::multimap<Index, Mesh::Vertex_index> m_added;
};

// One of the vertices at each place, so that edges join them; the first ones if there are no such.
Loop joined(const Mesh& mesh, const std::vector<Loop>& places)
{
  Loop loop;
  for(const Loop& copies : places)
    loop.push_back(copies.front());
  const auto is_joined = [&mesh](Mesh::Vertex_index u, Mesh::Vertex_index v) {
    return mesh.halfedge(u, v) != Mesh::null_halfedge();
  };
  if(std::all_of(places.begin(), places.end(), [](const Loop& copies) { return copies.size() == 1; }))
    return loop;
  for(Mesh::Vertex_index first : places.front())
  {
    // by place, the copies that are reached, each with the one before it
    std::vector<std::map<Mesh::Vertex_index, Mesh::Vertex_index>> reached(places.size());
    reached[0].emplace(first, first);
    for(std::size_t i = 1; i < places.size(); ++i)
      for(Mesh::Vertex_index v : places[i])
        for(const auto& before : reached[i - 1])
          if(is_joined(before.first, v))
            reached[i].emplace(v, before.first);
    for(const auto& [last, before_last] : reached.back())
      if(is_joined(last, first))
      {
        Mesh::Vertex_index v = last;
        for(std::size_t i = places.size(); i-- > 0; v = reached[i].at(v))
          loop[i] = v;
        return loop;
      }
  }
  return loop;
}

} // namespace

Loops read_loops_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering)
{
  const Input_file file = read_input_file(name);
  const Copies copies(mesh, numbering);
  Text_scanner scanner(file);
  Loops loops;
  for(; scanner.next_line(); scanner.skip_line())
  {
    std::vector<Loop> places;
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      std::size_t v = 0;
      if(!Text_scanner::parse(word, v))
        scanner.fail(quoted(word) + " is not a vertex number");
      if(v >= numbering.vertices)
        scanner.fail("vertex " + std::to_string(v) + " does not exist: the mesh has " +
                     std::to_string(numbering.vertices) + " vertices");
      places.push_back(copies.of(v));
      if(mesh.is_removed(places.back().front()))
        scanner.fail("vertex " + std::to_string(v) + " is on no face");
    }
    loops.vertices.push_back(joined(mesh, places));
    loops.lines.push_back(scanner.line());
  }
  return loops;
}

} // namespace constrictions
