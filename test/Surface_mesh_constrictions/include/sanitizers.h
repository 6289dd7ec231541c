// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef SANITIZERS_H
#define SANITIZERS_H

namespace sanitizers {

// Whether the tests run with AddressSanitizer, with which they take ten times as long.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool are_on = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool are_on = true;
#else
constexpr bool are_on = false;
#endif
#else
constexpr bool are_on = false;
#endif

} // namespace sanitizers

#endif // SANITIZERS_H
