// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/repair_soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace constrictions {

std::vector<Index> orient_soup(Triangle_soup& soup)
{
  std::vector<Point> points = soup.points;
  std::vector<std::vector<std::size_t> > faces;
  for(std::size_t i = 0; i < soup.corners.size(); i += 3)
    faces.push_back({soup.corners[i], soup.corners[i + 1], soup.corners[i + 2]});
  if(!CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces))
    return {};

  std::vector<Index> turned;
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    Index* const corner = soup.corners.data() + 3 * f;
    std::rotate(faces[f].begin(), std::find(faces[f].begin(), faces[f].end(), corner[0]), faces[f].end());
    if(faces[f][1] == corner[1])
      continue;
    std::swap(corner[1], corner[2]);
    turned.push_back(static_cast<Index>(f));
  }
  return turned;
}

bool close_seams(Triangle_soup& soup)
{
  std::vector<Index> order(soup.points.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(order.begin(), order.end(), [&soup](Index a, Index b) { return soup.points[a] < soup.points[b]; });
  std::vector<Index> first(soup.points.size());
  bool found = false;
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeated = i > 0 && soup.points[order[i]] == soup.points[order[i - 1]];
    first[order[i]] = repeated ? first[order[i - 1]] : order[i];
    found = found || repeated;
  }
  for(Index& corner : soup.corners)
    corner = first[corner];
  return found;
}

} // namespace constrictions
