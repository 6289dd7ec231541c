// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute/thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace constrictions {

#ifdef CGAL_LINKED_WITH_TBB

struct Thread_limit::Control
{
  explicit Control(std::size_t threads) : tbb_control(tbb::global_control::max_allowed_parallelism, threads) {}

  tbb::global_control tbb_control;
};

Thread_limit::Thread_limit(std::optional<std::size_t> threads)
{
  if(threads)
    m_control = std::make_unique<Control>(*threads);
}

#else

struct Thread_limit::Control
{};

Thread_limit::Thread_limit(std::optional<std::size_t>) {}

#endif

Thread_limit::~Thread_limit() = default;

} // namespace constrictions
