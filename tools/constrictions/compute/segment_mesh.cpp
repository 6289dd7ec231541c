// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/closed_volume.h"
#include "compute/computations.h"

#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_label_borders.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <limits>
#include <cmath>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

namespace SMC = CGAL::Surface_mesh_constrictions;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef Mesh::Property_map<Mesh::Edge_index, bool> Marks;

// The face of the input that each face comes from.
struct Ancestry
{
  std::vector<Mesh::Face_index> old_face;
  Mesh::Face_index split;
};

struct Ancestry_visitor : public SMC::Split_visitor_base<Mesh>
{
  explicit Ancestry_visitor(Ancestry& ancestry) : ancestry(&ancestry) {}

  void before_subface_creations(Mesh::Face_index f, const Mesh&) const { ancestry->split = f; }
  void after_subface_created(Mesh::Face_index f, const Mesh&) const
  {
    if(ancestry->old_face.size() <= f)
      ancestry->old_face.resize(f + std::size_t(1));
    ancestry->old_face[f] = ancestry->split;
  }

  Ancestry* ancestry;
};

typedef std::vector<std::optional<std::size_t>> Numbers_of_parts;

// Fills for each constriction the number of parts from which on it is a border.
SMC::Split_curves<Mesh> split(const std::vector<Constriction>& constrictions, const Segmentation& segmentation,
                              Marks marks, const Ancestry_visitor& visitor, Mesh& mesh, Numbers_of_parts& border_from)
{
  // the side is known only when the program runs
  std::vector<Constriction> chosen;
  std::vector<std::size_t> place;
  for(std::size_t c = 0; c < constrictions.size(); ++c)
    if(!segmentation.side || constrictions[c].side() == *segmentation.side)
    {
      chosen.push_back(constrictions[c]);
      place.push_back(c);
    }
  std::vector<std::size_t> part_of_face(mesh.num_faces());
  const auto patches = CGAL::make_property_map(part_of_face);
  const SMC::Surface_parts parts =
      segmentation.parts ? SMC::segment_by_constrictions(mesh, chosen, patches,
                                                         SMC::parameters::maximum_number_of_parts(*segmentation.parts))
                         : SMC::segment_by_constrictions(mesh, chosen, patches);
  border_from.resize(constrictions.size());
  for(const SMC::Nested_cut& c : parts.nested_cuts)
    border_from[place[c.curve]] = c.number_of_parts;

  std::vector<Constriction> used;
  for(std::size_t i = 0; i < chosen.size(); ++i)
    if(parts.outcomes[i].is_used)
      used.push_back(chosen[i]);
  const SMC::Split_curves<Mesh> curves =
      SMC::split_along_constrictions(mesh, used, CGAL::parameters::edge_is_constrained_map(marks).visitor(visitor));
  SMC::Split_curves<Mesh> result;
  result.halfedges.resize(constrictions.size());
  result.outcomes.assign(constrictions.size(), {false, SMC::Cut_outcome::none});
  auto halfedges = curves.halfedges.begin();
  for(std::size_t i = 0; i < place.size(); ++i)
  {
    result.outcomes[place[i]] = parts.outcomes[i];
    if(parts.outcomes[i].is_used)
      result.halfedges[place[i]] = *halfedges++;
    std::size_t& crossed = result.outcomes[place[i]].crossed_curve;
    if(crossed != SMC::Cut_outcome::none)
      crossed = place[crossed];
  }
  return result;
}

// `capped` has the holes of the input, `open` also those along curves.
Part measured_part(const Mesh& open, Mesh&& capped, bool is_open)
{
  Part part;
  part.area = PMP::area(open);
  // a part with holes of the input has no volume
  part.volume = CGAL::is_closed(capped) ? closed_volume(capped) : std::numeric_limits<double>::quiet_NaN();
  part.is_cavity = false;
  part.boundaries = 0;
  std::vector<bool> is_seen(open.num_halfedges(), false);
  for(Mesh::Halfedge_index h : open.halfedges())
    if(open.is_border(h) && !is_seen[h])
    {
      ++part.boundaries;
      for(Mesh::Halfedge_index b : open.halfedges_around_face(h))
        is_seen[b] = true;
    }
  // negative with three boundaries or more; the numbers of a mesh are unsigned, of 32 bits
  const std::ptrdiff_t euler_characteristic =
      std::ptrdiff_t(open.number_of_vertices()) + open.number_of_faces() - std::ptrdiff_t(open.number_of_edges());
  part.genus = static_cast<std::size_t>((2 - euler_characteristic - std::ptrdiff_t(part.boundaries)) / 2);
  part.mesh = is_open ? open : std::move(capped);
  return part;
}

// The curves along which the border of a cap runs.
std::vector<std::size_t> curves_at(const SMC::Part_cap<Mesh>& cap, const Mesh& mesh,
                                   const std::map<Mesh::Edge_index, std::vector<std::size_t>>& curves_of_edge)
{
  std::set<std::size_t> result;
  for(Mesh::Halfedge_index h : cap.border)
  {
    const std::vector<std::size_t>& curves = curves_of_edge.at(mesh.edge(h));
    result.insert(curves.begin(), curves.end());
  }
  return {result.begin(), result.end()};
}

// The parts between curves. split(marks, visitor, mesh) splits the mesh along them.
template <class Split>
Parts parts_of_split(const Mesh& mesh, bool is_open, const Split& split)
{
  Parts result;
  result.mesh = mesh;
  const Marks marks = result.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  Ancestry ancestry;
  ancestry.old_face.assign(mesh.faces().begin(), mesh.faces().end());
  const SMC::Split_curves<Mesh> curves = split(marks, Ancestry_visitor(ancestry), result.mesh);
  const std::size_t number_of_curves = curves.outcomes.size();
  result.outcomes = curves.outcomes;

  result.part_of_face.resize(result.mesh.num_faces());
  PMP::connected_components(result.mesh, CGAL::make_property_map(result.part_of_face),
                            CGAL::parameters::edge_is_constrained_map(marks));
  std::vector<Mesh> open, closed;
  SMC::extract_parts(result.mesh, marks, std::back_inserter(open), SMC::parameters::with_caps(false));
  std::vector<SMC::Part_cap<Mesh>> caps;
  SMC::extract_parts(result.mesh, marks, std::back_inserter(closed),
                     SMC::parameters::cap_output_iterator(std::back_inserter(caps)));
  double volume = 0;
  for(std::size_t p = 0; p < open.size(); ++p)
  {
    result.parts.push_back(measured_part(open[p], std::move(closed[p]), is_open));
    if(!std::isnan(result.parts.back().volume))
      volume += result.parts.back().volume;
  }
  for(Part& part : result.parts)
    part.is_cavity = part.volume * volume < 0;
  std::map<Mesh::Edge_index, std::vector<std::size_t>> curves_of_edge;
  for(std::size_t c = 0; c < number_of_curves; ++c)
    for(Mesh::Halfedge_index h : curves.halfedges[c])
      curves_of_edge[result.mesh.edge(h)].push_back(c);
  for(const SMC::Part_cap<Mesh>& c : caps)
    result.parts[c.part].caps.push_back({curves_at(c, result.mesh, curves_of_edge), c.intersects_part});

  for(std::size_t c = 0; c < number_of_curves; ++c)
  {
    std::map<std::array<std::size_t, 2>, double> lengths;
    for(Mesh::Halfedge_index h : curves.halfedges[c])
      if(!result.mesh.is_border(result.mesh.edge(h)) && marks[result.mesh.edge(h)]) // along a hole a part ends
        lengths[{{result.part_of_face[result.mesh.face(h)],
                  result.part_of_face[result.mesh.face(result.mesh.opposite(h))]}}] += PMP::edge_length(h, result.mesh);
    for(const auto& [parts, length] : lengths)
      result.adjacencies.push_back({c, parts, length});
  }

  std::vector<std::map<std::size_t, double>>& shares = result.area_of_input_face;
  shares.resize(mesh.num_faces());
  for(Mesh::Face_index f : result.mesh.faces())
    shares[ancestry.old_face[f]][result.part_of_face[f]] += PMP::face_area(f, result.mesh);
  for(const std::map<std::size_t, double>& s : shares)
    result.part_of_input_face.push_back(
        std::max_element(s.begin(), s.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first);
  return result;
}

} // namespace

Parts segment_mesh(const Mesh& mesh, const std::vector<Constriction>& constrictions, const Segmentation& segmentation)
{
  Numbers_of_parts border_from;
  Parts result =
      parts_of_split(mesh, segmentation.open, [&](const Marks& marks, const Ancestry_visitor& visitor, Mesh& copy) {
        return split(constrictions, segmentation, marks, visitor, copy, border_from);
      });
  result.border_from = border_from;
  return result;
}

Parts cut_along_borders(const Mesh& mesh, const Labelling& labelling)
{
  Parts result = parts_of_split(mesh, false, [&](const Marks& marks, const Ancestry_visitor& visitor, Mesh& copy) {
    return SMC::split_along_label_borders(copy, labelling.tightened.borders,
                                          CGAL::parameters::edge_is_constrained_map(marks).visitor(visitor));
  });
  result.border_from.resize(result.outcomes.size());
  // the label of most of a part
  std::vector<std::map<Label, double>> areas(result.parts.size());
  for(std::size_t f = 0; f < result.area_of_input_face.size(); ++f)
    for(const auto& [part, area] : result.area_of_input_face[f])
      areas[part][labelling.labels[f]] += area;
  for(const std::map<Label, double>& a : areas)
    result.labels.push_back(
        std::max_element(a.begin(), a.end(), [](const auto& x, const auto& y) { return x.second < y.second; })->first);
  return result;
}

} // namespace constrictions
