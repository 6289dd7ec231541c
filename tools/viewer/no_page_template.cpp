// SPDX-License-Identifier: GPL-3.0-or-later
#include "page_template.h"

namespace constrictions {

const std::string& page_template()
{
  static const std::string none;
  return none;
}

} // namespace constrictions
