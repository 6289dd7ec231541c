// SPDX-License-Identifier: GPL-3.0-or-later
// Keys, but where they mean something to what has the focus.

export function listenToKeys(document, actions) {
  const angle = Math.PI / 18;
  document.addEventListener('keydown', event => {
    if (event.ctrlKey || event.altKey || event.metaKey)
      return;
    const isSlider = event.target instanceof HTMLInputElement;
    const isButton = event.target.closest?.('button, summary') != null;
    const keys = {
      ArrowUp: () => event.shiftKey ? actions.turn(0, -angle) : actions.selectNext(-1),
      ArrowDown: () => event.shiftKey ? actions.turn(0, angle) : actions.selectNext(1),
      ArrowLeft: () => event.shiftKey && actions.turn(-angle, 0),
      ArrowRight: () => event.shiftKey && actions.turn(angle, 0),
      '+': () => actions.zoom(1 / 1.2),
      '=': () => actions.zoom(1 / 1.2),
      '-': () => actions.zoom(1.2),
      ' ': () => actions.play(),
      ',': () => actions.frame(-1),
      '.': () => actions.frame(1),
      Escape: () => actions.back(),
      p: () => actions.parts(),
      e: () => actions.edges(),
      t: () => actions.theme(),
      r: () => actions.whole(),
      s: () => actions.section(),
      x: () => actions.apart(),
    };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!Object.hasOwn(keys, key) || (isSlider && key.startsWith('Arrow')) || (isButton && key === ' '))
      return;
    event.preventDefault();
    keys[key]();
  });
}
