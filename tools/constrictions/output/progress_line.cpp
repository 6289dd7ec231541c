// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/progress_line.h"

#include "output/clock_time.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace constrictions {

namespace {

const std::array<const char*, 6> titles = {
    {"Simplification", "Seeds", "Refinement", "Tightening", "Certification", "Selection"}};

// About how much of the time of a detection each stage takes, in per cent.
const std::array<double, 6> shares = {{13, 10, 18, 5, 2, 52}};

// Of the stages before one, from another one on.
double sum_of_shares(std::size_t first, std::size_t end)
{
  return std::accumulate(shares.begin() + static_cast<std::ptrdiff_t>(first),
                         shares.begin() + static_cast<std::ptrdiff_t>(end), 0.);
}

} // namespace

std::string progress_line(const Stages& all, CGAL::Surface_mesh_constrictions::Detection_stage stage, double part,
                          double seconds)
{
  const std::size_t now = static_cast<std::size_t>(stage), first = (std::min)(static_cast<std::size_t>(all.first), now),
                    last = (std::max)(static_cast<std::size_t>(all.last), now);
  const double done = (sum_of_shares(first, now) + (std::min)(part, 1.) * shares[now]) / sum_of_shares(first, last + 1);
  std::string result =
      titles[now] + std::string(", ") + std::to_string(static_cast<int>(100 * done)) + "%, " + clock_time(seconds);
  const double enough = 0.05;
  if(done >= enough)
    result += ", about " + clock_time(seconds * (1 - done) / done) + " left";
  return result;
}

} // namespace constrictions
