// SPDX-License-Identifier: GPL-3.0-or-later
// The address of the page can say what it shows, after a #, for example
//   mesh.html#view=1,0,0.5&up=0,0,1&select=3&theme=dark
//
// view, up      the direction that the camera looks from, and what is above
// zoom          2 is twice as near
// target        the place that the camera looks at, in the coordinates of the file; else the centre
// select        the number of a constriction in the list, counted from 0; without a target the camera flies there
// prominence    the least that is shown
// first         so many constrictions are shown at most, the most prominent
// side          sides, separated by commas: no others are shown
// list          curves or parts
// part          the number of a part: it is shown alone
// apart         how far apart the parts are drawn, from 0 to 1
// section       the axis that the section is across, its place in the coordinates of the file, and which side of that
//               stays, as in y,0.5,lower or y,0.5,upper
// frame         a step of the playback, counted from 0
// theme         light or dark
// parts, edges  1 or 0
// panel         0: nothing but the surface
// width         of the curves, in pixels

const number = text => Number.isFinite(Number(text)) && text !== '' ? Number(text) : undefined;
const flag = text => text === '1' ? true : text === '0' ? false : undefined;
const oneOf = (...words) => text => words.includes(text) ? text : undefined;
const place = text => {
  const numbers = text.split(',').map(number);
  return numbers.length === 3 && numbers.every(x => x !== undefined) ? numbers : undefined;
};
const vector = text => place(text)?.some(x => x !== 0) ? place(text) : undefined;
const section = text => {
  const [axis, at, side] = text.split(',');
  return ['x', 'y', 'z'].includes(axis) && number(at ?? '') !== undefined && ['lower', 'upper'].includes(side)
    ? {axis: ['x', 'y', 'z'].indexOf(axis), at: number(at), keepsLower: side === 'lower'} : undefined;
};

const readers = {view: vector, up: vector, zoom: number, target: place, select: number, prominence: number, first: number,
  side: text => text.split(','), list: oneOf('curves', 'parts'), part: number, apart: number, section, frame: number,
  theme: oneOf('light', 'dark'), parts: flag, edges: flag, panel: flag, width: number};

// What cannot be read is left out.
export function readAddress(hash) {
  const result = {};
  for (const [name, text] of new URLSearchParams(hash.replace(/^#/, '')))
    if (Object.hasOwn(readers, name))
      result[name] = readers[name](text);
  return result;
}

// The address, from the # on, of what it says; what is undefined is left out. Numbers have five digits, but those for
// which another view would show something else have all.
export function writeAddress(asked) {
  const short = x => String(Number(x.toPrecision(5)));
  const writers = {view: v => v.map(short).join(','), up: v => v.map(short).join(','), target: v => v.map(short).join(','),
    zoom: short, section: ({axis, at, keepsLower}) => ['xyz'[axis], short(at), keepsLower ? 'lower' : 'upper'].join(',')};
  const parts = Object.entries(asked).filter(([, value]) => value !== undefined)
    .map(([name, value]) => `${name}=${encodeURIComponent(writers[name] ? writers[name](value) : String(value))}`);
  return `#${parts.join('&').replaceAll('%2C', ',')}`;
}
