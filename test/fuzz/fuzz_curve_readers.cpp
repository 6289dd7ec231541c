// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_main.h"
#include "reader_targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static fuzz::Tally tally;
  fuzz::or_abort([&] { fuzz::run_curve_reader_target(data, size, tally); });
  return 0;
}
