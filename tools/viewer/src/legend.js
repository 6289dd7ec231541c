// SPDX-License-Identifier: GPL-3.0-or-later
// What the colours mean.
import {css, scheme, seed, selection, sides} from './colours.js';

const chip = (colour, className) => {
  const result = document.createElement('span');
  result.className = `chip ${className}`;
  result.style.setProperty('--chip', colour);
  return result;
};

export function showLegend(into, theme) {
  into.replaceChildren();
  const entry = (chips, text) => {
    const dt = document.createElement('dt'), dd = document.createElement('dd');
    dt.append(...chips);
    dd.textContent = text;
    into.append(dt, dd);
  };
  for (const {colour, text} of Object.values(sides))
    entry([chip(colour, '')], text);
  entry([chip(selection, 'full')], 'around a curve: selected; its pivots are dots');
  entry([chip(seed, 'full')], 'around a curve or across it, in the playback: a seed that has just appeared');
  entry(scheme(theme).parts.slice(0, 3).map(c => chip(css(c), 'full')),
    'parts between the curves that are shown; the colours tell neighbours apart');
}
