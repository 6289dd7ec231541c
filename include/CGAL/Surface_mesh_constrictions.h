// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_H

/// \file
/// Includes the whole public interface of the package, but for `CGAL/draw_constrictions.h`, which needs CGAL's viewer.

#include <CGAL/Surface_mesh_constrictions/Certificate.h>
#include <CGAL/Surface_mesh_constrictions/Closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Collapse_recording_visitor.h>
#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Constriction_query.h>
#include <CGAL/Surface_mesh_constrictions/Detection_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Geodesic_loop.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_input.h>
#include <CGAL/Surface_mesh_constrictions/Invalid_query_file.h>
#include <CGAL/Surface_mesh_constrictions/Label_border.h>
#include <CGAL/Surface_mesh_constrictions/Local_boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/Local_cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/Loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/Non_face_triangle_stop_predicate.h>
#include <CGAL/Surface_mesh_constrictions/Plane_section.h>
#include <CGAL/Surface_mesh_constrictions/Progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Removed_handle.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>
#include <CGAL/Surface_mesh_constrictions/Seed_preserving_placement.h>
#include <CGAL/Surface_mesh_constrictions/Shortest_path_verification.h>
#include <CGAL/Surface_mesh_constrictions/Simplification_mesh.h>
#include <CGAL/Surface_mesh_constrictions/Split_visitor_base.h>
#include <CGAL/Surface_mesh_constrictions/Surface_part.h>
#include <CGAL/Surface_mesh_constrictions/Tightened_curve.h>
#include <CGAL/Surface_mesh_constrictions/Tightening_verdict.h>
#include <CGAL/Surface_mesh_constrictions/bound_prominences.h>
#include <CGAL/Surface_mesh_constrictions/boundary_seeds.h>
#include <CGAL/Surface_mesh_constrictions/carry_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/compute_prominences.h>
#include <CGAL/Surface_mesh_constrictions/cut_handles.h>
#include <CGAL/Surface_mesh_constrictions/cut_locus_seeds.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions_near.h>
#include <CGAL/Surface_mesh_constrictions/extract_parts.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loop_through_locations.h>
#include <CGAL/Surface_mesh_constrictions/geodesic_loops_at_location.h>
#include <CGAL/Surface_mesh_constrictions/make_progressive_mesh.h>
#include <CGAL/Surface_mesh_constrictions/measure_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/merge_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/nested_parts.h>
#include <CGAL/Surface_mesh_constrictions/non_face_triangles.h>
#include <CGAL/Surface_mesh_constrictions/parameters.h>
#include <CGAL/Surface_mesh_constrictions/plane_section_at_location.h>
#include <CGAL/Surface_mesh_constrictions/refine_seed_curves.h>
#include <CGAL/Surface_mesh_constrictions/remove_handles.h>
#include <CGAL/Surface_mesh_constrictions/section_seeds.h>
#include <CGAL/Surface_mesh_constrictions/seed_sources.h>
#include <CGAL/Surface_mesh_constrictions/segment_by_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/select_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/simplification_policies.h>
#include <CGAL/Surface_mesh_constrictions/split_along_constrictions.h>
#include <CGAL/Surface_mesh_constrictions/split_along_label_borders.h>
#include <CGAL/Surface_mesh_constrictions/tighten_closed_curve.h>
#include <CGAL/Surface_mesh_constrictions/tighten_label_borders.h>
#include <CGAL/Surface_mesh_constrictions/triangulate_with_face_map.h>
#include <CGAL/Surface_mesh_constrictions/verify_with_shortest_paths.h>

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_H
