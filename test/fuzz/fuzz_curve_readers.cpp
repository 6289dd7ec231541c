// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_reader_target.h"
#include "fuzz_main.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static fuzz::Tally tally;
  static fuzz::Curve_reader_target target(tally);
  fuzz::or_abort([&] { target.run(data, size); });
  return 0;
}
