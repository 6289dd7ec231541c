// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_main.h"
#include "mesh_reader_target.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::or_abort([&] { fuzz::run_mesh_reader_target(data, size); });
  return 0;
}
