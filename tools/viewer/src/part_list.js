// SPDX-License-Identifier: GPL-3.0-or-later
// The panel of the parts: how many there are, how far apart they are drawn, and a list of them.
import {element, percent, rounded} from './list.js';

export class PartList {
  // `onNumber(n)` is called when n parts are asked for, `onApart(x)` when they are to be drawn apart by x, from 0 to 1,
  // `onIsolate(p)` when part p is to be shown alone, or again with the others.
  constructor({onNumber, onApart, onIsolate}) {
    this.list = document.getElementById('part-list');
    this.number = document.getElementById('number-of-parts');
    this.numberText = document.getElementById('number-of-parts-value');
    this.apart = document.getElementById('apart');
    this.number.addEventListener('input', () => onNumber(Number(this.number.value)));
    this.apart.addEventListener('input', () => onApart(Number(this.apart.value) / 100));
    this.list.addEventListener('click', event => {
      const button = event.target.closest('button');
      if (button)
        onIsolate(Number(button.dataset.part));
    });
  }

  // Shows the parts in their colours. `isolated` is shown alone, if it is not -1. There can be `least` to `most` parts.
  update({parts}, colours, {isolated, apart}, [least, most]) {
    this.number.min = least;
    this.number.max = most;
    this.number.value = parts.length;
    this.number.disabled = least === most;
    this.numberText.textContent = `${parts.length} of ${most}`;
    this.number.setAttribute('aria-valuetext', this.numberText.textContent);
    this.apart.value = Math.round(100 * apart);
    this.apart.disabled = parts.length === 1;
    this.apart.setAttribute('aria-valuetext', apart === 0 ? 'together' : percent(apart));

    const all = parts.reduce((sum, part) => sum + part.weight, 0), focused = document.activeElement?.dataset.part;
    this.list.replaceChildren(...parts.map((part, p) => this.row(part, p, colours[p], part.weight / all, p === isolated)));
    if (focused !== undefined)
      this.list.children[focused]?.firstChild.focus(); // rows are made anew
  }

  row({area, volume}, p, colour, share, isIsolated) {
    const button = element('button');
    button.type = 'button';
    button.dataset.part = p;
    button.title = isIsolated ? 'Show all parts' : 'Show this part alone';
    button.setAttribute('aria-pressed', String(isIsolated));
    const chip = element('span', 'chip full');
    chip.style.setProperty('--chip', colour);
    const amount = element('span', 'prominence', percent(share));
    amount.title = 'share of the area';
    const bar = element('span', 'bar'), fill = element('i');
    fill.style.width = `${100 * share}%`;
    bar.append(fill);
    amount.append(bar);
    button.append(chip, element('span', 'what', `Part ${p}`), amount, element('span', 'more', sizeOf({area, volume})));
    const item = element('li');
    item.append(button);
    return item;
  }
}

// In words. A part with a hole has no volume; a cavity encloses what is outside of the body. Numbers that are too large
// are null.
export function sizeOf({area, volume}) {
  const enclosed = volume === null ? 'no volume'
    : volume < 0 ? `cavity, volume ${rounded(-volume)}` : `volume ${rounded(volume)}`;
  return area === null ? enclosed : `area ${rounded(area)} · ${enclosed}`;
}
