// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch/batch_progress.h"

#include "output/clock_time.h"

#include <iostream>

namespace constrictions {

Batch_progress::Batch_progress(bool is_shown, std::size_t meshes, std::uint64_t bytes)
  : m_is_shown(is_shown), m_meshes(meshes), m_bytes(bytes), m_begin(std::chrono::steady_clock::now())
{}

Batch_progress::~Batch_progress()
{
  if(m_is_shown)
    std::cerr << std::endl;
}

void Batch_progress::add(std::uint64_t bytes, bool has_failed)
{
  ++m_done;
  m_failed += has_failed;
  m_bytes_done += bytes;
}

void Batch_progress::show()
{
  if(!m_is_shown)
    return;
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_begin).count();
  std::cerr << '\r' << m_done << " of " << m_meshes << " meshes, " << m_failed << " failed, " << clock_time(elapsed);
  if(m_done > 0 && m_done < m_meshes)
    std::cerr << ", about " << clock_time(elapsed * double(m_bytes - m_bytes_done) / double(m_bytes_done)) << " left";
  // what is left of a longer line is erased
  std::cerr << "\x1b[K" << std::flush;
}

} // namespace constrictions
