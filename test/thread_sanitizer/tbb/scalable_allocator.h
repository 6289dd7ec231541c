// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef THREAD_SANITIZER_TBB_SCALABLE_ALLOCATOR_H
#define THREAD_SANITIZER_TBB_SCALABLE_ALLOCATOR_H

#include <memory>

namespace tbb {

template <class T>
using scalable_allocator = std::allocator<T>;

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_SCALABLE_ALLOCATOR_H
