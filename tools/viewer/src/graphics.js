// SPDX-License-Identifier: GPL-3.0-or-later
// The graphics that the browser gives a canvas. It may have none at first, and may take them away at any time and give
// them back, as when its graphics process starts anew. While there are none, a sentence says so.

const drawing = {antialias: true, alpha: true, preserveDrawingBuffer: true};

const sentences = {
  missing: 'The browser has no graphics to draw the surface with: WebGL is switched off, or not there.',
  lost: 'The browser has lost its graphics; the surface is drawn again when they are back, or when the page is loaded '
    + 'again.',
};

export class Graphics {
  // `onOpen(context)` is called when there is a context that works for the first time: at once, if the browser is well.
  // `onReturn()` is called whenever the context has come back; what was in it is gone.
  constructor(canvas, onOpen, onReturn) {
    this.canvas = canvas;
    this.onOpen = onOpen;
    this.isOpen = false;
    canvas.addEventListener('webglcontextlost', event => {
      event.preventDefault(); // or it never comes back
      this.tell('lost');
    });
    canvas.addEventListener('webglcontextrestored', () => {
      if (this.isOpen) {
        this.tell();
        onReturn();
      } else // not now: a renderer of three.js that has failed listens, too, and sets the context up
        setTimeout(() => this.ask(500));
    });
    this.ask(500);
  }

  // Less and less often, until there is a context.
  ask(milliseconds) {
    if (!this.isOpen && !this.open())
      setTimeout(() => this.ask(2 * milliseconds), milliseconds);
  }

  open() {
    const context = this.canvas.getContext('webgl2', drawing) ?? this.canvas.getContext('webgl', drawing);
    this.isOpen = context !== null && !context.isContextLost();
    if (this.isOpen)
      try {
        this.onOpen(context);
      } catch (error) {
        if (!context.isContextLost())
          throw error;
        this.isOpen = false; // it was lost meanwhile: three.js does not expect that
      }
    this.tell(this.isOpen ? undefined : context ? 'lost' : 'missing');
    return this.isOpen;
  }

  tell(failure) {
    const sentence = document.getElementById('failure');
    sentence.textContent = sentences[failure] ?? '';
    sentence.hidden = !failure;
    document.getElementById('save-picture').disabled = Boolean(failure);
  }
}
