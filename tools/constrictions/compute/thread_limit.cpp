// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>

#include <deque>
#endif

namespace constrictions {

#ifdef CGAL_LINKED_WITH_TBB

void limit_threads(std::optional<std::size_t> threads)
{
  // never destroyed: oneTBB allocates memory for that, and ends the process where there is none
  static std::deque<tbb::global_control>& limits = *new std::deque<tbb::global_control>();
  if(threads)
    limits.emplace_back(tbb::global_control::max_allowed_parallelism, *threads);
}

#else

void limit_threads(std::optional<std::size_t>) {}

#endif

} // namespace constrictions
