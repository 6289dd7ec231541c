// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_MESH_JSON_H
#define CONSTRICTIONS_MESH_JSON_H

#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Constriction.h>
#include <CGAL/Surface_mesh_constrictions/Seed_curve.h>

#include <nlohmann/json.hpp>

#include <string>

namespace constrictions {

/// the member "mesh" of the program's JSON objects. Vertices and faces are counted as in the file. The unit of lengths
/// is told if the format has one.
nlohmann::ordered_json mesh_as_json(const std::string& file, const Mesh& mesh, const File_record& record);

/// the repairs, by name: the number of what was mended
nlohmann::ordered_json repairs_as_json(const Mesh_findings& findings);

/// the name of a side, in JSON and in tables
const char* side_name(CGAL::Surface_mesh_constrictions::Side side);

/// the name of a kind of seed, in JSON and in tables
const char* origin_name(CGAL::Surface_mesh_constrictions::Seed_origin origin);

} // namespace constrictions

#endif // CONSTRICTIONS_MESH_JSON_H
