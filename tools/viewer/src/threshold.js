// SPDX-License-Identifier: GPL-3.0-or-later
// The slider of the least prominence that is shown, with equal ratios at equal distances.
import {rounded} from './list.js';

const steps = 1000;

export class Threshold {
  constructor(curves, start, onChange) {
    this.input = document.getElementById('prominence');
    this.output = document.getElementById('prominence-value');
    const finite = curves.map(c => c.prominence).filter(p => p < Infinity);
    this.greatest = Math.max(...finite, start, 0.1) * 1.001;
    // at the left end of the slider everything is shown
    this.least = Math.max(1e-4, Math.min(...finite.filter(p => p > 0), start || 0.01, 0.01) * 0.999);
    this.set(start);
    this.input.addEventListener('input', () => {
      const i = Number(this.input.value);
      this.value = i === 0 ? 0 : this.least * Math.pow(this.greatest / this.least, i / steps);
      this.show();
      onChange();
    });
  }

  set(value) {
    this.value = value === Infinity ? this.greatest : value;
    const i = this.value <= this.least ? 0
      : Math.log(this.value / this.least) / Math.log(this.greatest / this.least) * steps;
    this.input.value = Math.round(i);
    this.show();
  }

  show() {
    this.output.textContent = rounded(this.value);
    this.input.setAttribute('aria-valuetext', this.output.textContent);
  }
}
