// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FUZZ_FAILURE_H
#define FUZZ_FAILURE_H

#include <stdexcept>
#include <string>

namespace fuzz {

// What must not be. A test fails with it, libFuzzer keeps the input.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void fail(const std::string& what) { throw Failure(what); }

} // namespace fuzz

#endif // FUZZ_FAILURE_H
