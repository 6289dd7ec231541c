// SPDX-License-Identifier: GPL-3.0-or-later
// How the constrictions were found: from the coarsest level to the input with seeds as they appear and curves as they
// are carried along, and at last the curves as they are tightened on the input.
import {BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial} from 'three/build/three.module.js';
import {ClosedLine} from './lines.js';
import {light, seed, sides} from './colours.js';
import {counted} from './list.js';
import {levelSurface} from './levels.js';

const millisecondsPerFrame = 170;

// A closed polygon filled from its centre.
function filled(points) {
  const n = points.length / 3, centre = [0, 0, 0], corners = [];
  for (let i = 0; i < points.length; ++i)
    centre[i % 3] += points[i] / n;
  for (let i = 0; i < n; ++i)
    corners.push(...centre, ...points.slice(3 * i, 3 * i + 3), ...points.slice(3 * ((i + 1) % n), 3 * ((i + 1) % n) + 3));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  const mesh = new Mesh(geometry, new MeshBasicMaterial({color: light(seed), side: DoubleSide, transparent: true,
    opacity: 0.55, depthTest: false}));
  mesh.renderOrder = 1;
  return mesh;
}

export class Playback {
  // `onFrame(i)` is called when frame i is to be shown, with -1 for the result. Of the curves those are shown that lead
  // to a constriction c for which `isShown(c)`.
  constructor(data, isShown, onFrame) {
    this.data = data;
    this.isShown = isShown;
    this.onFrame = onFrame;
    this.frames = data.playback.frames;
    this.group = new Group();
    this.objects = [];
    this.frame = -1;
    this.timer = 0;
    this.input = document.getElementById('level');
    this.play = document.getElementById('play');
    this.input.max = this.frames.length; // the last is the tightened result on the input
    this.input.value = this.frames.length;
    this.input.addEventListener('input', () => {
      this.stop();
      this.show(Number(this.input.value));
    });
    this.play.addEventListener('click', () => this.toggle());
    document.getElementById('result').addEventListener('click', () => this.leave());
    this.describe();
  }

  get isOn() { return this.frame >= 0; }
  get isAtEnd() { return this.frame === this.frames.length; }

  // The level of the frame, and of the surface that is drawn for it, which may be coarser.
  level(frame) { return frame < this.frames.length ? this.frames[frame].level : 0; }
  shownLevel(frame) { return Math.max(this.level(frame), this.data.playback.finest_shown_level); }

  surface(frame) {
    return levelSurface(this.data.arrays, this.shownLevel(frame) - this.data.playback.finest_shown_level);
  }

  show(frame) {
    this.frame = Math.max(0, Math.min(this.frames.length, frame));
    this.input.value = this.frame;
    this.describe();
    this.onFrame(this.frame);
  }

  leave() {
    this.stop();
    this.frame = -1;
    this.input.value = this.frames.length;
    this.describe();
    this.onFrame(-1);
  }

  toggle() {
    if (this.timer) {
      this.stop();
      return;
    }
    if (!this.isOn || this.isAtEnd)
      this.show(0);
    this.timer = setInterval(() => {
      if (this.frame < this.frames.length)
        this.show(this.frame + 1);
      if (this.isAtEnd)
        this.stop();
    }, millisecondsPerFrame);
    this.describe();
  }

  stop() {
    clearInterval(this.timer);
    this.timer = 0;
    this.describe();
  }

  // The numbers of the curves of a frame.
  curves(frame) {
    const {frame_begins, carried_curves} = this.data.arrays, result = [];
    if (frame < this.frames.length)
      for (let i = frame_begins[frame]; i < frame_begins[frame + 1]; ++i)
        if (this.isShown(carried_curves[i]))
          result.push(i);
    return result;
  }

  describe() {
    document.getElementById('play-text').textContent = this.timer ? 'Pause' : 'Play';
    document.getElementById('result').hidden = !this.isOn;
    const {collapses, followed} = this.data.playback;
    let text = 'How they were found: from the coarsest level to the input';
    if (this.isAtEnd)
      text = 'On the input: the curves, tightened';
    else if (this.isOn) {
      const curves = this.curves(this.frame);
      const seeds = curves.filter(i => this.data.arrays.carried_are_seeds[i] !== 0).length;
      const {level, vertices} = this.frames[this.frame];
      text = `Level ${level.toLocaleString('en')} of ${collapses.toLocaleString('en')}: `
        + `${counted(vertices, 'vertex', 'vertices')}, ${counted(curves.length, 'curve')}`
        + (seeds > 0 ? `, ${counted(seeds, 'new seed')}` : '');
      if (this.shownLevel(this.frame) !== level)
        text += `; drawn on a coarser level`;
      if (followed < this.data.curves.length)
        text += `; of the ${followed} most prominent`;
    }
    document.getElementById('status').textContent = text;
    this.input.setAttribute('aria-valuetext', text);
  }

  // Puts the curves of the frame into the group.
  update(scheme, width, selected) {
    for (const o of this.objects) {
      this.group.remove(o.group ?? o);
      o.group ? o.dispose() : (o.geometry.dispose(), o.material.dispose());
    }
    this.objects = [];
    if (!this.isOn)
      return;
    this.describe(); // what is shown may have been chosen anew
    const {carried_curves, carried_are_seeds, carried_begins, carried_points} = this.data.arrays;
    for (const i of this.curves(this.frame)) {
      const points = Array.from(carried_points.subarray(3 * carried_begins[i], 3 * carried_begins[i + 1]),
        x => x / 65535 * 4 - 2);
      const c = carried_curves[i], isSeed = carried_are_seeds[i] !== 0, line = new ClosedLine(points);
      line.set({
        colour: sides[this.data.curves[c].side].colour,
        width: isSeed || c === selected ? 1.8 * width : width,
        casing: isSeed ? seed : scheme.casing,
        border: isSeed ? 3 : 1,
        ghost: true,
      });
      this.objects.push(line);
      this.group.add(line.group);
      if (isSeed) {
        const area = filled(points);
        this.objects.push(area);
        this.group.add(area);
      }
    }
  }
}
