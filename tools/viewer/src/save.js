// SPDX-License-Identifier: GPL-3.0-or-later
// What can be taken away from the page: a picture, tables, a link.
import {marksSize} from './marks.js';

// The name of the mesh file without its extensions.
const stem = file => file.replace(/(\.[A-Za-z0-9]{1,5}){1,2}$/, '') || 'constrictions';

export function download(name, blob) {
  const a = document.createElement('a');
  a.download = name;
  a.href = URL.createObjectURL(blob);
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 10_000);
}

// What the canvas shows, on its ground and with its marks, as PNG.
export function pictureOf(stage, marks) {
  stage.inset.isAllowed = false;
  stage.draw();
  stage.inset.isAllowed = true;
  const {canvas} = stage, picture = document.createElement('canvas');
  const {width, height} = Object.assign(picture, {width: canvas.width, height: canvas.height});
  const context = picture.getContext('2d'), style = getComputedStyle(document.body);
  const ground = context.createLinearGradient(0, 0, 0, height);
  ground.addColorStop(0, style.getPropertyValue('--stage-top'));
  ground.addColorStop(1, style.getPropertyValue('--stage-bottom'));
  context.fillStyle = ground;
  context.fillRect(0, 0, width, height);
  context.drawImage(canvas, 0, 0);
  const ratio = width / canvas.clientWidth;
  context.translate(0, height - marksSize[1] * ratio);
  marks.draw(context, ratio, stage.camera, stage.pixelsPerUnit);
  stage.invalidate();
  return new Promise(done => picture.toBlob(done));
}

// As RFC 4180 says, but for the ends of lines.
export function csv(rows) {
  const field = x => {
    const text = x === null || x === undefined || x === Infinity ? '' : String(x);
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return rows.map(row => row.map(field).join(',') + '\n').join('');
}

// The curves that are shown. The columns that `constrictions detect --csv` has, too, have its names.
export function curvesAsCsv(curves, shown, between) {
  return csv([['id', 'length', 'diameter', 'centroid_x', 'centroid_y', 'centroid_z', 'prominence', 'isoperimetric_ratio',
    'separating', 'side', 'dominated_by', 'pivots', 'certificate', 'left_part', 'right_part'],
  ...shown.map(c => {
    const curve = curves[c], [left, right] = between[c][0] ?? [];
    return [c, curve.length, curve.diameter, ...curve.centroid, curve.prominence, curve.isoperimetric_ratio,
      curve.separating, curve.side, curve.dominated_by, curve.pivots, curve.certificate, left, right];
  })]);
}

export function partsAsCsv({parts}) {
  return csv([['part', 'area', 'volume'], ...parts.map(({area, volume}, p) => [p, area, volume])]);
}

// The menu. `picture()` returns a promise of a blob, the others a text.
export class SaveMenu {
  constructor(file, {picture, curves, parts, link}) {
    this.menu = document.getElementById('save');
    this.message = document.getElementById('message');
    this.timer = 0;
    const on = (id, action) => document.getElementById(id).addEventListener('click', async () => {
      this.close();
      this.say(await action());
    });
    const table = (name, text) => {
      download(name, new Blob([text], {type: 'text/csv'}));
      return `${name} is saved`;
    };
    on('save-picture', async () => {
      const name = `${stem(file)}.png`;
      download(name, await picture());
      return `${name} is saved`;
    });
    on('save-curves', () => table(`${stem(file)}-constrictions.csv`, curves()));
    on('save-parts', () => table(`${stem(file)}-parts.csv`, parts()));
    on('save-link', async () => {
      history.replaceState(null, '', link());
      // browsers may refuse it for files
      return navigator.clipboard.writeText(location.href).then(
        () => 'The link to this view is copied; it is in the address bar, too',
        () => 'The link to this view is in the address bar');
    });
    document.addEventListener('pointerdown', event => {
      if (!this.menu.contains(event.target))
        this.menu.open = false;
    });
  }

  // Returns whether it was open.
  close() {
    const wasOpen = this.menu.open;
    this.menu.open = false;
    if (wasOpen)
      this.menu.querySelector('summary').focus();
    return wasOpen;
  }

  say(text) {
    this.message.textContent = text;
    this.message.hidden = false;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.message.hidden = true, 5000);
  }
}
