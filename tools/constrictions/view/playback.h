// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_PLAYBACK_H
#define CONSTRICTIONS_PLAYBACK_H

#include "input/mesh_file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace constrictions {

/// A surface with its coarser levels, small enough to be shown. Its levels are those of the whole surface from
/// `finest_level` on.
///
/// The vertices are numbered so that the i-th collapse takes out the last of those that are left: of n vertices the one
/// with the number n - 1 - i. It is merged into `parents[i]`, which moves to `moves[i]`.
struct Shown_levels
{
  std::size_t finest_level;
  std::vector<Mesh::Point> points;                 ///< on the finest level
  std::vector<std::array<std::uint32_t, 3>> faces; ///< corners on the finest level
  std::vector<std::size_t> input_faces; ///< for each face the place, in `faces(mesh)`, of the face that it was
  std::vector<std::uint32_t> parents;
  std::vector<Mesh::Point> moves;
};

/// A curve on a level.
struct Carried_curve
{
  std::size_t constriction;        ///< that its seed led to, by its place in the sequence
  bool is_seed;                    ///< whether it has just appeared
  std::vector<Mesh::Point> points; ///< closed, the first is not repeated
};

/// A level, and the curves on it.
struct Playback_frame
{
  std::size_t level;
  std::size_t vertices; ///< those that are not isolated
  std::vector<Carried_curve> curves;
};

/// How curves are carried from the coarsest level to the input.
struct Playback
{
  std::size_t collapses; ///< the level of the coarsest surface
  Shown_levels surface;
  std::vector<Playback_frame> frames; ///< the coarsest level first, the input last
  std::size_t number_followed;        ///< the constrictions whose seeds are followed: so many, the first
};

} // namespace constrictions

#endif // CONSTRICTIONS_PLAYBACK_H
