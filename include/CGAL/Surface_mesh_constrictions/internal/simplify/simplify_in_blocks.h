// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H

#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Collapse_passes.h>
#include <CGAL/Surface_mesh_constrictions/internal/simplify/Face_blocks.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/Corner_table.h>

#include <CGAL/for_each.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

// How a large mesh is simplified before it is simplified as a whole.
struct Block_simplification
{
  std::size_t whole_faces = 65536; // a mesh of no more faces is simplified as a whole
  std::size_t block_faces = 32768; // of a block at most
  std::size_t rest_faces = 16384;  // of all blocks together at most after the last round
  double share = 0.25;             // of the edges inside a block that are left
};

// A part of a surface, in numbers of its own, with its holes open.
struct Partial_surface
{
  typedef Progressive_mesh::Point Point;

  Corner_table table;
  std::vector<Point> points;
  std::vector<Index> vertices; // as T^0 numbers them
};

// The faces of a surface that is simplified, in numbers of T^0. Faces and vertices that are out keep their numbers.
struct Surface_in_blocks
{
  Corner_table table; // `outgoing` is that of T^0
  std::vector<Partial_surface::Point> points;
  std::vector<Index> faces; // those that are left, in ascending order

  // The surface that is left. Linear.
  Partial_surface rest() const
  {
    Partial_surface result;
    std::vector<Index> corners, number(points.size(), null_index);
    corners.reserve(3 * faces.size());
    for(Index f : faces)
      for(Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        const Index v = table.halfedges[h].source;
        if(number[v] == null_index)
        {
          number[v] = static_cast<Index>(result.vertices.size());
          result.vertices.push_back(v);
          result.points.push_back(points[v]);
        }
        corners.push_back(number[v]);
      }
    result.table = make_corner_table(result.vertices.size(), corners, true);
    return result;
  }
};

// A block of faces, as a surface with border. The vertices inside come first.
struct Face_block
{
  Partial_surface surface;
  std::size_t number_of_vertices_inside = 0, number_of_edges_inside = 0;
};

// Copies a block of a surface. `number` has a place for each vertex of the surface, null_index at first; those of the
// vertices inside the block are written. Linear in the block, but for its border.
inline Face_block make_face_block(const Surface_in_blocks& whole, const Face_blocks& blocks, Index block,
                                  std::vector<Index>& number)
{
  Face_block result;
  Partial_surface& s = result.surface;
  std::vector<Index> at_border; // halfedges out of vertices at the border
  s.table.halfedges.reserve(3 * static_cast<std::size_t>(blocks.number_of_faces(block)));
  for(Index i = 0; i < blocks.number_of_faces(block); ++i)
    for(Index k = 0; k < 3; ++k)
    {
      const Corner_table::Halfedge& h = whole.table.halfedges[3 * blocks.face(block, i) + k];
      const Index beside = h.opposite == null_index ? null_index : blocks.place(block, h.opposite / 3);
      s.table.halfedges.push_back({h.source, beside == null_index ? null_index : 3 * beside + h.opposite % 3});
      if(blocks.block_of_vertex(h.source) == null_index)
      {
        at_border.push_back(3 * i + k);
        continue;
      }
      Index& local = number[h.source];
      if(local == null_index)
      {
        local = static_cast<Index>(s.vertices.size());
        s.vertices.push_back(h.source);
      }
      s.table.halfedges.back().source = local;
    }
  const std::size_t inside = result.number_of_vertices_inside = s.vertices.size();
  const auto source = [&s](Index h) -> Index& { return s.table.halfedges[h].source; };
  std::sort(at_border.begin(), at_border.end(), [&source](Index g, Index h) { return source(g) < source(h); });
  for(Index h : at_border)
  {
    if(s.vertices.size() == inside || s.vertices.back() != source(h))
      s.vertices.push_back(source(h));
    source(h) = static_cast<Index>(s.vertices.size() - 1);
  }
  s.points.reserve(s.vertices.size());
  for(Index v : s.vertices)
    s.points.push_back(whole.points[v]);
  s.table.outgoing.resize(s.vertices.size());
  for(Index h = 0; h < s.table.halfedges.size(); ++h)
  {
    s.table.outgoing[source(h)] = h;
    result.number_of_edges_inside +=
        h < s.table.halfedges[h].opposite && source(h) < inside && source(Corner_table::next(h)) < inside;
  }
  return result;
}

// Writes a block that has been simplified back. Of other blocks it touches nothing. Linear in the block.
inline void write_back(const Face_block& simplified, const Face_blocks& blocks, Index block, Surface_in_blocks& whole)
{
  const Partial_surface& s = simplified.surface;
  for(std::size_t i = 0; i < simplified.number_of_vertices_inside; ++i)
    whole.points[s.vertices[i]] = s.points[i];
  for(Index i = 0; i < blocks.number_of_faces(block); ++i)
    for(Index k = 0; k < 3; ++k)
    {
      const Index o = s.table.halfedges[3 * i + k].opposite;
      Corner_table::Halfedge& h = whole.table.halfedges[3 * blocks.face(block, i) + k];
      h.source = s.vertices[s.table.halfedges[3 * i + k].source];
      if(o != null_index)
        h.opposite = 3 * blocks.face(block, o / 3) + o % 3;
    }
}

// Collapses edges inside each block until only the given share of them is left. A block fits into the cache, and blocks
// are independent, so that several processors can work. Edges at the border of a block stay as they are. Appends the
// collapses to the record, block by block.
template <class ConcurrencyTag, class Progress>
void simplify_blocks(Surface_in_blocks& surface, const Face_blocks& blocks, double share, bool with_refused_seeds,
                     Collapse_record& record, const Progress& on_step)
{
  std::vector<Collapse_record> records(blocks.size());
  std::vector<Index> number(surface.points.size(), null_index);
  std::mutex mutex;
  std::size_t done = record.collapses.size();
  CGAL::for_each<ConcurrencyTag>(records, [&](Collapse_record& result) {
    const Index b = static_cast<Index>(&result - records.data());
    Face_block block = make_face_block(surface, blocks, b, number);
    Partial_surface& s = block.surface;
    Collapse_passes(s.table, s.points, block.number_of_vertices_inside, s.vertices, with_refused_seeds, result)
        .run(static_cast<std::size_t>((1 - share) * static_cast<double>(block.number_of_edges_inside)) / 3);
    write_back(block, blocks, b, surface);
    const std::lock_guard<std::mutex> lock(mutex);
    on_step(done += result.collapses.size());
    return true;
  });
  for(Collapse_record& r : records)
  {
    for(Seed_curve& s : r.refused_seeds)
    {
      s.level += record.collapses.size();
      record.refused_seeds.push_back(std::move(s));
    }
    record.collapses.insert(record.collapses.end(), r.collapses.begin(), r.collapses.end());
    r = Collapse_record();
  }
  surface.faces.erase(std::remove_if(surface.faces.begin(), surface.faces.end(),
                                     [&surface](Index f) { return Collapse_passes::is_out(surface.table, f); }),
                      surface.faces.end());
}

// Simplifies a surface in blocks, and what is left of it in other blocks, until few faces are left. Appends the
// collapses to the record, and returns what is left. The faces of T^0 are numbered anew, block after block, so that
// neighbouring faces are near to each other in memory from here on. O(n log n).
template <class ConcurrencyTag, class ImportedMesh, class Progress>
Partial_surface simplify_in_blocks(ImportedMesh& imported, const Block_simplification& parameters,
                                   bool with_refused_seeds, Collapse_record& record, const Progress& on_step)
{
  Surface_in_blocks surface;
  surface.faces.resize(imported.number_of_faces());
  std::iota(surface.faces.begin(), surface.faces.end(), Index(0));
  {
    const Halved_faces halved(imported.table, imported.points, surface.faces, parameters.block_faces);
    imported.reorder_faces(halved.order());
    surface.table = imported.table;
    surface.points = imported.points;
    simplify_blocks<ConcurrencyTag>(surface, Face_blocks(surface.table, surface.faces, halved.first()),
                                    parameters.share, with_refused_seeds, record, on_step);
  }
  for(std::size_t before = imported.number_of_faces();
      surface.faces.size() > parameters.rest_faces && surface.faces.size() < before;)
  {
    before = surface.faces.size();
    const Halved_faces halved(surface.table, surface.points, surface.faces, parameters.block_faces);
    simplify_blocks<ConcurrencyTag>(surface, Face_blocks(surface.table, halved.order(), halved.first()),
                                    parameters.share, with_refused_seeds, record, on_step);
  }
  return surface.rest();
}

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SIMPLIFY_SIMPLIFY_IN_BLOCKS_H
