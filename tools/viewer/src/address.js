// SPDX-License-Identifier: GPL-3.0-or-later
// The address of the page can say what it shows, after a #, for example
//   mesh.html#view=1,0,0.5&up=0,0,1&select=3&theme=dark
//
// view, up      the direction that the camera looks from, and what is above
// zoom          2 is twice as near
// select        the number of a constriction in the list, counted from 0
// prominence    the least that is shown
// side          sides, separated by commas: no others are shown
// frame         a step of the playback, counted from 0
// theme         light or dark
// parts, edges  1 or 0
// panel         0: nothing but the surface
// width         of the curves, in pixels

const number = text => Number.isFinite(Number(text)) && text !== '' ? Number(text) : undefined;
const vector = text => {
  const numbers = text.split(',').map(number);
  return numbers.length === 3 && numbers.every(x => x !== undefined) && numbers.some(x => x !== 0) ? numbers : undefined;
};
const flag = text => text === '1' ? true : text === '0' ? false : undefined;
const theme = text => ['light', 'dark'].includes(text) ? text : undefined;

const readers = {view: vector, up: vector, zoom: number, select: number, prominence: number,
  side: text => text.split(','), frame: number, theme, parts: flag, edges: flag, panel: flag, width: number};

// What cannot be read is left out.
export function readAddress(hash) {
  const result = {};
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, '')))
    if (Object.hasOwn(readers, name))
      result[name] = readers[name](text);
  return result;
}
