#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2): reading coordinates as text with Exact_predicates_exact_constructions_kernel and
# with Exact_predicates_exact_constructions_kernel_with_sqrt, whose number type is CORE's.
#
# Guess: both exact kernels read the same text as the same number, and to_double() of a number with few digits is the
# double that these digits mean.
# What happens: "2/4" is 1/2 for the first, and 2 for CORE, which leaves "/4" in the stream and calls that a success.
# "0.1" is exactly 1/10 for both, but to_double() of CORE's is 0.099999999999999992, one double below, while the double
# 0.1 put into CORE comes out as it went in. to_double() of sqrt(2) is the double below the nearest one.
#
# Why it matters: rational coordinates as text are the way to hand an exact mesh from one program to another. Read with
# the kernel with square roots, "1/3 0 0" is not a point with x = 1/3, and what follows is out of step.
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cat > "$work/core.cpp" << 'END'
#define CGAL_USE_CORE 1
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <cstdio>
#include <sstream>

template <class Number>
void read(const char* kernel, const char* text)
{
  std::istringstream in(text);
  Number x;
  in >> x;
  const bool success = static_cast<bool>(in);
  std::string rest;
  in.clear();
  in >> rest;
  std::printf("%s reads %s: %.17g, %s, rest '%s'\n", kernel, text, CGAL::to_double(x), success ? "success" : "failure",
              rest.c_str());
}

int main()
{
  typedef CGAL::Exact_predicates_exact_constructions_kernel::FT Rational;
  typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT Root;
  for(const char* text : {"2/4", "0.1"})
  {
    read<Rational>("rational kernel", text);
    read<Root>("kernel with sqrt", text);
  }
  std::istringstream in("0.1");
  Root tenth;
  in >> tenth;
  std::printf("0.1 as read by the kernel with sqrt is 1 / 10: %s\n", tenth * Root(10) == Root(1) ? "yes" : "no");
  std::printf("the double 0.1 in the kernel with sqrt: %.17g\n", CGAL::to_double(Root(0.1)));
  std::printf("sqrt(2): %.17g\n", CGAL::to_double(CGAL::sqrt(Root(2))));
}
END
compile core mpfr gmp
verdict "$("$work/core")" "rational kernel reads 2/4: 0.5, success, rest ''
kernel with sqrt reads 2/4: 2, success, rest '/4'
rational kernel reads 0.1: 0.10000000000000001, success, rest ''
kernel with sqrt reads 0.1: 0.099999999999999992, success, rest ''
0.1 as read by the kernel with sqrt is 1 / 10: yes
the double 0.1 in the kernel with sqrt: 0.10000000000000001
sqrt(2): 1.4142135623730949"
