// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/certificates.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace constrictions {

std::string certificate_as_text(const Certificate& certificate)
{
  std::ostringstream out;
  out << certificate;
  return out.str();
}

std::string certificates_as_lines(const std::vector<Certified_curve>& curves)
{
  std::ostringstream out;
  for(const Certified_curve& c : curves)
    out << c.id << ' ' << c.certificate << '\n';
  return out.str();
}

std::string certificates_as_json(const std::string& mesh_file, const File_numbering& numbering,
                                 const std::vector<Certified_curve>& curves)
{
  typedef nlohmann::ordered_json Json;
  Json certificates = Json::array();
  for(const Certified_curve& c : curves)
    certificates.push_back({{"id", c.id}, {"verdict", certificate_as_text(c.certificate)}, {"length", c.length}});
  const Json json = {{"format", "constrictions-certificates/1"},
                     {"mesh", {{"file", mesh_file}, {"vertices", numbering.vertices}, {"faces", numbering.faces}}},
                     {"certificates", certificates}};
  // a file name need not be UTF-8, JSON must be
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace constrictions
