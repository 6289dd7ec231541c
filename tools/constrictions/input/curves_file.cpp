// SPDX-License-Identifier: GPL-3.0-or-later
#include "input/curves_file.h"

#include "input/find_on_mesh.h"
#include "input/input_file.h"

#include <CGAL/squared_distance_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace constrictions {

namespace {

typedef nlohmann::json Json;
typedef CGAL::Surface_mesh_constrictions::Constriction<Mesh> Constriction;
typedef Constriction::Location Location;

// Below this a coordinate is what rounding has left of a zero.
const double zero_tolerance = 1e-9;

Json parse(const Input_file& file)
{
  try
  {
    return Json::parse(file.content);
  }
  catch(const Json::parse_error& e)
  {
    file.fail("not JSON: wrong at byte " + std::to_string(e.byte));
  }
  catch(const Json::exception&)
  {
    file.fail("not JSON: a number is too large");
  }
}

class Curve_reader
{
public:
  Curve_reader(const Input_file& file, const Mesh& mesh, const File_numbering& numbering)
    : m_file(file), m_mesh(mesh), m_numbering(numbering), m_first_triangle(numbering.faces + 1, 0)
  {
    if(numbering.face.empty())
      return;
    for(Index f : numbering.face)
      ++m_first_triangle[f + std::size_t(1)];
    for(std::size_t f = 0; f < numbering.faces; ++f)
      m_first_triangle[f + 1] += m_first_triangle[f];
  }

  Curves read(const Json& json)
  {
    if(!json.is_object())
      fail("not a JSON object");
    if(json.contains("format") && json["format"] != "constrictions/1")
      fail("the format is not \"constrictions/1\"");
    if(json.contains("mesh"))
      check_mesh(json["mesh"]);

    Curves result;
    result.are_found_by_points = is_numbered_anew(array(json, "constrictions"));
    for(const Json& curve : array(json, "constrictions"))
    {
      std::uint64_t id = result.ids.size();
      m_place = "curve at place " + std::to_string(id) + ": ";
      if(!curve.is_object())
        fail("not a JSON object");
      if(curve.contains("id"))
        id = number(curve, "id");
      m_place = "curve " + std::to_string(id) + ": ";
      result.ids.push_back(id);
      if(!result.are_found_by_points)
        result.curves.push_back(read_curve(curve, id));
    }
    if(result.are_found_by_points)
      result.curves = find_curves(json["constrictions"], result.ids);
    return result;
  }

private:
  typedef std::array<double, 3> Barycentric;    // in the order of the corners in the mesh
  typedef std::array<std::uint64_t, 3> Corners; // vertices of the file

  [[noreturn]] void fail(const std::string& reason) const { m_file.fail(m_place + reason); }

  void check_mesh(const Json& mesh) const
  {
    if(!mesh.is_object() || !mesh.contains("faces"))
      return;
    const std::uint64_t faces = number(mesh, "faces");
    if(faces != m_numbering.faces)
      fail("the curves are of a mesh with " + std::to_string(faces) + " faces, this one has " +
           std::to_string(m_numbering.faces));
  }

  const Json& array(const Json& object, const char* key) const
  {
    const auto it = object.find(key);
    if(it == object.end() || !it->is_array())
      fail(quoted(key) + (it == object.end() ? " is missing" : " is not an array"));
    return *it;
  }

  std::uint64_t number(const Json& object, const char* key) const
  {
    if(!object.is_object() || !object.contains(key))
      fail(quoted(key) + " is missing");
    const Json& value = object[key];
    if(!value.is_number_unsigned())
      fail(quoted(key) + " is not a number counted from 0");
    return value.get<std::uint64_t>();
  }

  // How far a point may be from where it belongs.
  double tolerance() const
  {
    CGAL::Bbox_3 box;
    for(Mesh::Vertex_index v : m_mesh.vertices())
      box += m_mesh.point(v).bbox();
    const double x = box.xmax() - box.xmin(), y = box.ymax() - box.ymin(), z = box.zmax() - box.zmin();
    return 1e-5 * std::sqrt(x * x + y * y + z * z);
  }

  // The points of a curve in space; nothing if they are missing, or are something else.
  static std::optional<std::vector<Point>> points_of(const Json& curve)
  {
    if(!curve.is_object() || !curve.contains("points") || !curve["points"].is_array())
      return std::nullopt;
    std::vector<Point> result;
    for(const Json& p : curve["points"])
    {
      if(!p.is_array() || p.size() != 3 ||
         !std::all_of(p.begin(), p.end(), [](const Json& x) { return x.is_number(); }))
        return std::nullopt;
      result.emplace_back(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
    }
    return result;
  }

  // Three coordinates as they are in the file; nothing if the member is something else.
  static std::optional<Barycentric> coordinates_of(const Json& location)
  {
    const auto it = location.find("barycentric");
    if(it == location.end() || !it->is_array() || it->size() != 3 ||
       !std::all_of(it->begin(), it->end(), [](const Json& x) { return x.is_number(); }))
      return std::nullopt;
    return Barycentric{(*it)[0].get<double>(), (*it)[1].get<double>(), (*it)[2].get<double>()};
  }

  // Whether a point is in a triangle of the face that a location names. If the face is a triangle in the file, too, of
  // its edges the one that the location names must be nearest, and of its corners that of the pivot. To ask for the
  // nearest one allows for a mesh whose vertices have been rounded, along with the edges between them.
  bool is_at(const Point& p, const Json& location, const std::optional<std::uint64_t>& pivot, double distance) const
  {
    typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
    const std::uint64_t f = location["face"].get<std::uint64_t>();
    if(f >= m_numbering.faces)
      return false;
    const bool is_plain = m_numbering.face.empty();
    const std::size_t begin = is_plain ? f : m_first_triangle[f], end = is_plain ? f + 1 : m_first_triangle[f + 1];
    for(std::size_t t = begin; t < end; ++t)
    {
      const Mesh::Face_index face(static_cast<Mesh::size_type>(t));
      const Mesh::Halfedge_index h = m_mesh.halfedge(face);
      const std::array<Mesh::Vertex_index, 3> corners = {m_mesh.source(h), m_mesh.target(h),
                                                         m_mesh.target(m_mesh.next(h))};
      const auto place = [&](std::size_t i) { return m_mesh.point(corners[i % 3]); };
      if(CGAL::squared_distance(p, Kernel::Triangle_3(place(0), place(1), place(2))) > distance * distance)
        continue;
      std::optional<Barycentric> b = coordinates_of(location);
      if(!b || m_numbering.is_piece_of_polygon(face))
        return true;
      if(m_numbering.is_turned_round(face))
        std::swap((*b)[1], (*b)[2]);
      const auto is_nearest = [&](std::size_t named, const auto& squared_distance) {
        const double d = squared_distance(named);
        return d <= distance * distance || (d <= squared_distance(named + 1) && d <= squared_distance(named + 2));
      };
      if(pivot)
      {
        const std::size_t corner = static_cast<std::size_t>(std::max_element(b->begin(), b->end()) - b->begin());
        return is_called(corners[corner], *pivot) &&
               is_nearest(corner, [&](std::size_t i) { return CGAL::squared_distance(p, place(i)); });
      }
      if(std::count(b->begin(), b->end(), 0.) > 1)
        return true; // beside a corner, where two edges are near
      return is_nearest(opposite_of_edge(*b), [&](std::size_t i) {
        return CGAL::squared_distance(p, Kernel::Segment_3(place(i + 1), place(i + 2)));
      });
    }
    return false;
  }

  // Whether each location names a face.
  static bool have_faces(const Json& locations)
  {
    return std::all_of(locations.begin(), locations.end(), [](const Json& location) {
      return location.is_object() && location.contains("face") && location["face"].is_number_unsigned();
    });
  }

  // The vertex of the file at each point that is a pivot.
  static std::vector<std::optional<std::uint64_t>> pivots_of(const Json& curve, std::size_t number_of_points)
  {
    std::vector<std::optional<std::uint64_t>> result(number_of_points);
    const auto is_number = [](const Json& pivot, const char* key) {
      return pivot.is_object() && pivot.contains(key) && pivot[key].is_number_unsigned();
    };
    if(curve.contains("pivots") && curve["pivots"].is_array())
      for(const Json& pivot : curve["pivots"])
        if(is_number(pivot, "vertex") && is_number(pivot, "point") &&
           pivot["point"].get<std::uint64_t>() < number_of_points)
          result[pivot["point"].get<std::size_t>()] = pivot["vertex"].get<std::uint64_t>();
    return result;
  }

  // Whether more than a quarter of the crossings, or of the pivots, are not where the numbers say: the compression of
  // meshoptimizer turns two faces of five. A single wrong number is for the certificate to find. What cannot be
  // understood is no reason: it is told later.
  bool is_numbered_anew(const Json& curves) const
  {
    const double distance = tolerance();
    std::array<std::size_t, 2> points = {0, 0}, elsewhere = {0, 0}; // of crossings and of pivots
    for(const Json& curve : curves)
    {
      const std::optional<std::vector<Point>> places = points_of(curve);
      if(!places || !curve.contains("locations") || !curve["locations"].is_array() ||
         curve["locations"].size() != places->size() || !have_faces(curve["locations"]))
        continue;
      const std::vector<std::optional<std::uint64_t>> pivots = pivots_of(curve, places->size());
      for(std::size_t i = 0; i < places->size(); ++i)
      {
        const std::size_t from_behind = places->size() - 1 - i; // others may have turned the locations round
        const Json& location = curve["locations"][i];
        const std::size_t kind = pivots[i] ? 1 : 0;
        ++points[kind];
        elsewhere[kind] += !is_at((*places)[i], location, pivots[i], distance) &&
                           !is_at((*places)[from_behind], location, pivots[i], distance);
      }
    }
    return 4 * elsewhere[0] > points[0] || 4 * elsewhere[1] > points[1];
  }

  std::vector<Constriction> find_curves(const Json& curves, const std::vector<std::uint64_t>& ids)
  {
    std::vector<std::vector<Curve_point>> points;
    for(std::size_t c = 0; c < curves.size(); ++c)
    {
      m_place = "curve " + std::to_string(ids[c]) + ": ";
      const std::optional<std::vector<Point>> places = points_of(curves[c]);
      if(!places || places->empty())
        fail("the mesh is numbered in another way, and \"points\" are missing");
      points.emplace_back();
      for(const Point& p : *places)
        points.back().push_back({p, false});
      if(curves[c].contains("pivots"))
        for(const Json& pivot : array(curves[c], "pivots"))
          if(const std::uint64_t point = number(pivot, "point"); point < points.back().size())
            points.back()[point].is_pivot = true;
    }
    std::vector<Constriction> result;
    const std::vector<Found_curve> found = find_on_mesh(m_mesh, points, tolerance());
    for(std::size_t c = 0; c < found.size(); ++c)
    {
      if(found[c].lost)
      {
        m_place = "curve " + std::to_string(ids[c]) + ", point " + std::to_string(*found[c].lost) + ": ";
        fail("it is not on this mesh, whose faces have other numbers than those of the curves");
      }
      Constriction::Data data;
      data.locations = found[c].locations;
      direct(data.locations);
      data.length = length(data.locations);
      result.push_back(Constriction(std::move(data)));
    }
    return result;
  }

  Constriction read_curve(const Json& curve, std::uint64_t id)
  {
    const Json& locations = array(curve, "locations");
    if(locations.empty())
      fail("it has no locations");
    const std::vector<Mesh::Vertex_index> pivots = read_pivots(curve, locations.size());

    Constriction::Data data;
    std::vector<Mesh::Face_index> faces;
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      m_place = "curve " + std::to_string(id) + ", point " + std::to_string(i) + ": ";
      faces.push_back(read_face(locations[i]));
      data.locations.push_back(read_location(locations[i], faces.back(), pivots[i]));
    }
    if(curve.contains("pivots"))
      cross_beside_corners(data.locations, faces, pivots);
    direct(data.locations);
    data.length = length(data.locations);
    return Constriction(std::move(data));
  }

  // The vertex of the file at each point; the null vertex where none is named.
  std::vector<Mesh::Vertex_index> read_pivots(const Json& curve, std::size_t number_of_points) const
  {
    std::vector<Mesh::Vertex_index> result(number_of_points, Mesh::null_vertex());
    if(!curve.contains("pivots"))
      return result;
    for(const Json& pivot : array(curve, "pivots"))
    {
      const std::uint64_t v = number(pivot, "vertex"), point = number(pivot, "point");
      if(point >= number_of_points)
        fail("pivot at point " + std::to_string(point) + ", which does not exist: the curve has " +
             std::to_string(number_of_points) + " points");
      if(v >= m_numbering.vertices)
        fail("pivot at point " + std::to_string(point) + ": vertex " + std::to_string(v) +
             " does not exist: the mesh has " + std::to_string(m_numbering.vertices) + " vertices");
      result[point] = Mesh::Vertex_index(static_cast<Mesh::size_type>(v));
    }
    return result;
  }

  Mesh::Face_index read_face(const Json& location) const
  {
    const std::uint64_t f = number(location, "face");
    if(f >= m_numbering.faces)
      fail("face " + std::to_string(f) + " does not exist: the mesh has " + std::to_string(m_numbering.faces) +
           " faces");
    if(m_numbering.face.empty())
      return Mesh::Face_index(static_cast<Mesh::size_type>(f));
    const std::size_t begin = m_first_triangle[f], end = m_first_triangle[f + 1];
    if(begin == end)
      fail("face " + std::to_string(f) + " has been left out of the mesh");
    if(!m_numbering.is_piece_of_polygon(begin))
      return Mesh::Face_index(static_cast<Mesh::size_type>(begin));
    return read_piece(location, f, begin, end);
  }

  // Triangles of one face of the file follow each other.
  Mesh::Face_index read_piece(const Json& location, std::uint64_t f, std::size_t begin, std::size_t end) const
  {
    const Corners corners = read_corners(location, f);
    for(std::size_t t = begin; t < end; ++t)
    {
      const Mesh::Face_index face(static_cast<Mesh::size_type>(t));
      Corners own = corners_of(face);
      if(std::is_permutation(own.begin(), own.end(), corners.begin()))
        return face;
    }
    fail("\"triangle\" is not a piece of face " + std::to_string(f));
  }

  Corners read_corners(const Json& location, std::uint64_t f) const
  {
    if(!location.contains("triangle"))
      fail("face " + std::to_string(f) + " is not a triangle, and \"triangle\" is missing");
    const Json& triangle = array(location, "triangle");
    if(triangle.size() != 3 ||
       !std::all_of(triangle.begin(), triangle.end(), [](const Json& x) { return x.is_number_unsigned(); }))
      fail("\"triangle\" is not three numbers counted from 0");
    return {triangle[0].get<std::uint64_t>(), triangle[1].get<std::uint64_t>(), triangle[2].get<std::uint64_t>()};
  }

  Corners corners_of(Mesh::Face_index face) const
  {
    Corners result;
    Mesh::Halfedge_index h = m_mesh.halfedge(face);
    for(std::uint64_t& v : result)
    {
      v = m_numbering.vertex_of(m_mesh.source(h));
      h = m_mesh.next(h);
    }
    return result;
  }

  Location read_location(const Json& location, Mesh::Face_index face, Mesh::Vertex_index pivot) const
  {
    array(location, "barycentric");
    const std::optional<Barycentric> coordinates = coordinates_of(location);
    if(!coordinates)
      fail("\"barycentric\" is not three numbers");
    Barycentric b = *coordinates;
    // one digit behind the point is enough
    const double sum_tolerance = 0.2;
    if(*std::min_element(b.begin(), b.end()) < -zero_tolerance || !(std::abs(b[0] + b[1] + b[2] - 1) < sum_tolerance))
      fail("\"barycentric\" is not a point of a face: a number is negative, or the sum is not 1");
    if(m_numbering.is_piece_of_polygon(face))
    {
      const Corners given = read_corners(location, m_numbering.face_of(face)), own = corners_of(face);
      const Barycentric in_given_order = b;
      for(std::size_t i = 0; i < 3; ++i)
        b[i] = in_given_order[static_cast<std::size_t>(std::find(given.begin(), given.end(), own[i]) - given.begin())];
    }
    else if(m_numbering.is_turned_round(face))
      std::swap(b[1], b[2]);
    return pivot == Mesh::null_vertex() ? location_on_edge(face, b) : location_at_vertex(face, b, pivot);
  }

  Mesh::Halfedge_index halfedge_from_corner(Mesh::Face_index face, std::size_t corner) const
  {
    Mesh::Halfedge_index h = m_mesh.halfedge(face);
    for(std::size_t i = 0; i < corner % 3; ++i)
      h = m_mesh.next(h);
    return h;
  }

  // Whether this is the number of a vertex in the file, or that of one which it stands for.
  bool is_called(Mesh::Vertex_index v, std::uint64_t vertex_of_file) const
  {
    const Index of_file = m_numbering.vertex_of(v);
    return vertex_of_file == of_file ||
           (vertex_of_file < m_numbering.vertices && m_numbering.stand_in_of(vertex_of_file) == of_file);
  }

  // The corner opposite to the edge on which these coordinates are.
  static std::size_t opposite_of_edge(const Barycentric& b)
  {
    const auto nearest_zero =
        std::min_element(b.begin(), b.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
    return static_cast<std::size_t>(nearest_zero - b.begin());
  }

  static Location location_at(Mesh::Vertex_index v) { return {true, v, Mesh::null_halfedge(), 0}; }

  Location location_at_vertex(Mesh::Face_index face, const Barycentric& b, Mesh::Vertex_index pivot) const
  {
    const std::size_t corner = static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin());
    const Mesh::Vertex_index v = m_mesh.source(halfedge_from_corner(face, corner));
    const bool is_at_corner = b[(corner + 1) % 3] < zero_tolerance && b[(corner + 2) % 3] < zero_tolerance;
    if(!is_at_corner || !is_called(v, pivot.idx()))
      fail("the pivot is vertex " + std::to_string(pivot.idx()) + ", the location another place");
    return location_at(v);
  }

  Location location_on_edge(Mesh::Face_index face, const Barycentric& b) const
  {
    if(std::count(b.begin(), b.end(), 0.) > 1)
      return location_at(m_mesh.source(
          halfedge_from_corner(face, static_cast<std::size_t>(std::max_element(b.begin(), b.end()) - b.begin()))));
    const std::size_t opposite = opposite_of_edge(b), first = opposite + 1;
    if(std::abs(b[opposite]) >= zero_tolerance)
      fail("no coordinate of \"barycentric\" is zero: the point is on no edge");
    const double from = b[first % 3], to = b[(first + 1) % 3];
    return {false, Mesh::null_vertex(), halfedge_from_corner(face, first), to / (from + to)};
  }

  // What is at a vertex and is no pivot is a crossing so near to it that it was rounded to it. It crosses the edge over
  // which the face given with the next point, or that at the next pivot, is reached. If there is no such edge it is a
  // pivot after all.
  void cross_beside_corners(std::vector<Location>& locations, const std::vector<Mesh::Face_index>& faces,
                            const std::vector<Mesh::Vertex_index>& pivots) const
  {
    for(std::size_t i = 0; i < locations.size(); ++i)
    {
      if(!locations[i].is_pivot || pivots[i] != Mesh::null_vertex())
        continue;
      const Mesh::Vertex_index v = locations[i].vertex;
      const std::size_t following = (i + 1) % locations.size();
      Mesh::Halfedge_index h = m_mesh.halfedge(faces[i]);
      while(m_mesh.target(h) != v)
        h = m_mesh.next(h);
      for(const Mesh::Halfedge_index crossed : {h, m_mesh.next(h)})
      {
        const Mesh::Halfedge_index o = m_mesh.opposite(crossed);
        if(m_mesh.is_border(o))
          continue;
        if(pivots[following] != Mesh::null_vertex() ? m_mesh.target(m_mesh.next(o)) == locations[following].vertex
                                                    : m_mesh.face(o) == faces[following])
          locations[i] = {false, Mesh::null_vertex(), crossed, m_mesh.source(crossed) == v ? 0. : 1.};
      }
    }
  }

  // Whether a straight line through the face of h, into it or out of it over h, can meet the other points of its
  // boundary at p.
  bool is_beyond(const Location& p, Mesh::Halfedge_index h) const
  {
    if(m_mesh.is_border(h))
      return false;
    if(p.is_pivot)
      return m_mesh.target(m_mesh.next(h)) == p.vertex;
    const Mesh::Edge_index e = m_mesh.edge(p.halfedge);
    return e == m_mesh.edge(m_mesh.next(h)) || e == m_mesh.edge(m_mesh.prev(h));
  }

  // Turns the crossed halfedges to the faces that the curve comes from. If only one neighbour fits it is the one before
  // that decides.
  void direct(std::vector<Location>& locations) const
  {
    const std::size_t n = locations.size();
    for(std::size_t i = 0; i < n; ++i)
    {
      Location& l = locations[i];
      if(l.is_pivot)
        continue;
      const Location &before = locations[(i + n - 1) % n], &after = locations[(i + 1) % n];
      const auto fit = [&](Mesh::Halfedge_index h) {
        return 2 * int(is_beyond(before, h)) + int(is_beyond(after, m_mesh.opposite(h)));
      };
      if(fit(m_mesh.opposite(l.halfedge)) <= fit(l.halfedge))
        continue;
      l.halfedge = m_mesh.opposite(l.halfedge);
      l.parameter = 1 - l.parameter;
    }
  }

  double length(const std::vector<Location>& locations) const
  {
    std::vector<Mesh::Point> points;
    Constriction::Data data;
    data.locations = locations;
    Constriction(std::move(data)).points(m_mesh, std::back_inserter(points));
    double result = 0;
    for(std::size_t i = 0; i < points.size(); ++i)
      result += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
    return result;
  }

  const Input_file& m_file;
  const Mesh& m_mesh;
  const File_numbering& m_numbering;
  std::vector<std::size_t> m_first_triangle; // by face of the file; its triangles follow each other
  std::string m_place;
};

} // namespace

Curves read_curves_file(const std::string& name, const Mesh& mesh, const File_numbering& numbering)
{
  const Input_file file = read_input_file(name);
  return Curve_reader(file, mesh, numbering).read(parse(file));
}

} // namespace constrictions
