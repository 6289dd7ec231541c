// SPDX-License-Identifier: GPL-3.0-or-later
#include "peak_memory.h"

#include <cstdlib>
#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// A number of /proc/self/status in bytes, which stands there in KiB; 0 if it is not there.
std::size_t status(const std::string& name)
{
  std::ifstream in("/proc/self/status");
  for(std::string line; std::getline(in, line);)
    if(line.compare(0, name.size() + 1, name + ':') == 0)
      return 1024 * static_cast<std::size_t>(std::strtoull(line.c_str() + name.size() + 1, nullptr, 10));
  return 0;
}

} // namespace

Peak_memory::Peak_memory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream("/proc/self/clear_refs") << 5;
  m_begin = status("VmRSS");
}

std::size_t Peak_memory::peak() const { return status("VmHWM"); }

std::size_t Peak_memory::rise() const
{
  const std::size_t p = peak();
  return p > m_begin ? p - m_begin : 0;
}
