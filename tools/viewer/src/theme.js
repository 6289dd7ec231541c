// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system has it, until the user chooses.

export class Theme {
  constructor(onChange) {
    this.system = matchMedia('(prefers-color-scheme: dark)');
    this.chosen = null;
    this.onChange = onChange;
    this.system.addEventListener('change', () => this.apply());
    document.documentElement.dataset.theme = this.name;
  }

  get name() { return this.chosen ?? (this.system.matches ? 'dark' : 'light'); }

  set(name) {
    this.chosen = name;
    this.apply();
  }

  toggle() { this.set(this.name === 'dark' ? 'light' : 'dark'); }

  apply() {
    document.documentElement.dataset.theme = this.name;
    this.onChange();
  }
}
