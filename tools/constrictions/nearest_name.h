// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_NEAREST_NAME_H
#define CONSTRICTIONS_NEAREST_NAME_H

#include <string>
#include <vector>

namespace constrictions {

/// the one of the names that was probably meant: that which takes the fewest letters to be put in, left out, replaced,
/// or exchanged with the next one, but no more than a third of those given; or else the only one that begins with what
/// is given, of three letters or more. Empty if there is none. Dashes in front do not count.
std::string nearest_name(const std::string& given, const std::vector<std::string>& names);

} // namespace constrictions

#endif // CONSTRICTIONS_NEAREST_NAME_H
