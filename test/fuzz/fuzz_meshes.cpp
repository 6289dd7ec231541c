// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_main.h"
#include "mesh_target.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

fuzz::Tally tally;

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const bool tells = (std::atexit([] {
                               std::fprintf(stderr,
                                            "%zu meshes, of %zu selections compared; curves: %zu certified, %zu "
                                            "refused, %zu open; %zu witnessed\n",
                                            tally.meshes, tally.compared_selections, tally.certified, tally.refused,
                                            tally.open, tally.witnessed);
                             }),
                             true);
  (void)tells;
  fuzz::or_abort([&] { fuzz::run_mesh_target(data, size, tally); });
  return 0;
}
