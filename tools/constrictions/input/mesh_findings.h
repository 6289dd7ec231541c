// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_FINDINGS_H
#define CONSTRICTIONS_MESH_FINDINGS_H

#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace constrictions {

/// What can be said of a mesh file. Those up to `SPLIT_VERTICES` are repairs: the number of what was mended.
enum class Finding
{
  TRIANGULATED,     ///< faces with more than three corners, cut into triangles
  DUPLICATE_FACES,  ///< faces left out, as another one has the same corners
  DEGENERATE_FACES, ///< faces left out: fewer than three different corners, or without area where they are in the way
  COLLAPSED_EDGES,  ///< edges of length zero whose ends were made one
  MERGED_VERTICES,  ///< vertices merged into another one, as that closes the surface, or as the user asked for it
  TURNED_FACES,     ///< triangles turned round
  SPLIT_EDGES,      ///< edges with more than two faces, made several
  CUT_EDGES,        ///< edges with two faces, cut open beside one of those
  SPLIT_VERTICES,   ///< vertices that were added, so that each has one fan of faces
  HOLES,            ///< closed paths of border edges
  BORDER_EDGES,     ///< edges with one face
  T_VERTICES,       ///< vertices of the border in the middle of a border edge
  NEAR_VERTICES,    ///< vertices of the border that lie very near to another one
  ISOLATED_VERTICES ///< vertices on no face
};

const std::size_t number_of_findings = static_cast<std::size_t>(Finding::ISOLATED_VERTICES) + 1;

inline bool is_repair(Finding finding) { return finding <= Finding::SPLIT_VERTICES; }

/// the name of a finding in JSON
const char* name_of(Finding finding);

/// "3 holes"
std::string as_words(Finding finding, std::size_t count);

/// What was found in a mesh file, counted, with the first places.
class Mesh_findings
{
public:
  static const std::size_t shown_places = 5;

  /// \param place returns the words for the place; it is called for the first places only
  template <class Place>
  void add(Finding finding, Place place)
  {
    Entry& entry = m_entries[static_cast<std::size_t>(finding)];
    ++entry.count;
    if(entry.places.size() < shown_places)
      entry.places.push_back(place());
  }

  std::size_t count(Finding finding) const { return m_entries[static_cast<std::size_t>(finding)].count; }

  const std::vector<std::string>& places(Finding finding) const
  {
    return m_entries[static_cast<std::size_t>(finding)].places;
  }

  bool has_repairs() const;

  /// how far the vertices near others lie from them, at least and at most, and the value of `--merge` that merges them
  double nearest = 0, farthest = 0, merging_distance = 0;

private:
  struct Entry
  {
    std::size_t count = 0;
    std::vector<std::string> places;
  };

  std::array<Entry, number_of_findings> m_entries;
};

/// the repairs and holes in one line, without its end; empty if there are none
std::string summary_of(const Mesh_findings& findings);

/// throws `Invalid_input` for the first of the repairs, if there is one that a user who wants none does not accept: all
/// but faces turned round and vertices merged.
void refuse_repairs(const Mesh_findings& findings);

/// throws `Invalid_input` if most of the border is there only because vertices that belong together differ a little.
void refuse_cracks(const Mesh_findings& findings);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_FINDINGS_H
