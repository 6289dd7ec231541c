// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_COMPUTATIONS_H
#define CONSTRICTIONS_COMPUTATIONS_H

#include "compute/levels.h"
#include "compute/stage_monitor.h"
#include "input/curves_file.h"
#include "input/labels_file.h"
#include "input/landmarks_file.h"
#include "input/loops_file.h"
#include "options.h"
#include "output/certificates.h"
#include "output/check_report.h"
#include "output/handles.h"
#include "output/parts.h"
#include "output/report.h"
#include "view/playback.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace constrictions {

/// \name Detection
/// One function for each policy of the simplification, each in a file of its own: they take long to compile. If
/// `levels` is not null it gets the levels of the simplification, unless the search is near a location.
/// @{
std::vector<Constriction> detect_with_garland_heckbert(const Mesh& mesh, const Selection& selection,
                                                       const Search& search, Stage_monitor& monitor, Levels* levels);
std::vector<Constriction> detect_with_lindstrom_turk(const Mesh& mesh, const Selection& selection, const Search& search,
                                                     Stage_monitor& monitor, Levels* levels);
std::vector<Constriction> detect_with_edge_length(const Mesh& mesh, const Selection& selection, const Search& search,
                                                  Stage_monitor& monitor, Levels* levels);
/// @}

/// measures the caps and sides of the constrictions of the report.
void measure_curves(Report& report);

/// tightens the loops; fills the constrictions, the statistics and the remarks of the report.
void tighten_loops(const Loops& loops, bool certifies, Stage_monitor& monitor, Report& report);

/// tightens the borders between labels, of which there is one for each face of the file; fills the labelling, the
/// constrictions and the statistics of the report.
void tighten_labels(const std::vector<Label>& labels, bool certifies, Stage_monitor& monitor, Report& report);

/// tightens loops through places of the user; fills the loops, the constrictions, the statistics and the remarks of the
/// report. Throws `Input_file_error`, with the line of the file, for places that cannot be used.
void tighten_through_places(const std::string& file, const Place_loops& loops, bool certifies, Stage_monitor& monitor,
                            Report& report);

/// \name A Prepared Mesh
/// `prepared` is the name of a file that has what `prepare_mesh()` gives, or empty: then the mesh is prepared first. All
/// throw `Input_file_error` for a file that does not fit the mesh.
/// @{

/// prepares a mesh. Returns the bytes of the file.
std::string prepare_mesh(const Mesh& mesh, Stage_monitor& monitor);

/// finds the constrictions of the whole mesh, or those near the location that the user gave, as `detect_with_...()`;
/// fills the curves and the statistics of the report. There has to be a file.
void detect_prepared(const std::string& prepared, const Selection& selection, const Search& search,
                     Stage_monitor& monitor, Report& report);

/// finds the constrictions near each landmark; fills the answers, the curves and the statistics of the report.
void detect_near_landmarks(const std::string& prepared, const std::vector<Landmark>& landmarks,
                           const Selection& selection, bool certifies, Stage_monitor& monitor, Report& report);

/// finds the shortest loops at a place; fills the loops, the curves and the statistics of the report.
void find_girth(const std::string& prepared, const Girth& girth, bool certifies, Stage_monitor& monitor,
                Report& report);

/// finds the shortest loops at each landmark; the answers, too.
void find_girths(const std::string& prepared, const std::vector<Landmark>& landmarks, const Girth& girth,
                 bool certifies, Stage_monitor& monitor, Report& report);
/// @}

/// why no constriction is near a place
std::string near_hint(std::size_t not_selected);

/// the certificate of each of the curves
std::vector<Certified_curve> certify_curves(const Mesh& mesh, const Curves& curves, Stage_monitor& monitor);

/// cuts the mesh along those of the constrictions that are chosen; everything but the time.
Parts segment_mesh(const Mesh& mesh, const std::vector<Constriction>& constrictions, const Segmentation& segmentation);

/// cuts handles of what is left along those of its constrictions that fit, the shortest first, down to the genus asked
/// for, and closes both ends. Returns whether there was any. The constrictions no longer fit the mesh then.
bool cut_along_handles(const std::vector<Constriction>& constrictions, const Segmentation& segmentation,
                       std::optional<double> maximum_length, std::size_t round, Handle_removal& removal);

/// cuts the mesh along the borders between labels; everything but the time.
Parts cut_along_borders(const Mesh& mesh, const Labelling& labelling);

/// everything that is wrong with a mesh file. Throws `Input_file_error` for a file that cannot be read.
Check_report check_mesh(const std::string& name, const Reading& reading);

/// carries seeds of the constrictions through the levels. `levels` are those that the constrictions were detected with.
Playback record_playback(const Mesh& mesh, const std::vector<Constriction>& constrictions,
                         CGAL::Surface_mesh_constrictions::Progressive_mesh levels);

} // namespace constrictions

#endif // CONSTRICTIONS_COMPUTATIONS_H
