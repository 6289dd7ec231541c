// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_FILE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_FILE_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_query_file.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/internal/surface/check_loop.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// The file of a prepared mesh: a line of text, the version, the mesh that it belongs to, the order of the faces, the
// collapses, the seeds, and a checksum. Numbers are little-endian. What is linear in the mesh is not in it.

namespace CGAL {
namespace Surface_mesh_constrictions {
namespace internal {

constexpr char query_file_magic[] = "constrictions query\n";
// Greater when the format, or what a preparation gives for some mesh, is another one.
constexpr std::uint32_t query_file_version = 1;

// Coordinates of levels are beyond this only in a file that no simplification has led to; their sixth powers are
// numbers.
const double greatest_level_coordinate = std::ldexp(1.0, 160);

// The hash FNV-1a of 64 bits, the same on every platform.
class Fnv_hash
{
public:
  void add_byte(unsigned char byte) { m_value = (m_value ^ byte) * 1099511628211u; }

  void add(std::uint64_t number, int bytes)
  {
    for(int i = 0; i < bytes; ++i)
      add_byte(static_cast<unsigned char>(number >> (8 * i)));
  }

  std::uint64_t value() const { return m_value; }

private:
  std::uint64_t m_value = 14695981039346656037u;
};

inline std::uint64_t bits_of(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(bits));
  return bits;
}

// What a file must agree with: the mesh, and which parameters of the preparation were given.
struct Query_file_key
{
  std::uint64_t hash = 0, vertices = 0, faces = 0;
  std::uint32_t given = 0;
};

// What a file holds.
struct Query_record
{
  std::vector<Index> order; // of the faces; empty if it is that of the mesh
  std::vector<Edge_collapse> collapses;
  std::vector<Seed_curve> seeds;
};

// Writes through a block of bytes.
class Query_file_writer
{
public:
  explicit Query_file_writer(std::ostream& out) : m_out(out) {}

  void put(std::uint64_t number, int bytes)
  {
    m_hash.add(number, bytes);
    for(int i = 0; i < bytes; ++i)
      m_block.push_back(static_cast<char>(static_cast<unsigned char>(number >> (8 * i))));
    if(m_block.size() >= 65536)
      flush();
  }

  void put(const Query_file_key& key, const Query_record& record)
  {
    for(const char* c = query_file_magic; *c != 0; ++c)
      put(static_cast<unsigned char>(*c), 1);
    put(query_file_version, 4);
    put(key.given, 4);
    put(key.vertices, 8);
    put(key.faces, 8);
    put(key.hash, 8);
    put(record.order.size(), 8);
    for(Index f : record.order)
      put(f, 4);
    put(record.collapses.size(), 8);
    for(const Edge_collapse& c : record.collapses)
    {
      put(c.removed, 4);
      put(c.kept, 4);
      for(int i = 0; i < 3; ++i)
        put(bits_of(c.point[i]), 8);
    }
    put(record.seeds.size(), 8);
    for(const Seed_curve& s : record.seeds)
    {
      put(s.level, 4);
      put(static_cast<std::uint64_t>(s.origin), 4);
      put(s.vertices.size(), 4);
      for(Index v : s.vertices)
        put(v, 4);
    }
    put(m_hash.value(), 8);
    flush();
  }

private:
  void flush()
  {
    m_out.write(m_block.data(), static_cast<std::streamsize>(m_block.size()));
    m_block.clear();
  }

  std::ostream& m_out;
  std::string m_block;
  Fnv_hash m_hash;
};

// Reads what a writer wrote. Throws Invalid_query_file for anything else.
class Query_file_reader
{
public:
  explicit Query_file_reader(std::istream& in)
  {
    char block[65536];
    while(in.read(block, sizeof(block)) || in.gcount() > 0)
      m_bytes.append(block, static_cast<std::size_t>(in.gcount()));
  }

  Query_record get(const Query_file_key& key)
  {
    check_head(key);
    Query_record record;
    const std::size_t ordered = count(4, "faces");
    if(ordered != 0 && ordered != key.faces)
      refuse("the order of the faces has " + std::to_string(ordered) + " of " + std::to_string(key.faces));
    std::vector<bool> is_placed(ordered, false);
    record.order.reserve(ordered);
    for(std::size_t i = 0; i < ordered; ++i)
    {
      const Index f = index(ordered, "face");
      if(is_placed[f])
        refuse("face " + std::to_string(f) + " is in the order of the faces twice");
      is_placed[f] = true;
      record.order.push_back(f);
    }
    const std::size_t collapses = count(32, "collapses");
    record.collapses.reserve(collapses);
    for(std::size_t i = 0; i < collapses; ++i)
    {
      const Index removed = index(key.vertices, "vertex"), kept = index(key.vertices, "vertex");
      double x[3];
      for(double& coordinate : x)
      {
        const std::uint64_t bits = number(8);
        std::memcpy(&coordinate, &bits, sizeof(bits));
        if(!(std::abs(coordinate) <= greatest_level_coordinate))
          refuse("the coordinate of a collapse is no number of moderate size");
      }
      record.collapses.push_back({removed, kept, Progressive_mesh::Point(x[0], x[1], x[2])});
    }
    const std::size_t seeds = count(24, "seeds"); // of three vertices at least
    record.seeds.reserve(seeds);
    for(std::size_t i = 0; i < seeds; ++i)
    {
      const Index level = index(collapses + 1, "level");
      const Index origin = index(static_cast<std::size_t>(Seed_origin::BOUNDARY) + 1, "origin");
      const std::size_t size = number(4);
      if(size < 3 || size > left() / 4)
        refuse("a seed of " + std::to_string(size) + " vertices");
      Seed_curve seed = {level, {}, static_cast<Seed_origin>(origin)};
      seed.vertices.reserve(size);
      for(std::size_t j = 0; j < size; ++j)
        seed.vertices.push_back(index(key.vertices, "vertex"));
      record.seeds.push_back(std::move(seed));
    }
    if(left() != 0)
      refuse(std::to_string(left()) + " bytes more than expected");
    return record;
  }

private:
  [[noreturn]] void refuse(const std::string& what) const { throw Invalid_query_file(m_place, what); }

  void check_head(const Query_file_key& key)
  {
    const std::size_t magic = sizeof(query_file_magic) - 1;
    m_end = m_bytes.size();
    if(m_bytes.compare(0, magic, query_file_magic) != 0)
      refuse("not the file of a prepared mesh, or cut off in its first line");
    m_place = magic;
    const std::uint64_t version = number(4);
    if(version != query_file_version)
      throw Invalid_query_file(magic, "version " + std::to_string(version) + " of the format; this is version " +
                                          std::to_string(query_file_version));
    if(left() < 8)
      refuse("cut off");
    m_end -= 8;
    Fnv_hash hash;
    for(std::size_t i = 0; i < m_end; ++i)
      hash.add_byte(static_cast<unsigned char>(m_bytes[i]));
    std::uint64_t checksum = 0;
    for(std::size_t i = 8; i-- > 0;)
      checksum = checksum << 8 | static_cast<unsigned char>(m_bytes[m_end + i]);
    if(checksum != hash.value())
      throw Invalid_query_file(m_end, "damaged or cut off: the checksum differs");
    const std::size_t place = m_place;
    const std::uint64_t given = number(4), vertices = number(8), faces = number(8), mesh = number(8);
    if(vertices != key.vertices || faces != key.faces)
      throw Invalid_query_file(place + 4, "prepared for another mesh: it has " + std::to_string(vertices) +
                                              " vertices and " + std::to_string(faces) + " faces, this one " +
                                              std::to_string(key.vertices) + " and " + std::to_string(key.faces));
    if(mesh != key.hash)
      throw Invalid_query_file(place + 20, "prepared for another mesh, of other points or faces");
    if(given != key.given)
      throw Invalid_query_file(place, "prepared with other parameters: of the policies and the seed sources, either "
                                      "those of the file or those asked for are the default");
  }

  std::size_t left() const { return m_end - m_place; }

  std::uint64_t number(std::size_t bytes)
  {
    if(left() < bytes)
      refuse("cut off");
    std::uint64_t result = 0;
    for(std::size_t i = bytes; i-- > 0;)
      result = result << 8 | static_cast<unsigned char>(m_bytes[m_place + i]);
    m_place += bytes;
    return result;
  }

  std::size_t count(std::size_t least_bytes, const std::string& of)
  {
    const std::uint64_t result = number(8);
    if(result > left() / least_bytes)
      refuse("the file is too short for " + std::to_string(result) + " " + of);
    return static_cast<std::size_t>(result);
  }

  Index index(std::uint64_t end, const std::string& of)
  {
    const std::uint64_t result = number(4);
    if(result >= end)
      refuse(of + " " + std::to_string(result) + " of " + std::to_string(end));
    return static_cast<Index>(result);
  }

  std::string m_bytes;
  std::size_t m_place = 0, m_end = 0;
};

// The collapses of a surface at level 0. Linear.
inline std::vector<Edge_collapse> collapses_of(Progressive_mesh pm)
{
  std::vector<Edge_collapse> result;
  result.reserve(pm.number_of_collapses());
  while(pm.level() < pm.number_of_collapses())
  {
    const Progressive_mesh::Split s = pm.collapse();
    result.push_back({s.removed, s.kept, pm.point(s.kept)});
  }
  return result;
}

// Appends collapses that need not be possible. The checksum does not keep out a file that was made to harm, so the link
// condition is checked for each, and the edges of each seed on its level.
class Collapse_checker
{
public:
  explicit Collapse_checker(Progressive_mesh& pm) : m_pm(pm), m_seen(pm.number_of_vertex_ids(), null_index) {}

  // Throws Invalid_query_file. O(degree) for each collapse, and for each vertex of a seed.
  void append(const Query_record& record)
  {
    std::vector<std::size_t> seeds(record.seeds.size()); // by level
    std::iota(seeds.begin(), seeds.end(), std::size_t(0));
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](std::size_t a, std::size_t b) { return record.seeds[a].level < record.seeds[b].level; });
    auto seed = seeds.begin();
    for(std::size_t k = 0; k <= record.collapses.size(); ++k)
    {
      for(; seed != seeds.end() && record.seeds[*seed].level == k; ++seed)
        check_seed(record.seeds[*seed].vertices, *seed);
      if(k == record.collapses.size())
        return;
      if(!is_possible(record.collapses[k]))
        throw Invalid_query_file(0, "collapse " + std::to_string(k) + " is none of this surface");
      m_pm.append_collapse(record.collapses[k]);
    }
  }

private:
  void check_seed(const std::vector<Index>& path, std::size_t number) const
  {
    try
    {
      check_loop(m_pm, path, number);
    }
    catch(const Invalid_input& e)
    {
      throw Invalid_query_file(0, std::string("seeds: ") + e.what());
    }
  }

  bool has_more_than_three_edges(Index v) const
  {
    const Index h = m_pm.outgoing(v);
    return m_pm.ccw(m_pm.ccw(m_pm.ccw(h))) != h;
  }

  // That a surface is left: the ends have two neighbours in common, those of the two faces, neither of degree three.
  bool is_possible(const Edge_collapse& c)
  {
    const auto is_in = [this](Index v) { return m_pm.is_vertex(v) && !m_pm.is_ghost_vertex(v); };
    if(!is_in(c.removed) || !is_in(c.kept))
      return false;
    const Index edge = m_pm.halfedge(c.removed, c.kept);
    if(edge == null_index || !has_more_than_three_edges(m_pm.source(m_pm.prev(edge))) ||
       !has_more_than_three_edges(m_pm.source(m_pm.prev(m_pm.opposite(edge)))))
      return false;
    const Index mark = static_cast<Index>(m_pm.level());
    for(Index h = m_pm.ccw(edge); h != edge; h = m_pm.ccw(h))
      m_seen[m_pm.target(h)] = mark;
    const Index back = m_pm.opposite(edge);
    std::size_t common = 0;
    for(Index h = m_pm.ccw(back); h != back; h = m_pm.ccw(h))
      common += m_seen[m_pm.target(h)] == mark;
    return common == 2;
  }

  Progressive_mesh& m_pm;
  std::vector<Index> m_seen; // by vertex, the level of the last collapse whose removed vertex had it as neighbour
};

} // namespace internal
} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_DETECT_QUERY_FILE_H
