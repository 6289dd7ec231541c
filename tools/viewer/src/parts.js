// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts the surface has when only some of the curves cut, and their colours.

// The surface is cut along all curves; where a curve is hidden the parts on its sides are one. Returns for each part of
// the surface cut along all curves the number of the part that it belongs to.
export function joinedParts(numberOfParts, curves, isShown) {
  const parent = Array.from({length: numberOfParts}, (_, p) => p);
  const root = p => {
    while (parent[p] !== p)
      p = parent[p] = parent[parent[p]];
    return p;
  };
  curves.forEach((c, i) => {
    if (!isShown(i))
      for (const [left, right] of c.parts)
        parent[root(left)] = root(right);
  });
  return parent.map((_, p) => root(p));
}

// Of the given number of colours one for each part, such that neighbours differ where that can be had: the largest
// parts choose first, and of the colours that no neighbour has the one that is used least.
export function colourParts(joined, curves, isShown, sizes, numberOfColours) {
  const neighbours = new Map();
  const neighboursOf = p => neighbours.get(p) ?? neighbours.set(p, new Set()).get(p);
  curves.forEach((c, i) => {
    if (isShown(i))
      for (const [left, right] of c.parts) {
        neighboursOf(joined[left]).add(joined[right]);
        neighboursOf(joined[right]).add(joined[left]);
      }
  });
  const size = new Map();
  joined.forEach((p, i) => size.set(p, (size.get(p) ?? 0) + sizes[i]));
  const colour = new Map(), uses = new Array(numberOfColours).fill(0);
  for (const [p] of [...size].sort((a, b) => b[1] - a[1] || a[0] - b[0])) {
    const taken = new Set([...neighboursOf(p)].map(q => colour.get(q)));
    let best = -1;
    for (let c = 0; c < numberOfColours; ++c)
      if (!taken.has(c) && (best < 0 || uses[c] < uses[best]))
        best = c;
    if (best < 0)
      best = 0;
    ++uses[best];
    colour.set(p, best);
  }
  return joined.map(p => colour.get(p));
}
