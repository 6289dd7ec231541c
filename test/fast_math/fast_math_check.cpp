// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Surface_mesh_constrictions/certify_constriction.h>
#include <CGAL/Surface_mesh_constrictions/detect_constrictions.h>
