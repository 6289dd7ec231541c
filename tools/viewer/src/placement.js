// SPDX-License-Identifier: GPL-3.0-or-later
// Where parts and curves are drawn: together, apart, or one part alone.
import {Vector3} from 'three/build/three.module.js';
import {areaVector} from './view_of_curve.js';
import {movesApart} from './explode.js';

const none = new Vector3();

export class Placement {
  // `finest` is the surface of the result, which `surface` draws, and `extent` the radius of a ball around the origin that
  // it is in.
  constructor(data, finest, extent, {surface, drawn, lids}) {
    Object.assign(this, {data, finest, extent, surface, drawn, lids});
    this.frames = new Map();
    this.moves = null; // of parts and curves, if parts are apart
    this.radius = extent; // of a ball around the origin that all is in
  }

  moveOfPart(p) { return this.moves ? this.moves.parts[p] : none; }

  // The centre and the unit normal of a curve.
  frameOf(c) {
    const {data, drawn, frames} = this;
    if (!frames.has(c))
      frames.set(c, {
        centre: new Vector3().fromArray(data.curves[c].centroid.map((x, i) => (x - data.centre[i]) / data.radius)),
        normal: areaVector(drawn.points(c)).normalize(),
      });
    return frames.get(c);
  }

  // Draws the parts of a division apart, by 0 to 1, or part `alone`, if that is not -1. If the result is drawn, and not a
  // level of the playback, its faces are placed, and the cuts that are seen get lids; `colourOf(p)` is that of a part, and
  // the inside is dark by `brightness`.
  update(division, {apart, alone}, isResult, colourOf, brightness) {
    const {data, finest, extent, surface, drawn, lids} = this;
    this.moves = apart > 0 ? movesApart(division, c => this.frameOf(c), 0.3 * extent * apart) : null;
    drawn.moves = this.moves?.curves ?? null;
    this.radius = extent;
    if (this.moves)
      division.parts.forEach(({middle, radius}, p) =>
        this.radius = Math.max(this.radius, middle.length() + this.moveOfPart(p).length() + radius));

    const isOpen = isResult && (this.moves !== null || alone >= 0);
    if (isResult)
      surface.place(!isOpen ? null : f => {
        const p = division.of[finest.parts[f]];
        return alone >= 0 && p !== alone ? null : this.moveOfPart(p);
      });
    // a curve around an opening has the body on its outside
    lids.set(!isOpen ? [] : division.between.flatMap((pairs, c) => [...new Set(pairs.flat())]
      .filter(p => data.curves[c].side !== 'complement' && (alone < 0 || p === alone))
      .map(p => ({points: drawn.points(c), move: this.moveOfPart(p), colour: colourOf(p)}))), brightness);
    return isOpen;
  }
}
