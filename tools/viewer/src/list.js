// SPDX-License-Identifier: GPL-3.0-or-later
// The panel: what the mesh is, the threshold, and the list of constrictions. Text is set as text, never as HTML.
import {sides} from './colours.js';

const integer = new Intl.NumberFormat('en');
export const counted = (n, one, many = one + 's') => `${integer.format(n)} ${n === 1 ? one : many}`;
export const rounded = x => x === Infinity ? '∞' : Number(x.toPrecision(3)).toString();

const element = (name, className, text) => {
  const result = document.createElement(name);
  if (className)
    result.className = className;
  if (text !== undefined)
    result.textContent = text;
  return result;
};

const certificates = {strict_constriction: 'strict constriction', constriction: 'constriction'};

function row(curve, c, greatest) {
  const button = element('button');
  button.type = 'button';
  button.dataset.curve = c;
  const chip = element('span', 'chip');
  chip.style.setProperty('--chip', sides[curve.side].colour);
  const what = element('span', 'what', `${c} · length ${rounded(curve.length)}`);
  const prominence = element('span', 'prominence', rounded(curve.prominence));
  prominence.title = 'prominence';
  const bar = element('span', 'bar'), fill = element('i');
  fill.style.width = `${100 * Math.min(1, curve.prominence / greatest)}%`;
  bar.append(fill);
  prominence.append(bar);
  const certificate = certificates[curve.certificate] ?? curve.certificate.replace('_', ' ');
  const more = element('span', 'more');
  more.title = certificates[curve.certificate] ? 'proved with exact arithmetic' : curve.certificate;
  const text = [curve.side, certificate, curve.separating ? 'separates' : 'does not separate'].join(' · ');
  more.append(element('span', 'about', text), element('span', 'hidden-below'));
  button.append(chip, what, prominence, more);
  const item = element('li');
  item.append(button);
  return item;
}

// Buttons that show and hide the constrictions of each side, of those sides that occur.
export class SideFilter {
  constructor(curves, onChange) {
    this.hidden = new Set();
    this.buttons = new Map();
    this.onChange = onChange;
    for (const [side, {colour, text}] of Object.entries(sides)) {
      const count = curves.filter(c => c.side === side).length;
      if (count === 0)
        continue;
      const button = element('button');
      button.type = 'button';
      button.title = text;
      button.style.setProperty('--chip', colour);
      button.append(element('span', 'chip'), element('span', '', `${side} ${count}`));
      button.addEventListener('click', () => this.set(side, this.hidden.has(side)));
      this.buttons.set(side, button);
    }
    document.getElementById('sides').append(...this.buttons.values());
    this.show();
  }

  set(side, isShown) {
    this.hidden[isShown ? 'delete' : 'add'](side);
    this.show();
    this.onChange();
  }

  // Shows no other sides than those.
  only(sidesShown) {
    this.hidden = new Set([...this.buttons.keys()].filter(side => !sidesShown.includes(side)));
    this.show();
  }

  show() {
    for (const [side, button] of this.buttons)
      button.setAttribute('aria-pressed', String(!this.hidden.has(side)));
  }
}

export class List {
  constructor(data, onSelect) {
    this.data = data;
    const {mesh, curves} = data;
    document.title = `${mesh.file} – constrictions`;
    document.getElementById('file').textContent = mesh.file;
    document.getElementById('numbers').textContent = [counted(mesh.vertices, 'vertex', 'vertices'),
      counted(mesh.faces, 'face'), ...(mesh.components === 1 ? [] : [counted(mesh.components, 'component')]),
      `genus ${mesh.genus}`, ...(mesh.holes ? [counted(mesh.holes, 'hole')] : [])].join(' · ');
    const finite = curves.map(c => c.prominence).filter(p => p < Infinity);
    const greatest = Math.max(...finite, 0.1);
    this.list = document.getElementById('list');
    this.items = curves.map((curve, c) => row(curve, c, greatest));
    this.list.append(...this.items);
    this.list.addEventListener('click', event => {
      const button = event.target.closest('button');
      if (button)
        onSelect(Number(button.dataset.curve));
    });
  }

  note(text) {
    const note = document.getElementById('note');
    note.textContent = text;
    note.hidden = text === '';
  }

  // Shows the constrictions for which `isShown(c)`. `standsFor[c]` is the number of those that c represents.
  update(isShown, standsFor, selected) {
    let shown = 0;
    this.items.forEach((item, c) => {
      item.hidden = !isShown(c);
      if (item.hidden)
        return;
      ++shown;
      item.firstChild.setAttribute('aria-pressed', String(c === selected));
      item.querySelector('.hidden-below').textContent =
        standsFor[c] > 0 ? ` · stands for ${standsFor[c]} weaker` : '';
    });
    document.getElementById('count').textContent =
      `${integer.format(shown)} of ${counted(this.items.length, 'constriction')} shown`;
    document.getElementById('empty').hidden = shown > 0;
  }

  reveal(c) {
    this.items[c].scrollIntoView({block: 'nearest'});
  }
}
