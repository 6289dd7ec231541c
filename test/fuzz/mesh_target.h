// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_MESH_TARGET_H
#define FUZZ_MESH_TARGET_H

// What the library says of a small mesh and of curves on it is compared with what the oracle says.

#include "bodies.h"
#include "certificate_comparison.h"
#include "failure.h"
#include "second_witness.h"

#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace fuzz {

struct Statistics_taker : public SMC::Detection_visitor_base
{
  SMC::Detection_statistics* statistics;

  explicit Statistics_taker(SMC::Detection_statistics& s) : statistics(&s) {}
  void on_end(const SMC::Detection_statistics& s) const { *statistics = s; }
};

class Mesh_target
{
public:
  Mesh_target(const Body& body, Tally& tally)
    : m_mesh(mesh_of(body)), m_comparison(body, m_mesh, tally), m_witness(m_mesh, tally), m_tally(tally)
  {}

  // Compares the constrictions of the mesh, closed paths of edges that the bytes describe, what these are tightened to,
  // and what becomes of all of these curves if a vertex is passed on one side.
  void run(Bytes& bytes)
  {
    ++m_tally.meshes;
    std::vector<Constriction> all;
    SMC::detect_constrictions(m_mesh, std::back_inserter(all), CGAL::parameters::all_constrictions(true));
    std::vector<Constriction> curves;
    for(const Constriction& c : all)
    {
      compare(c, c.certificate());
      if(!(c.length() > 0))
        fail("a constriction has the length " + std::to_string(c.length()));
      if(curves.size() < 8)
        curves.push_back(c);
    }
    check_hierarchy(all);
    check_selection(all);
    for(int loops = bytes.below(4); loops > 0; --loops)
    {
      const std::vector<Mesh::Vertex_index> loop = some_loop(bytes);
      if(loop.size() < 3)
        continue;
      Constriction::Data data;
      for(Mesh::Vertex_index v : loop)
        data.locations.push_back({true, v, Mesh::Halfedge_index(), 0});
      curves.emplace_back(data);
      compare(curves.back(), certify_constriction(m_mesh, curves.back()));
      const SMC::Tightened_curve<Mesh> tightened = SMC::tighten_closed_curve(m_mesh, loop);
      if(tightened.verdict == SMC::Tightening_verdict::CLOSED_GEODESIC)
      {
        compare(tightened.curve, tightened.curve.certificate());
        if(tightened.curve.length() > length_of(loop) * (1 + 1e-9))
          fail("a loop was tightened to a longer curve");
        curves.push_back(tightened.curve);
      }
    }
    for(int changes = bytes.below(16); changes > 0 && !curves.empty(); --changes)
    {
      const Constriction& c = curves[static_cast<std::size_t>(bytes.next()) % curves.size()];
      if(const std::optional<Constriction> changed = beside_pivot(c, bytes.next(), bytes.flag()))
        compare(*changed, certify_constriction(m_mesh, *changed));
    }
  }

private:
  // with the oracle and with the second witness
  void compare(const Constriction& curve, const SMC::Certificate& certificate)
  {
    m_witness.compare(curve, m_comparison.compare(curve, certificate));
  }

  double length_of(const std::vector<Mesh::Vertex_index>& loop) const
  {
    double sum = 0;
    for(std::size_t i = 0; i < loop.size(); ++i)
      sum += std::sqrt(CGAL::squared_distance(m_mesh.point(loop[i]), m_mesh.point(loop[(i + 1) % loop.size()])));
    return sum;
  }

  // Nothing is dominated by something longer or by itself, also not by way of others. On a closed surface a separating
  // curve of less than the default prominence has an end; else it may come off at a hole.
  void check_hierarchy(const std::vector<Constriction>& all) const
  {
    for(std::size_t i = 0; i < all.size(); ++i)
    {
      const Constriction& c = all[i];
      if(!(c.prominence() >= 0))
        fail("a prominence is " + std::to_string(c.prominence()));
      if(c.dominated_by() && c.slides_off())
        fail("a curve slides off, and is dominated");
      if(c.dominated_by() && *c.dominated_by() >= all.size())
        fail("a curve is dominated by one that does not exist");
      if(c.dominated_by() && all[*c.dominated_by()].length() > c.length() * (1 + 1e-9))
        fail("a curve is dominated by a longer one");
      if(CGAL::is_closed(m_mesh) && c.is_separating() && c.prominence() < 0.05 && !c.dominated_by() && !c.slides_off())
        fail("a separating curve of prominence " + std::to_string(c.prominence()) + " has no end");
      std::size_t steps = 0;
      for(std::optional<std::size_t> d = c.dominated_by(); d; d = all[*d].dominated_by())
        if(++steps > all.size())
          fail("a curve dominates itself by way of others");
    }
  }

  // The default call selects what is selected of all, curve for curve, where it gives up no seed early; so it is on
  // small meshes that do not have many curves.
  void check_selection(const std::vector<Constriction>& all) const
  {
    SMC::Detection_statistics statistics;
    std::vector<Constriction> selected, by_default;
    SMC::detect_constrictions(m_mesh, std::back_inserter(by_default),
                              CGAL::parameters::visitor(Statistics_taker(statistics)));
    if(statistics.discarded > 0)
      return;
    ++m_tally.compared_selections;
    SMC::select_by_prominence(all, std::back_inserter(selected));
    if(selected.size() != by_default.size())
      fail("the default call gives " + std::to_string(by_default.size()) + " curves, but " +
           std::to_string(selected.size()) + " are selected of all");
    for(std::size_t i = 0; i < selected.size(); ++i)
      if(selected[i].length() != by_default[i].length() || selected[i].prominence() != by_default[i].prominence())
        fail("curve " + std::to_string(i) + " of the default call has the length " +
             std::to_string(by_default[i].length()) + " and the prominence " +
             std::to_string(by_default[i].prominence()) + ", but that selected of all " +
             std::to_string(selected[i].length()) + " and " + std::to_string(selected[i].prominence()));
  }

  // A closed path of edges: some steps from a vertex, and the shortest way back in edges.
  std::vector<Mesh::Vertex_index> some_loop(Bytes& bytes) const
  {
    std::vector<Mesh::Vertex_index> loop;
    Mesh::Vertex_index v(static_cast<std::uint32_t>(bytes.next()) % m_mesh.number_of_vertices());
    loop.push_back(v);
    for(int steps = 1 + bytes.below(12); steps > 0; --steps)
    {
      Mesh::Halfedge_index h = m_mesh.halfedge(v);
      for(unsigned k = bytes.next() % m_mesh.degree(v); k > 0; --k)
        h = m_mesh.prev(m_mesh.opposite(h));
      v = m_mesh.source(h);
      if(loop.size() > 1 && loop[loop.size() - 2] == v)
        loop.pop_back(); // there and back
      else
        loop.push_back(v);
    }
    std::vector<Mesh::Vertex_index> from(m_mesh.number_of_vertices(), Mesh::null_vertex());
    std::deque<Mesh::Vertex_index> queue = {loop.front()};
    from[loop.front()] = loop.front();
    for(; !queue.empty() && from[v] == Mesh::null_vertex(); queue.pop_front())
      for(Mesh::Vertex_index w : vertices_around_target(m_mesh.halfedge(queue.front()), m_mesh))
        if(from[w] == Mesh::null_vertex())
        {
          from[w] = queue.front();
          queue.push_back(w);
        }
    for(Mesh::Vertex_index w = v; w != loop.front();)
      if((w = from[w]) != loop.front())
        loop.push_back(w);
    while(loop.size() > 1 && loop.back() == loop.front())
      loop.pop_back();
    return loop;
  }

  // The curve led past a pivot on its left or right: across the edges there. None at the boundary, or where the curve
  // turns back.
  std::optional<Constriction> beside_pivot(const Constriction& c, unsigned which, bool on_left) const
  {
    const auto& locations = c.locations();
    const std::size_t n = locations.size();
    std::vector<std::size_t> pivots;
    for(std::size_t i = 0; i < n; ++i)
      if(locations[i].is_pivot)
        pivots.push_back(i);
    if(pivots.size() < 2)
      return std::nullopt;
    const std::size_t at = pivots[which % pivots.size()];
    const Mesh::Vertex_index v = locations[at].vertex;
    const auto &before = locations[(at + n - 1) % n], &after = locations[(at + 1) % n];
    if(m_mesh.is_border(v))
      return std::nullopt;
    // the edges to v at which the curve comes and goes, or those that bound the faces it comes and goes through
    Mesh::Halfedge_index first, last;
    const auto to_v = [&](Mesh::Vertex_index u) { return m_mesh.halfedge(u, v); };
    if(before.is_pivot)
      first = to_v(before.vertex);
    else // the side on which the edges are that are crossed next
      first = to_v(on_left ? m_mesh.target(before.halfedge) : m_mesh.source(before.halfedge));
    if(after.is_pivot)
      last = to_v(after.vertex);
    else
      last = to_v(on_left ? m_mesh.target(after.halfedge) : m_mesh.source(after.halfedge));
    if(first == Mesh::null_halfedge() || last == Mesh::null_halfedge())
      return std::nullopt;
    // on the left the way from `first` to `last` is clockwise around v, on the right counterclockwise
    const auto turned = [&](Mesh::Halfedge_index h) {
      return on_left ? m_mesh.opposite(m_mesh.next(h)) : m_mesh.prev(m_mesh.opposite(h));
    };
    std::vector<Constriction::Location> passed;
    Mesh::Halfedge_index h = before.is_pivot ? turned(first) : first;
    for(std::size_t guard = 0; guard <= m_mesh.degree(v); ++guard, h = turned(h))
    {
      if(after.is_pivot && h == last)
        break;
      // v is on the right of what passes it on the left
      passed.push_back({false, Mesh::Vertex_index(), on_left ? m_mesh.opposite(h) : h, 0.5});
      if(!after.is_pivot && h == last)
        break;
    }
    Constriction::Data data;
    for(std::size_t k = 1; k < n; ++k)
      data.locations.push_back(locations[(at + k) % n]);
    data.locations.insert(data.locations.end(), passed.begin(), passed.end());
    return Constriction(data);
  }

  const Mesh m_mesh;
  Certificate_comparison m_comparison;
  Second_witness m_witness;
  Tally& m_tally;
};

// Throws Failure.
inline void run_mesh_target(const std::uint8_t* data, std::size_t size, Tally& tally)
{
  Bytes bytes(data, size);
  const std::optional<Body> body = make_body(bytes);
  if(body)
    Mesh_target(*body, tally).run(bytes);
}

} // namespace fuzz

#endif // FUZZ_MESH_TARGET_H
