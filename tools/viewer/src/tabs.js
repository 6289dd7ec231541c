// SPDX-License-Identifier: GPL-3.0-or-later
// The list of the constrictions, or that of the parts.

const names = ['curves', 'parts'];

export class Tabs {
  constructor() {
    this.tabs = names.map(name => document.getElementById(`${name}-tab`));
    this.panels = names.map(name => document.getElementById(`${name}-panel`));
    this.tabs.forEach((tab, i) => {
      tab.addEventListener('click', () => this.show(i));
      tab.addEventListener('keydown', event => {
        if (event.shiftKey || !['ArrowLeft', 'ArrowRight'].includes(event.key))
          return;
        event.stopPropagation();
        this.show(1 - i);
        this.tabs[1 - i].focus();
      });
    });
    this.show(0);
  }

  get shown() { return names[this.panels.findIndex(panel => !panel.hidden)]; }

  open(name) { this.show(names.indexOf(name)); }

  show(i) {
    this.tabs.forEach((tab, j) => {
      tab.setAttribute('aria-selected', String(i === j));
      tab.tabIndex = i === j ? 0 : -1;
      this.panels[j].hidden = i !== j;
    });
  }

  // How many each list has.
  count(...numbers) {
    this.tabs.forEach((tab, i) => tab.querySelector('span').textContent = numbers[i].toLocaleString('en'));
  }
}
