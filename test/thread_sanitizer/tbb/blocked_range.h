// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef THREAD_SANITIZER_TBB_BLOCKED_RANGE_H
#define THREAD_SANITIZER_TBB_BLOCKED_RANGE_H

// ThreadSanitizer does not see how oneTBB, which is not compiled with it, hands work from thread to thread, and would
// call that a race. The headers of this folder stand in for the few parts of oneTBB that CGAL::for_each() and the tests
// use, with std::thread.

namespace tbb {

template <class Value>
class blocked_range
{
public:
  blocked_range(Value begin, Value end) : m_begin(begin), m_end(end) {}

  Value begin() const { return m_begin; }
  Value end() const { return m_end; }

private:
  Value m_begin, m_end;
};

} // namespace tbb

#endif // THREAD_SANITIZER_TBB_BLOCKED_RANGE_H
