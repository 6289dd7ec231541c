// SPDX-License-Identifier: GPL-3.0-or-later

// In place of read_xml.cpp where expat is missing.
#include "input/read_xml.h"

namespace constrictions {

void read_xml(const Input_file& file, std::string_view, const std::string&, bool, Xml_handler&)
{
  file.fail("this program was built without expat, which reads VTP and 3MF files");
}

} // namespace constrictions
