#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Shapely 1.8.5 (python3-shapely 1.8.5-2+b1) with GEOS: closed lines with three coordinates.
#
# Guess: heights are carried along, as Shapely says of itself, and lengths are those in the plane. What cuts or joins
# lines keeps the heights of their points, and does not join ends that are apart.
# What happens: linemerge() joins a line that ends at height 0 to one that begins at height 5, and the point at height 5
# is gone: the length in space changes. substring() drops heights. A LinearRing whose last point is above the first
# counts as closed and is not closed in space. Where two lines cross at different heights the intersection has the mean.
# A circle that stands upright has the length 4 for 6.27, is not simple and no ring; interpolate() by a quarter of the
# length is a quarter of the way in the plane. Two points one above the other are a line that is not valid.
#
# Why it matters: constrictions are closed lines in space, and those around a lying tube stand upright. The length is
# the least of it: pieces of a line that are joined again lose points without a word.
. "$(dirname "$0")/lib/packages.sh"
debian python3-shapely=1.8.5-2+b1
for folder in blas lapack; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$triplet/$folder"
done

cat > "$work/lines.py" << 'END'
import math
from shapely.geometry import LinearRing, LineString
from shapely.ops import linemerge, substring


def length(line):
    return sum(math.dist(p, q) for p, q in zip(line.coords, line.coords[1:]))


first, second = LineString([(0, 0, 0), (1, 0, 0)]), LineString([(1, 0, 5), (2, 0, 5)])
merged = linemerge([first, second])
print("linemerge: %s, lengths in space %g and %g become %.3f" % (
    list(merged.coords), length(first), length(second), length(merged)))
print("substring:", list(substring(LineString([(0, 0, 7), (2, 0, 7)]), 0, 1).coords))
ring = LinearRing([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 3)])
print("ring: closed %s, from %s to %s" % (ring.is_closed, ring.coords[0], ring.coords[-1]))
print("intersection:", list(LineString([(0, 0, 0), (2, 0, 2)]).intersection(
    LineString([(1, -1, 5), (1, 1, 5)])).coords))
points = [(0.0, math.cos(math.pi * i / 12), math.sin(math.pi * i / 12)) for i in range(24)]
circle = LineString(points + points[:1])
print("upright circle: length %.3f, in space %.3f, simple %s, ring %s" % (
    circle.length, length(circle), circle.is_simple, circle.is_ring))
print("a quarter of it: (%g, %.3f, %.3f)" % tuple(circle.interpolate(0.25, normalized=True).coords[0]))
print("upright segment: valid", LineString([(0, 0, 0), (0, 0, 1)]).is_valid)
END
verdict "$(python3 "$work/lines.py")" \
"linemerge: [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 5.0)], lengths in space 1 and 1 become 6.099
substring: [(0.0, 0.0), (1.0, 0.0)]
ring: closed True, from (0.0, 0.0, 0.0) to (0.0, 0.0, 3.0)
intersection: [(1.0, 0.0, 3.0)]
upright circle: length 4.000, in space 6.265, simple False, ring False
a quarter of it: (0, 0.000, 1.000)
upright segment: valid False"
