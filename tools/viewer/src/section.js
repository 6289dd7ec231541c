// SPDX-License-Identifier: GPL-3.0-or-later
// A plane across one of the axes, on one side of which the surface is cut away.
import {Plane, Vector3} from 'three/build/three.module.js';
import {rounded} from './list.js';

const steps = 1000, names = ['x', 'y', 'z'];

export class Section {
  // `points` are those of the surface.
  constructor({centre, radius}, points, onChange) {
    this.centre = centre;
    this.radius = radius;
    this.onChange = onChange;
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    points.forEach((x, i) => {
      this.low[i % 3] = Math.min(this.low[i % 3], x);
      this.high[i % 3] = Math.max(this.high[i % 3], x);
    });
    this.isOn = false;
    this.set({axis: 0, at: 0.5, keepsLower: true});
    this.group = document.getElementById('section-plane');
    this.input = document.getElementById('section-at');
    this.output = document.getElementById('section-value');
    this.buttons = names.map(name => document.getElementById(`section-${name}`));
    this.buttons.forEach((button, axis) => button.addEventListener('click', () => this.change({axis, at: 0.5})));
    document.getElementById('section-flip').addEventListener('click', () => this.change({keepsLower: !this.keepsLower}));
    this.input.addEventListener('input', () => this.change({at: Number(this.input.value) / steps}));
    this.show();
  }

  // Of the whole extent along the axis 0 to 1.
  set(values) { Object.assign(this, values); }

  // Puts it at a place on the page.
  moveTo(x) {
    const {[this.axis]: low} = this.low, {[this.axis]: high} = this.high;
    this.set({at: high > low ? Math.max(0, Math.min(1, (x - low) / (high - low))) : 0.5});
    this.show();
  }

  change(values) {
    this.set(values);
    this.show();
    this.onChange();
  }

  // Switches it on so that the half nearer to the viewer is cut away, across the axis that points at the viewer most.
  toggle(towards) {
    if (this.isOn)
      return this.change({isOn: false});
    const sizes = towards.toArray().map(Math.abs), axis = sizes.indexOf(Math.max(...sizes));
    this.change({isOn: true, axis, at: 0.5, keepsLower: towards.getComponent(axis) > 0});
  }

  get place() { return this.low[this.axis] + (this.high[this.axis] - this.low[this.axis]) * this.at; }

  // three.js cuts away where the distance is negative.
  get planes() {
    if (!this.isOn)
      return [];
    const sign = this.keepsLower ? -1 : 1;
    return [new Plane(new Vector3().setComponent(this.axis, sign), -sign * this.place)];
  }

  show() {
    this.group.hidden = !this.isOn;
    this.buttons.forEach((button, axis) => button.setAttribute('aria-pressed', String(axis === this.axis)));
    this.input.value = Math.round(steps * this.at);
    const value = this.centre[this.axis] + this.radius * this.place;
    const isZero = Math.abs(value) < 1e-9 * this.radius; // but for rounding
    this.output.textContent = `${names[this.axis]} = ${isZero ? 0 : rounded(value)}`;
    this.input.setAttribute('aria-valuetext', this.output.textContent);
  }
}
