// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_CERTIFICATES_H
#define CONSTRICTIONS_CERTIFICATES_H

#include "input/mesh_file.h"

#include <CGAL/Surface_mesh_constrictions/Certificate.h>

#include <cstdint>
#include <string>
#include <vector>

namespace constrictions {

typedef CGAL::Surface_mesh_constrictions::Certificate Certificate;

/// What has been proved of a curve of a file.
struct Certified_curve
{
  std::uint64_t id;
  double length; ///< of the polygon through the points as they are given
  Certificate certificate;
};

/// the certificate in one line
std::string certificate_as_text(const Certificate& certificate);

/// a line for each curve: its id, a blank, and its certificate
std::string certificates_as_lines(const std::vector<Certified_curve>& curves);

/// the certificates in the format "constrictions-certificates/1", in one line
std::string certificates_as_json(const std::string& mesh_file, const File_numbering& numbering,
                                 const std::vector<Certified_curve>& curves);

} // namespace constrictions

#endif // CONSTRICTIONS_CERTIFICATES_H
