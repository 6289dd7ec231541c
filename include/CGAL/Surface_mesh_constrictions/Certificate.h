// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFICATE_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFICATE_H

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Surface_mesh_constrictions {

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// A side of a curve, for an observer who walks along it on the outer side of the surface, to which its normals point.
enum class Curve_side
{
  LEFT,
  RIGHT
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// What exact arithmetic has proved of a closed curve.
enum class Certificate_verdict
{
  NOT_COMPUTED,         ///< nothing: no certificate has been computed
  STRICT_CONSTRICTION,  ///< a simple closed geodesic that is shorter than every other closed curve close to it
  CONSTRICTION,         ///< a simple closed geodesic in a flat band that holds at both ends
  LEAKY_BAND,           ///< a simple closed geodesic in a flat band that it can slip out of without getting longer
  NOT_A_CLOSED_CURVE,   ///< two consecutive locations do not fit together
  NOT_STRAIGHT,         ///< in the unfolded strip the arc does not cross the inside of each edge
  ANGLE_BELOW_PI,       ///< a side angle at a pivot is less than pi
  CROSSES_ITSELF,       ///< a closed geodesic that crosses itself
  TOUCHES_ITSELF,       ///< a closed geodesic that passes through a vertex twice without crossing itself there
  TIE_NOT_PROVED,       ///< a number stayed around zero and could not be proved to be zero
  GEODESIC_ARC,         ///< an open curve that is straight, with side angles of at least pi, between its held ends
  NO_DIRECTED_ROUNDING, ///< nothing: the thread's floating-point operations do not round in the direction that is set
  SUBNORMALS_FLUSHED    ///< nothing: the thread's floating-point operations take subnormal numbers for zero
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// How many signs each stage of the exact arithmetic decided.
struct Sign_statistics
{
  std::size_t interval = 0;       ///< by intervals of doubles
  std::size_t multiprecision = 0; ///< by intervals of higher precision
  std::size_t finite_field = 0;   ///< by a non-zero image in a finite field, then by intervals of any precision
  std::size_t algebra = 0;        ///< by writing the number as a sum of independent roots: most of these are zero
  std::size_t unproved = 0;       ///< not decided

  /// the numbers that were added since `b` was taken
  friend Sign_statistics operator-(Sign_statistics a, const Sign_statistics& b)
  {
    a.interval -= b.interval;
    a.multiprecision -= b.multiprecision;
    a.finite_field -= b.finite_field;
    a.algebra -= b.algebra;
    a.unproved -= b.unproved;
    return a;
  }

  /// the sums of the numbers
  friend Sign_statistics operator+(Sign_statistics a, const Sign_statistics& b)
  {
    a.interval += b.interval;
    a.multiprecision += b.multiprecision;
    a.finite_field += b.finite_field;
    a.algebra += b.algebra;
    a.unproved += b.unproved;
    return a;
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// The result of `certify_constriction()`: a verdict, and the place of the first condition that is violated.
struct Certificate
{
  Certificate_verdict verdict = Certificate_verdict::NOT_COMPUTED; ///< what has been proved, or what is violated
  std::size_t location = 0;                                        ///< of the violation, in `Constriction::locations()`
  std::size_t other_location = 0; ///< where the curve comes to the same place again, if it crosses or touches itself
  Curve_side side = Curve_side::LEFT; ///< of the angle below pi, of the leak, or of the end of the edge at which an arc
                                      ///< that is not straight leaves its strip
  double flat_band_width = 0;         ///< in the unit of the mesh's coordinates; 0 if there is no band
  Sign_statistics signs;              ///< how the signs were decided

  /// whether the curve is proved to be a constriction, strict or not
  bool is_certified() const
  {
    return verdict == Certificate_verdict::STRICT_CONSTRICTION || verdict == Certificate_verdict::CONSTRICTION;
  }
};

/// \ingroup PkgSurfaceMeshConstrictionsRef
/// writes the verdict as one line: `strict_constriction`, `constriction`, `geodesic_arc`, or `not_certified: ` and the
/// reason with its place.
inline std::ostream& operator<<(std::ostream& out, const Certificate& c)
{
  const char* const side = c.side == Curve_side::LEFT ? "left" : "right";
  switch(c.verdict)
  {
  case Certificate_verdict::STRICT_CONSTRICTION:
    return out << "strict_constriction";
  case Certificate_verdict::CONSTRICTION:
    return out << "constriction";
  case Certificate_verdict::LEAKY_BAND:
    return out << "not_certified: the flat band on the " << side << " leaks";
  case Certificate_verdict::NOT_A_CLOSED_CURVE:
    return out << "not_certified: not a closed curve, point " << c.location << " does not fit the next one";
  case Certificate_verdict::NOT_STRAIGHT:
    return out << "not_certified: not straight, the arc through point " << c.location << " passes the edge's " << side
               << " end on the wrong side or through it";
  case Certificate_verdict::ANGLE_BELOW_PI:
    return out << "not_certified: the side angle on the " << side << " of point " << c.location << " is less than pi";
  case Certificate_verdict::CROSSES_ITSELF:
    return out << "not_certified: not simple, crosses itself between points " << c.location << " and "
               << c.other_location;
  case Certificate_verdict::TOUCHES_ITSELF:
    return out << "not_certified: not simple, points " << c.location << " and " << c.other_location
               << " are the same vertex";
  case Certificate_verdict::TIE_NOT_PROVED:
    return out << "not_certified: tie not proved at point " << c.location;
  case Certificate_verdict::NO_DIRECTED_ROUNDING:
    return out << "not_certified: floating-point operations do not round in the direction that is set here, as under "
                  "valgrind";
  case Certificate_verdict::SUBNORMALS_FLUSHED:
    return out << "not_certified: floating-point operations take subnormal numbers for zero here, as a library linked "
                  "with -Ofast makes them do";
  case Certificate_verdict::GEODESIC_ARC:
    return out << "geodesic_arc";
  default:
    return out << "not_certified: no exact certificate has been computed";
  }
}

} // namespace Surface_mesh_constrictions
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_CERTIFICATE_H
