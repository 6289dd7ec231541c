// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/report.h"

#include <cstddef>
#include <sstream>
#include <string>

namespace constrictions {

namespace {

typedef CGAL::Surface_mesh_constrictions::Section_kind Section_kind;

} // namespace

std::string section_name(Section_kind kind)
{
  switch(kind)
  {
  case Section_kind::CLOSED:
    return "closed";
  case Section_kind::OPEN:
    return "open";
  case Section_kind::POINT:
    break;
  }
  return "point";
}

std::string sections_as_text(const Report& report)
{
  std::ostringstream out;
  for(std::size_t i = 0; i < report.sections.size(); ++i)
  {
    const Section_answer& a = report.sections[i];
    out << "section " << i << ": ";
    if(a.section.kind == Section_kind::POINT)
      out << "none";
    else
      out << section_name(a.section.kind) << ", length " << a.section.length;
    if(a.section.number_of_curves > 1)
      out << ", the shortest of " << a.section.number_of_curves << " that meet here";
    if(a.curve)
      out << ", tightened to curve " << *a.curve;
    out << '\n';
  }
  return out.str();
}

} // namespace constrictions
