// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_FLOATING_POINT_REQUIREMENTS_H
#define CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_FLOATING_POINT_REQUIREMENTS_H

// Interval arithmetic is only right if each operation is done as written, in the rounding mode that is set; NaN and
// infinite coordinates are found by comparisons that -ffinite-math-only removes.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) ||                         \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "Surface_mesh_constrictions cannot be compiled with -ffast-math, -Ofast or a part of them: \
its proofs use interval arithmetic, which needs IEEE 754 rounding"
#endif

#endif // CGAL_SURFACE_MESH_CONSTRICTIONS_INTERNAL_SURFACE_FLOATING_POINT_REQUIREMENTS_H
