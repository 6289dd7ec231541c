// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/labelling.h"

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace constrictions {

namespace SMC = CGAL::Surface_mesh_constrictions;
using SMC::Label_border_outcome;

namespace {

double area(const Mesh& mesh, Mesh::Face_index f)
{
  const Mesh::Halfedge_index h = mesh.halfedge(f);
  return std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                      mesh.point(mesh.target(mesh.next(h)))));
}

std::size_t number_of(const std::vector<Label>& labels) { return std::set<Label>(labels.begin(), labels.end()).size(); }

} // namespace

const char* outcome_name(Label_border_outcome outcome)
{
  switch(outcome)
  {
  case Label_border_outcome::CLOSED_GEODESIC:
    return "closed_geodesic";
  case Label_border_outcome::GEODESIC_ARC:
    return "geodesic_arc";
  case Label_border_outcome::DEGENERATE:
    return "degenerate";
  case Label_border_outcome::CROSSING:
    return "crossing";
  case Label_border_outcome::NOT_SIMPLE:
    return "not_simple";
  case Label_border_outcome::NOT_CERTIFIED:
    return "not_certified";
  }
  return "";
}

SMC::Constriction<Mesh> curve_of_border(const Label_border& border)
{
  if(border.outcome == Label_border_outcome::CLOSED_GEODESIC)
    return border.curve;
  SMC::Constriction<Mesh>::Data data;
  data.locations = border.locations;
  data.length = border.length;
  data.certificate = border.certificate;
  return SMC::Constriction<Mesh>(data);
}

std::vector<std::optional<Label>> labels_of_file(const Mesh& mesh, const File_numbering& numbering,
                                                 const Labelling& labelling)
{
  if(numbering.face.empty())
    return {labelling.labels.begin(), labelling.labels.end()};
  std::vector<std::map<Label, double>> areas(numbering.faces);
  for(Mesh::Face_index f : mesh.faces())
    areas[numbering.face_of(f)][labelling.labels[f]] += area(mesh, f);
  std::vector<std::optional<Label>> result(numbering.faces);
  for(std::size_t f = 0; f < numbering.faces; ++f)
    if(!areas[f].empty())
      result[f] = std::max_element(areas[f].begin(), areas[f].end(), [](const auto& a, const auto& b) {
                    return a.second < b.second;
                  })->first;
    else if(numbering.triangle_at(f) != SMC::null_index)
      result[f] = labelling.labels[numbering.triangle_at(f)];
  return result;
}

std::string labels_as_lines(const std::vector<std::optional<Label>>& labels)
{
  std::string result;
  for(const std::optional<Label>& l : labels)
    result += std::to_string(l.value_or(-1)) + '\n';
  return result;
}

std::string borders_as_table(const Labelling& labelling)
{
  using std::setw;

  std::ostringstream out;
  const std::vector<Label_border>& borders = labelling.tightened.borders;
  if(!borders.empty())
    out << setw(6) << "border" << setw(18) << "labels" << setw(18) << "outcome" << setw(12) << "old length" << setw(12)
        << "length" << setw(10) << "vanishes" << '\n';
  for(std::size_t i = 0; i < borders.size(); ++i)
  {
    const Label_border& b = borders[i];
    out << setw(6) << i << setw(18) << std::to_string(b.labels[0]) + " " + std::to_string(b.labels[1]) << setw(18)
        << outcome_name(b.outcome) << setw(12) << b.old_length << setw(12) << b.length << setw(10)
        << (b.vanishing_label ? std::to_string(*b.vanishing_label) : "-") << '\n';
  }
  for(std::size_t i = 0; i < borders.size(); ++i)
  {
    const Label_border& b = borders[i];
    const bool is_gone = b.outcome != Label_border_outcome::DEGENERATE && b.locations.empty();
    if(b.crossed_border)
      out << "border " << i << " would cross border " << *b.crossed_border
          << (is_gone ? ", and where it was, too: it is gone\n" : ": it stays where it was\n");
    else if(is_gone)
      out << "border " << i << " crosses others where it was: it is gone\n";
    if(b.outcome == Label_border_outcome::GEODESIC_ARC &&
       b.certificate.verdict != SMC::Certificate_verdict::NOT_COMPUTED &&
       b.certificate.verdict != SMC::Certificate_verdict::GEODESIC_ARC)
      out << "border " << i << " is " << b.certificate << '\n';
  }
  const std::size_t n = borders.size(), before = number_of(labelling.old_labels), after = number_of(labelling.labels),
                    parts = labelling.tightened.parts.size();
  out << n << (n == 1 ? " border, " : " borders, ") << before << (before == 1 ? " label before, " : " labels before, ")
      << after << " after, in " << parts << (parts == 1 ? " part\n" : " parts\n");
  return out.str();
}

} // namespace constrictions
