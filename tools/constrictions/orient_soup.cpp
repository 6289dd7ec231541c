// SPDX-License-Identifier: GPL-3.0-or-later
#include "orient_soup.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
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

} // namespace constrictions
