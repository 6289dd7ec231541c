#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# geometry 0.4.7 for R (r-cran-geometry 0.4.7-1), surf.tri() of tetrahedra.
#
# Guess: the triangles of the surface are all there, and are oriented alike, as there is code for it: each is compared
# with the fourth vertex of its tetrahedron.
# What happens: the triangles are there, but each is compared with a vertex of some other tetrahedron. For one
# tetrahedron the result is right, and for the hull of a cloud of points most of it, as any point is on the same side of
# a triangle if it is not one of its corners. Of a cube of five or six tetrahedra, and of a ring of 72, the triangles
# are oriented by chance: a third to a half of the edges are run through twice in one direction, and the volume by the
# surface is 0.33 for 1, and 26 for 15.
#
# Why it matters: the triangles go to a file and look right. A halfedge structure cannot be built of them, volumes and
# normals mean nothing, and a program that tears faces apart until they fit leaves loose pieces.
. "$(dirname "$0")/lib/packages.sh"
debian r-cran-geometry=0.4.7-1
for folder in R/lib "$triplet/blas" "$triplet/lapack"; do
  LD_LIBRARY_PATH+=":$work/root/usr/lib/$folder"
done
export R_HOME="$work/root/usr/lib/R" R_LIBS="$work/root/usr/lib/R/site-library" EDITOR=vi PAGER=cat

cd "$work"
cat > surfaces.R << 'END'
library(geometry)

# Six times the volumes of tetrahedra with the tips o.
sixfold <- function(o, a, b, c) {
  rowSums((a - o) * extprod3d(b - o, c - o))
}

report <- function(name, points, tetrahedra) {
  f <- surf.tri(points, tetrahedra)
  ends <- rbind(f[, 1:2], f[, 2:3], f[, c(3, 1)])
  directed <- paste(ends[, 1], ends[, 2])
  edges <- table(paste(pmin(ends[, 1], ends[, 2]), pmax(ends[, 1], ends[, 2])))
  corner <- function(table, k) points[table[, k], , drop = FALSE]
  inside <- sum(abs(sixfold(corner(tetrahedra, 1), corner(tetrahedra, 2), corner(tetrahedra, 3),
                            corner(tetrahedra, 4))))
  surface <- sum(sixfold(0 * corner(f, 1), corner(f, 1), corner(f, 2), corner(f, 3)))
  cat(sprintf("%s: tetrahedra %d, triangles %d,", name, nrow(tetrahedra), nrow(f)),
      sprintf("edges with two %d of %d,", sum(edges == 2), length(edges)),
      sprintf("run through twice in one direction %d,", sum(duplicated(directed))),
      sprintf("volume %.2f, by the surface %.2f\n", inside / 6, surface / 6))
}

cube <- as.matrix(expand.grid(0:1, 0:1, 0:1))
report("one", cube, rbind(c(1, 2, 3, 5)))
report("cube of five", cube, rbind(c(1, 2, 3, 5), c(2, 4, 3, 8), c(2, 3, 5, 8), c(3, 5, 7, 8), c(2, 5, 6, 8)))
six <- rbind(c(1, 2, 4, 8), c(1, 3, 4, 8), c(1, 2, 6, 8), c(1, 5, 6, 8), c(1, 3, 7, 8), c(1, 5, 7, 8))
report("cube of six", cube, six)
i <- 1:60
cloud <- cbind(7 * i %% 61, i^2 %% 59, i^3 %% 53)
report("cloud", cloud, delaunayn(cloud))

# A ring of 12 blocks of six tetrahedra each, that share sides.
n <- 12
angles <- 2 * pi * (0:(n - 1)) / n
ring <- do.call(rbind, lapply(angles, function(a) {
  t(sapply(1:4, function(k) c((2 + (k - 1) %% 2) * c(cos(a), sin(a)), (k - 1) %/% 2)))
}))
blocks <- do.call(rbind, lapply(0:(n - 1), function(i) {
  corners <- c(4 * i + 1:4, 4 * ((i + 1) %% n) + 1:4)
  matrix(corners[six], ncol = 4)
}))
report("ring", ring, blocks)
END
verdict "$("$R_HOME/bin/exec/R" --vanilla --slave -f surfaces.R 2> R.log | grep ": tetrahedra")" \
"one: tetrahedra 1, triangles 4, edges with two 6 of 6, run through twice in one direction 0, volume 0.17, by the surface 0.17
cube of five: tetrahedra 5, triangles 12, edges with two 18 of 18, run through twice in one direction 9, volume 1.00, by the surface 0.33
cube of six: tetrahedra 6, triangles 12, edges with two 18 of 18, run through twice in one direction 6, volume 1.00, by the surface 0.67
cloud: tetrahedra 277, triangles 44, edges with two 66 of 66, run through twice in one direction 0, volume 740120.50, by the surface 740120.50
ring: tetrahedra 72, triangles 96, edges with two 144 of 144, run through twice in one direction 52, volume 15.00, by the surface 26.33"
