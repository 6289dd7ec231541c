#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# NetworkX 2.8.8 (python3-networkx 2.8.8-1): minimum_cycle_basis() and cycle_basis().
#
# Guess: each cycle of a minimum cycle basis is the list of its vertices in the order in which one comes through them,
# as the cycles of cycle_basis() are.
# What happens: the vertices are in the order of a Python set. A triangle is a cycle in any order, and a row of
# neighbouring numbers comes out sorted, so that of the 169 cycles of a torus 168 are in order: 167 triangles and the
# loop around the tube. The other loop, the shorter way of 12 edges around the hole, jumps to and fro: its length is
# 6.83, that of the polyline through its vertices as they are listed 23.33. cycle_basis() gives all cycles in order;
# they are not the short ones.
#
# Why it matters: the cycles of a minimum basis that bound nothing are the short loops around handles and tunnels, the
# usual ones to start a search for geodesics from. "constrictions tighten --loops" needs them in order.
. "$(dirname "$0")/lib/packages.sh"
debian python3-networkx=2.8.8-1

cd "$work"
cat > cycles.py << 'END'
import math
import meshes
import networkx

print("version:", networkx.__version__)
points, faces = meshes.torus(12, 7)
graph = networkx.Graph()
for f in faces:
    for a, b in zip(f, f[1:] + f[:1]):
        graph.add_edge(a, b, weight=math.dist(points[a], points[b]))
for name, basis in (("minimum_cycle_basis()", networkx.minimum_cycle_basis(graph, weight="weight")),
                    ("cycle_basis()", networkx.cycle_basis(graph))):
    in_order = [c for c in basis if all(graph.has_edge(a, b) for a, b in zip(c, c[1:] + c[:1]))]
    print("%s: cycles %d, in order %d, of these triangles %d" % (
        name, len(basis), len(in_order), sum(len(c) == 3 for c in in_order)))
    if name.startswith("minimum"):
        for cycle in sorted(basis, key=len)[-2:]:
            edges = graph.subgraph(cycle).size("weight")
            print("  %d vertices: length of the cycle %.2f, of the polyline in the order given %.2f" % (
                len(cycle), edges, sum(math.dist(points[a], points[b]) for a, b in zip(cycle, cycle[1:] + cycle[:1]))))
END
verdict "$(/usr/bin/python3 cycles.py)" \
"version: 2.8.8
minimum_cycle_basis(): cycles 169, in order 168, of these triangles 167
  7 vertices: length of the cycle 6.07, of the polyline in the order given 6.07
  12 vertices: length of the cycle 6.83, of the polyline in the order given 23.33
cycle_basis(): cycles 169, in order 169, of these triangles 119"
