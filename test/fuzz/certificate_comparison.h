// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_CERTIFICATE_COMPARISON_H
#define FUZZ_CERTIFICATE_COMPARISON_H

#include "failure.h"
#include "oracle.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

namespace SMC = CGAL::Surface_mesh_constrictions;

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;
typedef SMC::Constriction<Mesh> Constriction;

inline Mesh mesh_of(const Body& body)
{
  Mesh mesh;
  for(const std::array<double, 3>& p : body.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for(const auto& t : body.faces)
  {
    const auto v = [&t](std::size_t i) { return Mesh::Vertex_index(static_cast<std::uint32_t>(t[i])); };
    if(CGAL::Euler::add_face(std::array<Mesh::Vertex_index, 3>{{v(0), v(1), v(2)}}, mesh) == Mesh::null_face())
      fail("a face of a surface cannot be added");
  }
  return mesh;
}

// How many curves were compared, and how; how many the second witness was asked about; and on how many meshes the
// default call was compared with the selection of all.
struct Tally
{
  std::size_t meshes = 0, certified = 0, refused = 0, open = 0, witnessed = 0, compared_selections = 0;
};

// Certificates of curves on a body, and what the oracle says of them.
class Certificate_comparison
{
public:
  Certificate_comparison(const Body& body, const Mesh& mesh, Tally& tally)
    : m_mesh(mesh), m_oracle(body), m_tally(tally)
  {}

  // Compares a certificate with the oracle, and its place with the evidence there. Returns what the oracle says.
  Oracle::Answer compare(const Constriction& curve, const SMC::Certificate& certificate)
  {
    typedef SMC::Certificate_verdict V;
    const Oracle::Answer answer = m_oracle.examine(nodes_of(curve));
    if(certificate.verdict == V::TIE_NOT_PROVED || answer.finding == Finding::UNKNOWN)
    {
      ++m_tally.open;
      if(certificate.is_certified())
        fail("certified, but the oracle does not know: " + text_of(certificate));
      return answer;
    }
    ++(certificate.is_certified() ? m_tally.certified : m_tally.refused);
    const std::pair<std::size_t, bool> place = {certificate.location, certificate.side == SMC::Curve_side::LEFT};
    bool agrees = false;
    switch(certificate.verdict)
    {
    case V::STRICT_CONSTRICTION:
      agrees = answer.finding == Finding::STRICT;
      break;
    case V::CONSTRICTION:
      agrees = answer.finding == Finding::CONSTRICTION;
      break;
    case V::LEAKY_BAND:
      agrees = answer.finding == Finding::LEAKS;
      break;
    case V::NOT_A_CLOSED_CURVE:
      agrees = answer.finding == Finding::NOT_CLOSED;
      break;
    case V::NOT_STRAIGHT:
      agrees = answer.finding == Finding::NOT_STRAIGHT && answer.wrong_ends.count(place) > 0;
      break;
    case V::ANGLE_BELOW_PI:
      agrees = answer.finding == Finding::SMALL_ANGLE && answer.small_angles.count(place) > 0;
      break;
    case V::CROSSES_ITSELF:
      agrees = answer.finding == Finding::NOT_SIMPLE;
      break;
    case V::TOUCHES_ITSELF:
      agrees = answer.finding == Finding::NOT_SIMPLE && answer.repeats_vertex;
      break;
    default:
      break;
    }
    if(!agrees)
      fail(text_of(certificate) + ", but the oracle says: " + text_of(answer) + "; the curve is" +
           text_of(nodes_of(curve)));
    if(certificate.is_certified() && curve.length() > 0)
    {
      const double length = static_cast<double>(answer.length);
      if(std::abs(curve.length() - length) > 1e-9 * length)
        fail("the length is " + std::to_string(curve.length()) + " instead of " + std::to_string(length));
    }
    return answer;
  }

private:
  static std::string text_of(const SMC::Certificate& certificate)
  {
    std::ostringstream out;
    out << certificate;
    return out.str();
  }

  static std::string text_of(const Oracle::Answer& answer)
  {
    std::ostringstream out;
    const std::array<const char*, 8> names = {
        {"strict", "constriction", "leaks", "not closed", "not straight", "small angle", "not simple", "unknown"}};
    out << names[static_cast<std::size_t>(answer.finding)];
    for(const auto& places : {answer.small_angles, answer.wrong_ends})
      for(const auto& [point, is_left] : places)
        out << ", point " << point << (is_left ? " left" : " right");
    return out.str();
  }

  // A vertex each, or the ends of the edge that is crossed.
  static std::string text_of(const std::vector<Node>& nodes)
  {
    std::ostringstream out;
    for(const Node& n : nodes)
      if(n.vertex >= 0)
        out << ' ' << n.vertex;
      else
        out << ' ' << n.from << '-' << n.to;
    return out.str();
  }

  std::vector<Node> nodes_of(const Constriction& curve) const
  {
    std::vector<Node> result;
    for(const Constriction::Location& l : curve.locations())
      if(l.is_pivot)
        result.push_back({static_cast<int>(l.vertex), -1, -1});
      else
        result.push_back(
            {-1, static_cast<int>(m_mesh.source(l.halfedge)), static_cast<int>(m_mesh.target(l.halfedge))});
    return result;
  }

  const Mesh& m_mesh;
  Oracle m_oracle;
  Tally& m_tally;
};

} // namespace fuzz

#endif // FUZZ_CERTIFICATE_COMPARISON_H
