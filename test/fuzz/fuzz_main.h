// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_FUZZ_MAIN_H
#define FUZZ_FUZZ_MAIN_H

// The entry point of a program for libFuzzer.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

// libFuzzer keeps the input of a program that aborts.
template <class Function>
void or_abort(const Function& function)
{
  try
  {
    function();
  }
  catch(const std::exception& e)
  {
    std::fprintf(stderr, "FAILURE: %s\n", e.what());
    std::abort();
  }
}

} // namespace fuzz

#endif // FUZZ_FUZZ_MAIN_H
