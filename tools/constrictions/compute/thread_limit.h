// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CONSTRICTIONS_THREAD_LIMIT_H
#define CONSTRICTIONS_THREAD_LIMIT_H

#include <cstddef>
#include <optional>

namespace constrictions {

/// From now on, until the process ends, no more threads compute than the given number, and than earlier calls have said.
/// Without a number, or where the program has been built without oneTBB and computes with one thread anyway, it does
/// nothing.
void limit_threads(std::optional<std::size_t> threads);

} // namespace constrictions

#endif // CONSTRICTIONS_THREAD_LIMIT_H
