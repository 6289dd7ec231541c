#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# CGAL 5.5.1 (libcgal-dev 5.5.1-2; GMP 6.2.1): Exact_predicates_exact_constructions_kernel, CGAL::to_double(),
# Cartesian_converter.
#
# Guess: a coordinate of the exact kernel is turned into the double that is nearest to it.
# What happens: to_double() returns the middle of the interval that the number carries, if that interval is narrower
# than 1e-5 of it. A number that was computed with cancellation, here (1 + 1e-9 / 3) - 1, so comes out with seven right
# digits. After any comparison that needed the exact value, the same number comes out right to the last digit: what a
# program sees depends on which predicates ran before. A point does not profit from that: it carries intervals of its
# own, and is converted, and written to a stream with 17 digits, with seven right ones as before. Without cancellation
# half of the quotients i / 2003 are not the nearest double, as GMP's mpq_get_d() drops the rest.
#
# Why it matters: whoever copies an exact mesh to doubles to search curves on it, with copy_face_graph() or by hand,
# searches another surface: coplanar faces are no longer coplanar, and two runs of one program differ. CGAL::exact(p)
# before the conversion gives the coordinates to the last digit but one. The certificate of this package takes the exact
# coordinates; the search takes to_double().
. "$(dirname "$0")/lib/packages.sh"
debian libcgal-dev=5.5.1-2 libgmp-dev libmpfr-dev

cat > "$work/to_double.cpp" << 'END'
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Cartesian_converter.h>
#include <cstdio>
#include <sstream>

typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
typedef Exact::FT FT;

std::string text(const Exact::Point_3& p)
{
  std::ostringstream out;
  out.precision(17);
  out << p;
  return out.str();
}

int main()
{
  const FT tiny = FT(1e-9) / FT(3), x = (FT(1) + tiny) - FT(1);
  const Exact::Point_3 p(x, 0, 0);
  const CGAL::Cartesian_converter<Exact, CGAL::Exact_predicates_inexact_constructions_kernel> convert;
  std::printf("number      %.17g\n", CGAL::to_double(x));
  std::printf("point       %.17g, as text %s\n", convert(p).x(), text(p).c_str());
  std::printf("equal to 1e-9 / 3: %s\n", x == tiny ? "yes" : "no");
  std::printf("number then %.17g\n", CGAL::to_double(x));
  std::printf("point then  %.17g, as text %s\n", convert(p).x(), text(p).c_str());
  CGAL::exact(p);
  std::printf("after exact(point) %.17g\n", convert(p).x());
  int other = 0;
  for(int i = 1; i < 2003; ++i)
    other += CGAL::to_double(FT(i) / FT(2003)) != double(i) / 2003;
  std::printf("quotients i / 2003 that are not the nearest double: %d of 2002\n", other);
}
END
compile to_double mpfr gmp
verdict "$("$work/to_double")" "number      3.3333324989115454e-10
point       3.3333324989115454e-10, as text 3.3333324989115454e-10 0 0
equal to 1e-9 / 3: yes
number then 3.3333333333333332e-10
point then  3.3333324989115454e-10, as text 3.3333324989115454e-10 0 0
after exact(point) 3.3333333333333332e-10
quotients i / 2003 that are not the nearest double: 1002 of 2002"
