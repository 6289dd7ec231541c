// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/loops_file.h"

#include "input/input_file.h"
#include "input/text_scanner.h"

#include <string_view>

namespace constrictions {

Loops read_loops_file(const std::string& name, const Mesh& mesh)
{
  const Input_file file = read_input_file(name);
  Text_scanner scanner(file);
  Loops loops;
  for(; scanner.next_line(); scanner.skip_line())
  {
    std::vector<Mesh::Vertex_index> loop;
    for(std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
    {
      Mesh::size_type v = 0;
      if(!Text_scanner::parse(word, v))
        scanner.fail(quoted(word) + " is not a vertex number");
      if(v >= mesh.num_vertices())
        scanner.fail("vertex " + std::to_string(v) + " does not exist: the mesh has " +
                     std::to_string(mesh.num_vertices()) + " vertices");
      loop.emplace_back(v);
      if(mesh.is_removed(loop.back()))
        scanner.fail("vertex " + std::to_string(v) + " is on no face");
    }
    loops.vertices.push_back(loop);
    loops.lines.push_back(scanner.line());
  }
  return loops;
}

} // namespace constrictions
