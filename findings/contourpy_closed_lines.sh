#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# ContourPy 1.0.7 (python3-contourpy 1.0.7-1+b1): lines of the four algorithms around a closed shape.
#
# Guess: a closed line ends with the point it begins with, by each algorithm, and has each of its corners once.
# What happens: with "mpl2014" the line around a disk ends beside its beginning, in the last digits, so that it is an
# open line with a gap; with the values negated, or by the three others, it is closed. Where samples are equal to the
# level, points come up to three times in a row: the diamond with four corners has thirteen points, and eight of its
# steps have length 0. All four do that.
#
# Why it matters: sections of an image are closed lines to compare constrictions with. One that is not closed counts as
# a path between borders, and steps without a length have no direction, which is what turning angles are taken from.
. "$(dirname "$0")/lib/packages.sh"
debian python3-contourpy=1.0.7-1+b1 python3-numpy
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done

cat > "$work/lines.py" << 'END'
import numpy
from contourpy import contour_generator

fine, coarse = numpy.linspace(-1.6, 1.6, 41), numpy.arange(-2.0, 3.0)
x, y = numpy.meshgrid(fine, fine)
u, v = numpy.meshgrid(coarse, coarse)
for name, grid, level in (("disk", (x, y, x ** 2 + y ** 2), 1), ("disk, values negated", (x, y, -x ** 2 - y ** 2), -1),
                          ("diamond", (u, v, abs(u) + abs(v)), 1)):
    for algorithm in ("serial", "threaded", "mpl2005", "mpl2014"):
        lines = contour_generator(*grid, name=algorithm).lines(level)
        for line in lines[0] if isinstance(lines, tuple) else lines:
            steps = numpy.hypot(*numpy.diff(line, axis=0).T)
            print("%s, %s: points %d, steps of length 0 %d, closed %s, ends apart less than 1e-12 %s" % (
                name, algorithm, len(line), sum(steps == 0), (line[0] == line[-1]).all(),
                numpy.hypot(*(line[0] - line[-1])) < 1e-12))
END
verdict "$(python3 "$work/lines.py")" \
"disk, serial: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, threaded: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, mpl2005: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, mpl2014: points 101, steps of length 0 0, closed False, ends apart less than 1e-12 True
disk, values negated, serial: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, values negated, threaded: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, values negated, mpl2005: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
disk, values negated, mpl2014: points 101, steps of length 0 0, closed True, ends apart less than 1e-12 True
diamond, serial: points 13, steps of length 0 8, closed True, ends apart less than 1e-12 True
diamond, threaded: points 13, steps of length 0 8, closed True, ends apart less than 1e-12 True
diamond, mpl2005: points 13, steps of length 0 8, closed True, ends apart less than 1e-12 True
diamond, mpl2014: points 13, steps of length 0 8, closed True, ends apart less than 1e-12 True"
