// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef PEAK_MEMORY_H
#define PEAK_MEMORY_H

#include <cstddef>

/// What the memory of the process, as far as it is resident, rises to from the construction of this object on. Only
/// Linux tells; elsewhere the numbers are 0.
class Peak_memory
{
public:
  /// gives what has been freed back to the system, lest it hide what is allocated in its place, and has the system
  /// forget the peak so far. Where that is not allowed, as in some containers, the peak is that of the whole run.
  Peak_memory();

  /// the peak, in bytes
  std::size_t peak() const;

  /// the bytes by which the peak is above the memory at the construction
  std::size_t rise() const;

private:
  std::size_t m_begin;
};

#endif // PEAK_MEMORY_H
