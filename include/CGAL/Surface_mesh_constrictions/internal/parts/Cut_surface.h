// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CUT_SURFACE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CUT_SURFACE_H

#include <CGAL/Surface_mesh_constrictions/internal/parts/Curve_arrangement.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/Face_ring.h>
#include <CGAL/Surface_mesh_constrictions/internal/parts/spread_parameters.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Imported_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// A surface subdivided by curves: its cells are the faces that no curve crosses and the pieces of the others. Sides of
// cells are like halfedges; side h of an uncrossed halfedge h of the corner table has the same number. The ghosts of
// holes are cells, too, which do not belong to the surface; the boundary of the mesh separates them from it.
class Cut_surface
{
public:
  typedef Exact_predicates_inexact_constructions_kernel::Vector_3 Vector;
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  static constexpr std::size_t border = none - 1; // instead of an arc, of a side on the boundary of the mesh

  struct Side
  {
    std::size_t next, opposite, cell;
    std::size_t vertex; // that it begins at
    std::size_t arc;    // that it runs along, or none, or border
    bool is_forward;    // whether it runs in the direction of the arc
  };

  // Linear in the size of the mesh and the number of crossings.
  template <class TriangleMesh>
  Cut_surface(const Imported_mesh<TriangleMesh>& imported, const Curve_arrangement<TriangleMesh>& arrangement)
  {
    const Corner_table& table = imported.table;
    for(const Point& p : imported.points)
      points.push_back(p - imported.points[table.halfedges[0].source]);
    m_number_of_vertices = points.size();
    const std::size_t faces = table.halfedges.size() / 3;
    m_number_of_faces = imported.number_of_faces();
    for(Index h = 0; h < table.halfedges.size(); ++h)
    {
      const Corner_table::Halfedge& halfedge = table.halfedges[h];
      const bool is_on_border = (h / 3 < m_number_of_faces) != (halfedge.opposite / 3 < m_number_of_faces);
      sides.push_back(
          {Corner_table::next(h), halfedge.opposite, h / 3, halfedge.source, is_on_border ? border : none, false});
    }
    for(std::size_t f = 0; f < faces; ++f)
    {
      face_of_cell.push_back(f);
      area_of_cell.push_back(face_area(f));
    }
    if(arrangement.number_of_curves() == 0)
      return;

    typedef typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_descriptor;
    std::unordered_map<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::size_t> face_number;
    for(std::size_t f = 0; f < m_number_of_faces; ++f)
      face_number.emplace(face(imported.halfedge_of(static_cast<Index>(3 * f)), imported.mesh()), f);
    const auto number_of = [&](halfedge_descriptor h) {
      Index i = static_cast<Index>(3 * face_number.at(face(h, imported.mesh())));
      while(imported.halfedge_of(i) != h)
        ++i;
      return static_cast<std::size_t>(i);
    };

    for(std::size_t a = 0; a < arrangement.arcs().size(); ++a)
      if(arrangement.arcs()[a].is_edge())
      {
        const halfedge_descriptor along = arrangement.arcs()[a].along;
        const std::size_t h = is_border(along, imported.mesh())
                                  ? sides[number_of(opposite(along, imported.mesh()))].opposite
                                  : number_of(along);
        sides[h].arc = sides[sides[h].opposite].arc = a;
        sides[h].is_forward = true;
      }

    m_parameters.resize(arrangement.crossings().size());
    points.resize(points.size() + m_parameters.size(), NULL_VECTOR);
    for(std::size_t e = 0; e < arrangement.edges().size(); ++e)
    {
      const auto& crossings = arrangement.edges()[e].crossings;
      if(!crossings.empty())
        split_edge(number_of(arrangement.edges()[e].halfedge), crossings, spread_parameters(arrangement, e));
    }
    for(std::size_t i = 0; i < arrangement.faces().size(); ++i)
      if(!arrangement.faces()[i].strands.empty())
      {
        const std::size_t f = face_number.at(arrangement.faces()[i].face);
        const halfedge_descriptor base = imported.halfedge_of(static_cast<Index>(3 * f));
        split_face(f, face_ring(arrangement, i, base), arrangement.faces()[i].strands);
      }
  }

  // whether a cell is a ghost
  bool is_ghost(std::size_t cell) const { return face_of_cell[cell] >= m_number_of_faces; }

  // whether a curve runs along a side
  bool is_on_curve(std::size_t s) const { return sides[s].arc != none && sides[s].arc != border; }

  std::vector<Side> sides;
  std::vector<std::size_t> face_of_cell;
  std::vector<double> area_of_cell;
  std::vector<Vector> points; // of vertices and then of crossings, relative to one of them

private:
  double face_area(std::size_t f) const
  {
    const Vector &p = points[sides[3 * f].vertex], &q = points[sides[3 * f + 1].vertex],
                 &r = points[sides[3 * f + 2].vertex];
    return std::sqrt(cross_product(q - p, r - p).squared_length()) / 2;
  }

  // the side of a cell from the place of this rank along a halfedge of the mesh to the next
  std::size_t side_along(std::size_t h, std::size_t rank) const
  {
    return rank == 0 ? h : m_first_side.at(h) + rank - 1;
  }

  // Crossings are given in order along the halfedge. Crossing c becomes the vertex c places after those of the mesh.
  void split_edge(std::size_t h, const std::vector<std::size_t>& crossings, const std::vector<double>& parameters)
  {
    const std::size_t o = sides[h].opposite, k = crossings.size();
    m_along.insert(h);
    m_first_side[h] = sides.size();
    m_first_side[o] = sides.size() + k;
    sides.resize(sides.size() + 2 * k);
    for(std::size_t i = 0; i <= k; ++i)
    {
      sides[side_along(h, i)].opposite = side_along(o, k - i);
      sides[side_along(o, k - i)].opposite = side_along(h, i);
      sides[side_along(h, i)].arc = sides[side_along(o, i)].arc = none;
    }
    const Vector p = points[sides[h].vertex], q = points[sides[o].vertex];
    for(std::size_t i = 0; i < k; ++i)
    {
      const std::size_t v = m_number_of_vertices + crossings[i];
      points[v] = p + parameters[i] * (q - p);
      m_parameters[crossings[i]] = parameters[i];
      sides[side_along(h, i + 1)].vertex = sides[side_along(o, k - i)].vertex = v;
    }
  }

  // In barycentric coordinates of a face, of which the areas of its pieces are made.
  std::array<double, 2> position(std::size_t f, const Face_ring::Place& p) const
  {
    double t = 0;
    if(p.rank > 0)
      t = m_along.count(3 * f + p.side) != 0 ? m_parameters[p.crossing] : 1 - m_parameters[p.crossing];
    return p.side == 0   ? std::array<double, 2>{{t, 0}}
           : p.side == 1 ? std::array<double, 2>{{1 - t, t}}
                         : std::array<double, 2>{{0, 1 - t}};
  }

  template <class Strands>
  void split_face(std::size_t f, const Face_ring& ring, const Strands& strands)
  {
    const auto side_from = [&](std::size_t place) {
      return side_along(3 * f + ring.places[place].side, ring.places[place].rank);
    };
    const std::size_t first_chord = sides.size();
    sides.resize(first_chord + 2 * ring.chords.size());
    const double area = area_of_cell[f];
    bool is_first = true;
    for(const std::vector<Face_ring::Piece_side>& piece : ring.pieces())
    {
      const std::size_t cell = is_first ? f : face_of_cell.size();
      if(!is_first)
      {
        face_of_cell.push_back(f);
        area_of_cell.push_back(0);
      }
      is_first = false;
      std::vector<std::size_t> numbers;
      for(const Face_ring::Piece_side& s : piece)
      {
        if(s.chord == Face_ring::none)
        {
          numbers.push_back(side_from(s.from));
          continue;
        }
        const Face_ring::Chord& chord = ring.chords[s.chord];
        const bool ascends = s.from == chord.low;
        const std::size_t i = first_chord + 2 * s.chord + (ascends ? 0 : 1);
        numbers.push_back(i);
        sides[i].opposite = first_chord + 2 * s.chord + (ascends ? 1 : 0);
        sides[i].vertex = sides[side_from(s.from)].vertex;
        sides[i].arc = strands[chord.strand].arc;
        sides[i].is_forward = ascends == chord.is_ascending;
      }
      double share = 0;
      for(std::size_t i = 0; i < piece.size(); ++i)
      {
        sides[numbers[i]].next = numbers[(i + 1) % piece.size()];
        sides[numbers[i]].cell = cell;
        const std::array<double, 2> o = position(f, ring.places[piece[0].from]),
                                    p = position(f, ring.places[piece[i].from]),
                                    q = position(f, ring.places[piece[(i + 1) % piece.size()].from]);
        share += (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
      }
      area_of_cell[cell] = share * area;
    }
  }

  std::size_t m_number_of_vertices = 0;                      // of the mesh
  std::size_t m_number_of_faces = 0;                         // of the mesh, without ghosts
  std::vector<double> m_parameters;                          // of crossings
  std::unordered_set<std::size_t> m_along;                   // the halfedges along which the parameters are counted
  std::unordered_map<std::size_t, std::size_t> m_first_side; // of a crossed halfedge, after the one at its source
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_PARTS_CUT_SURFACE_H
