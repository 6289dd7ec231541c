// SPDX-License-Identifier: GPL-3.0-or-later
// What the pointer is on: it is named beside the pointer, and a click selects a curve.

export class Pointer {
  // `find(x, y, reach)` returns {curve, part} at a place of the canvas, each -1 if there is none; `nameOf` of that a text,
  // or ''. `onHover(curve)` and `onClick(curve)` are called when the pointer comes to another curve, or to none, and
  // for a click on a curve.
  constructor(canvas, {find, nameOf, onHover, onClick}) {
    this.canvas = canvas;
    this.label = document.getElementById('hover');
    this.onHover = onHover;
    this.curve = -1;
    let pressed = null, waiting = null;
    const place = event => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener('pointerdown', event => {
      pressed = [event.clientX, event.clientY];
      this.leave();
    });
    // a click, not the end of a drag
    canvas.addEventListener('pointerup', event => {
      const from = pressed;
      pressed = null;
      if (!from || Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4)
        return;
      const {curve} = find(...place(event), event.pointerType === 'touch' ? 24 : 10);
      if (curve >= 0)
        onClick(curve);
    });
    // once for each picture: to look takes some milliseconds on large surfaces
    canvas.addEventListener('pointermove', event => {
      if (event.pointerType === 'touch' || pressed || event.buttons !== 0)
        return;
      if (!waiting)
        requestAnimationFrame(() => {
          const [x, y] = waiting;
          waiting = null;
          if (pressed)
            return;
          const found = find(x, y, 10);
          this.show(nameOf(found), x, y, found.curve);
        });
      waiting = place(event);
    });
    canvas.addEventListener('pointerleave', () => {
      waiting &&= [-1, -1];
      this.leave();
    });
  }

  show(text, x, y, curve) {
    this.label.textContent = text;
    this.label.hidden = text === '';
    this.canvas.classList.toggle('on-curve', curve >= 0);
    if (text !== '') {
      // beside the pointer, inside the canvas
      const {offsetWidth, offsetHeight} = this.label, {clientWidth} = this.canvas;
      this.label.style.left = `${Math.max(4, Math.min(x + 14, clientWidth - offsetWidth - 4))}px`;
      this.label.style.top = `${y > offsetHeight + 20 ? y - offsetHeight - 12 : y + 20}px`;
    }
    if (curve !== this.curve)
      this.onHover(this.curve = curve);
  }

  leave() { this.show('', 0, 0, -1); }
}
