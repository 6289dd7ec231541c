// SPDX-License-Identifier: GPL-3.0-or-later
#include "names.h"

namespace constrictions {

namespace SMC = CGAL::Surface_mesh_constrictions;

// A switch without a default, so that compilers tell of a value that has no name yet.

const char* name_of(SMC::Certificate_verdict verdict)
{
  switch(verdict)
  {
  case SMC::Certificate_verdict::NOT_COMPUTED:
    return "not_computed";
  case SMC::Certificate_verdict::STRICT_CONSTRICTION:
    return "strict_constriction";
  case SMC::Certificate_verdict::CONSTRICTION:
    return "constriction";
  case SMC::Certificate_verdict::LEAKY_BAND:
    return "leaky_band";
  case SMC::Certificate_verdict::NOT_A_CLOSED_CURVE:
    return "not_a_closed_curve";
  case SMC::Certificate_verdict::NOT_STRAIGHT:
    return "not_straight";
  case SMC::Certificate_verdict::ANGLE_BELOW_PI:
    return "angle_below_pi";
  case SMC::Certificate_verdict::CROSSES_ITSELF:
    return "crosses_itself";
  case SMC::Certificate_verdict::TOUCHES_ITSELF:
    return "touches_itself";
  case SMC::Certificate_verdict::TIE_NOT_PROVED:
    return "tie_not_proved";
  case SMC::Certificate_verdict::GEODESIC_ARC:
    return "geodesic_arc";
  case SMC::Certificate_verdict::NO_DIRECTED_ROUNDING:
    return "no_directed_rounding";
  case SMC::Certificate_verdict::SUBNORMALS_FLUSHED:
    return "subnormals_flushed";
  }
  return "";
}

const char* name_of(SMC::Curve_side side) { return side == SMC::Curve_side::LEFT ? "left" : "right"; }

const char* name_of(SMC::Detection_stage stage)
{
  switch(stage)
  {
  case SMC::Detection_stage::SIMPLIFICATION:
    return "simplification";
  case SMC::Detection_stage::SEEDS:
    return "seeds";
  case SMC::Detection_stage::REFINEMENT:
    return "refinement";
  case SMC::Detection_stage::TIGHTENING:
    return "tightening";
  case SMC::Detection_stage::CERTIFICATION:
    return "certification";
  case SMC::Detection_stage::SELECTION:
    return "selection";
  }
  return "";
}

const char* name_of(SMC::Input_defect defect)
{
  switch(defect)
  {
  case SMC::Input_defect::EMPTY_MESH:
    return "empty_mesh";
  case SMC::Input_defect::TOO_LARGE:
    return "too_large";
  case SMC::Input_defect::NOT_TRIANGULAR:
    return "not_triangular";
  case SMC::Input_defect::INVALID_VERTEX_INDEX:
    return "invalid_vertex_index";
  case SMC::Input_defect::NON_FINITE_COORDINATE:
    return "non_finite_coordinate";
  case SMC::Input_defect::ZERO_LENGTH_EDGE:
    return "zero_length_edge";
  case SMC::Input_defect::NON_MANIFOLD_EDGE:
    return "non_manifold_edge";
  case SMC::Input_defect::INCONSISTENT_ORIENTATION:
    return "inconsistent_orientation";
  case SMC::Input_defect::NOT_CLOSED:
    return "not_closed";
  case SMC::Input_defect::NON_MANIFOLD_VERTEX:
    return "non_manifold_vertex";
  case SMC::Input_defect::INVALID_LOOP:
    return "invalid_loop";
  case SMC::Input_defect::IRRATIONAL_COORDINATE:
    return "irrational_coordinate";
  case SMC::Input_defect::INVALID_LOCATION:
    return "invalid_location";
  }
  return "";
}

const char* name_of(SMC::Section_kind kind)
{
  switch(kind)
  {
  case SMC::Section_kind::CLOSED:
    return "closed";
  case SMC::Section_kind::OPEN:
    return "open";
  case SMC::Section_kind::POINT:
    return "point";
  }
  return "";
}

const char* name_of(SMC::Seed_origin origin)
{
  switch(origin)
  {
  case SMC::Seed_origin::NON_FACE_TRIANGLE:
    return "non_face_triangle";
  case SMC::Seed_origin::CUT_LOCUS:
    return "cut_locus";
  case SMC::Seed_origin::SECTION:
    return "section";
  case SMC::Seed_origin::BARRIER:
    return "barrier";
  case SMC::Seed_origin::USER:
    return "user";
  case SMC::Seed_origin::BOUNDARY:
    return "boundary";
  }
  return "";
}

const char* name_of(SMC::Side side)
{
  switch(side)
  {
  case SMC::Side::OBJECT:
    return "object";
  case SMC::Side::COMPLEMENT:
    return "complement";
  case SMC::Side::MIXED:
    return "mixed";
  }
  return "";
}

const char* name_of(SMC::Tightening_verdict verdict)
{
  switch(verdict)
  {
  case SMC::Tightening_verdict::CLOSED_GEODESIC:
    return "constriction";
  case SMC::Tightening_verdict::DEGENERATE:
    return "point";
  case SMC::Tightening_verdict::NOT_SIMPLE:
    return "not_simple";
  case SMC::Tightening_verdict::NOT_CERTIFIED:
    return "not_certified";
  }
  return "";
}

} // namespace constrictions
