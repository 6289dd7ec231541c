// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/mesh_findings.h"

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <sstream>

namespace constrictions {

namespace {

using CGAL::Surface_mesh_constrictions::Input_defect;
using CGAL::Surface_mesh_constrictions::Invalid_input;

struct Words
{
  const char *name, *singular, *plural, *deed;
};

const Words& words_for(Finding finding)
{
  static const std::array<Words, number_of_findings> words = {
      {{"triangulated", "polygon", "polygons", "triangulated"},
       {"duplicate_faces", "duplicate face", "duplicate faces", "left out"},
       {"degenerate_faces", "degenerate face", "degenerate faces", "left out"},
       {"collapsed_edges", "edge of length zero", "edges of length zero", "collapsed"},
       {"merged_vertices", "vertex", "vertices", "merged"},
       {"turned_faces", "face", "faces", "turned round"},
       {"split_edges", "edge with more than two faces", "edges with more than two faces", "split"},
       {"cut_edges", "edge beside a non-manifold one", "edges beside non-manifold ones", "cut open"},
       {"split_vertices", "vertex", "vertices", "added by splitting"},
       {"holes", "hole", "holes", ""},
       {"border_edges", "edge", "edges", ""},
       {"t_vertices", "vertex in the middle of a border edge", "vertices in the middle of border edges", ""},
       {"near_vertices", "border vertex very near to another", "border vertices very near to others", ""},
       {"isolated_vertices", "vertex on no face", "vertices on no face", ""}}};
  return words[static_cast<std::size_t>(finding)];
}

std::string short_number(double x)
{
  std::ostringstream out;
  out.precision(2);
  out << x;
  return out.str();
}

std::string distances(const Mesh_findings& findings)
{
  const std::string least = short_number(findings.nearest), most = short_number(findings.farthest);
  return least == most ? least : least + " to " + most;
}

} // namespace

const char* name_of(Finding finding) { return words_for(finding).name; }

std::string as_words(Finding finding, std::size_t count)
{
  const Words& words = words_for(finding);
  const std::string deed = words.deed;
  return std::to_string(count) + ' ' + (count == 1 ? words.singular : words.plural) + (deed.empty() ? "" : " " + deed);
}

bool Mesh_findings::has_repairs() const
{
  for(std::size_t i = 0; i < number_of_findings; ++i)
    if(is_repair(static_cast<Finding>(i)) && m_entries[i].count > 0)
      return true;
  return false;
}

std::string summary_of(const Mesh_findings& findings)
{
  std::string result;
  for(std::size_t i = 0; i < number_of_findings; ++i)
  {
    const Finding finding = static_cast<Finding>(i);
    if(findings.count(finding) == 0 || finding == Finding::ISOLATED_VERTICES || finding == Finding::NEAR_VERTICES)
      continue;
    result += (result.empty() ? "" : ", ") + as_words(finding, findings.count(finding));
  }
  if(findings.count(Finding::NEAR_VERTICES) > 0)
    result += ", " + as_words(Finding::NEAR_VERTICES, findings.count(Finding::NEAR_VERTICES)) + " (" +
              distances(findings) + " apart; --merge " + short_number(findings.merging_distance) + " merges them)";
  return result;
}

void refuse_repairs(const Mesh_findings& findings)
{
  const auto refuse = [&](Finding finding, Input_defect defect) {
    if(findings.count(finding) > 0)
      throw Invalid_input(defect, 0,
                          findings.places(finding).front() + " (" + std::to_string(findings.count(finding)) +
                              " such; repaired without --strict)");
  };
  refuse(Finding::TRIANGULATED, Input_defect::NOT_TRIANGULAR);
  refuse(Finding::DUPLICATE_FACES, Input_defect::NON_MANIFOLD_EDGE);
  refuse(Finding::DEGENERATE_FACES, Input_defect::ZERO_LENGTH_EDGE);
  refuse(Finding::COLLAPSED_EDGES, Input_defect::ZERO_LENGTH_EDGE);
  refuse(Finding::SPLIT_EDGES, Input_defect::NON_MANIFOLD_EDGE);
  refuse(Finding::SPLIT_VERTICES, Input_defect::NON_MANIFOLD_VERTEX);
}

void refuse_cracks(const Mesh_findings& findings)
{
  if(2 * findings.count(Finding::NEAR_VERTICES) <= findings.count(Finding::BORDER_EDGES))
    return;
  throw Invalid_input(Input_defect::NOT_CLOSED, 0,
                      "not closed: " + as_words(Finding::BORDER_EDGES, findings.count(Finding::BORDER_EDGES)) +
                          " with one face, and " + std::to_string(findings.count(Finding::NEAR_VERTICES)) +
                          " vertices there lie " + distances(findings) + " apart from others; --merge " +
                          short_number(findings.merging_distance) + " merges them");
}

} // namespace constrictions
