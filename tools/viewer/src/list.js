// SPDX-License-Identifier: GPL-3.0-or-later
// The panel: what the mesh is, the threshold, and the list of constrictions. Text is set as text, never as HTML.
import {sides} from './colours.js';

const integer = new Intl.NumberFormat('en');
export const counted = (n, one, many = one + 's') => `${integer.format(n)} ${n === 1 ? one : many}`;
export const rounded = x => x === Infinity ? '∞' : Number(x.toPrecision(3)).toString();
export const percent = x => `${rounded(Number((100 * x).toPrecision(2)))}%`;

export const element = (name, className, text) => {
  const result = document.createElement(name);
  if (className)
    result.className = className;
  if (text !== undefined)
    result.textContent = text;
  return result;
};

// What the certificates say, and what that means.
const certificates = {
  strict_constriction: ['strict', 'proved with exact arithmetic: every curve near it is longer'],
  constriction: ['not strict', 'proved with exact arithmetic: no curve near it is shorter, but some are as long'],
};
const certificate = curve => certificates[curve.certificate] ?? ['not proved', curve.certificate];

// What is worth saying of the curves of a page: of what they all have in common one sentence speaks.
class Facts {
  constructor(curves) {
    const differ = of => new Set(curves.map(of)).size > 1;
    this.tellsSide = differ(c => c.side);
    this.tellsCertificate = differ(c => c.certificate);
    this.tellsSeparating = differ(c => c.separating);
    const said = [];
    if (curves.length > 1) {
      if (!this.tellsSide)
        said.push(sides[curves[0].side].name);
      if (!this.tellsCertificate && certificates[curves[0].certificate])
        said.push(curves[0].certificate === 'constriction' ? 'proved, none strict' : 'proved strict');
      if (!this.tellsSeparating && !curves[0].separating)
        said.push('not separating');
    }
    this.inCommon = said.length > 0 ? `All are ${said.join(', ')}` : '';
    // alone there is nothing to differ from
    this.isAlone = curves.length === 1;
  }

  // In what a curve differs. `pairs` are the parts on its sides.
  of(curve, pairs, standsFor) {
    const result = [];
    if (this.tellsSide || this.isAlone)
      result.push(sides[curve.side].words);
    const parts = [...new Set(pairs.flat())].sort((p, q) => p - q);
    if (parts.length > 0)
      result.push(parts.length === 1 ? `in part ${parts[0]}`
        : `parts ${parts.slice(0, -1).join(', ')} and ${parts[parts.length - 1]}`);
    if (!curve.separating && (this.tellsSeparating || this.isAlone))
      result.push('does not separate');
    if (this.tellsCertificate || this.isAlone || !certificates[curve.certificate])
      result.push(certificate(curve)[0]);
    if (!curve.cuts)
      result.push('crosses a more prominent one');
    if (standsFor > 0)
      result.push(`stands for ${standsFor} weaker`);
    return result.join(' · ');
  }
}

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
  const more = element('span', 'more');
  button.append(chip, what, prominence, more);
  const item = element('li');
  item.append(button);
  return item;
}

// Buttons that show and hide the constrictions of each side, of those sides that occur.
export class SideFilter {
  // `onChange()` is called when others are to be shown.
  constructor(curves, onChange) {
    this.curves = curves;
    this.hidden = new Set();
    this.buttons = new Map();
    this.onChange = onChange;
    for (const [side, {colour, text, name}] of Object.entries(sides)) {
      if (!curves.some(c => c.side === side))
        continue;
      const button = element('button');
      button.type = 'button';
      button.title = text;
      button.style.setProperty('--chip', colour);
      button.append(element('span', 'chip'), element('span', '', name), element('span', 'number'));
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

  // Says how many of each side are listed, or would be: those for which `isEligible(c)`.
  count(isEligible) {
    for (const [side, button] of this.buttons)
      button.querySelector('.number').textContent =
        integer.format(this.curves.filter((curve, c) => curve.side === side && isEligible(c)).length);
  }
}

export class List {
  // `onSelect(c)` is called for a click on constriction c, `onHover(c)` when the pointer comes to it; -1 is none.
  constructor(data, onSelect, onHover) {
    this.data = data;
    this.facts = new Facts(data.curves);
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
    this.list.addEventListener('pointerover', event =>
      onHover(Number(event.target.closest('button')?.dataset.curve ?? -1)));
    this.list.addEventListener('pointerleave', () => onHover(-1));
  }

  note(text) {
    const note = document.getElementById('note');
    note.textContent = text;
    note.hidden = text === '';
  }

  // Shows the constrictions for which `isShown(c)`. `standsFor[c]` is the number of those that c represents, `between[c]`
  // are the parts on its sides.
  update(isShown, standsFor, between, selected) {
    let shown = 0;
    this.items.forEach((item, c) => {
      item.hidden = !isShown(c);
      if (item.hidden)
        return;
      ++shown;
      item.firstChild.setAttribute('aria-pressed', String(c === selected));
      const more = item.querySelector('.more');
      more.textContent = this.facts.of(this.data.curves[c], between[c], standsFor[c]);
      more.title = certificate(this.data.curves[c])[1];
    });
    document.getElementById('count').textContent =
      `${integer.format(shown)} of ${counted(this.items.length, 'constriction')} shown`
      + (this.facts.inCommon ? `. ${this.facts.inCommon}.` : '');
    document.getElementById('empty').hidden = shown > 0;
  }

  reveal(c) {
    this.items[c].scrollIntoView({block: 'nearest'});
  }
}
