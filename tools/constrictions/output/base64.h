// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_BASE64_H
#define CONSTRICTIONS_BASE64_H

#include <string>

namespace constrictions {

/// the base64 encoding of RFC 4648
std::string as_base64(const std::string& bytes);

} // namespace constrictions

#endif // CONSTRICTIONS_BASE64_H
