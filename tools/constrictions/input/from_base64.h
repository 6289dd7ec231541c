// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_FROM_BASE64_H
#define CONSTRICTIONS_FROM_BASE64_H

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace constrictions {

/// the bytes that a text in base64 stands for: as many as there are, but no more than `most`. Blanks and line ends are
/// skipped. The text may be several texts in base64, each with its padding, one behind the other. Nothing if it is not
/// in base64.
std::optional<std::string> from_base64(std::string_view text, std::size_t most);

} // namespace constrictions

#endif // CONSTRICTIONS_FROM_BASE64_H
