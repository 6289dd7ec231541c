// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of Okabe and Ito, which people with any kind of colour vision can tell apart.
import {Color} from 'three/build/three.module.js';

// Light is added in a space where colours are proportional to it. On the screen are these values to the power of
// 1 / gamma.
export const gamma = 2.2;
export const light = colour => new Color(colour).convertGammaToLinear(gamma);

// The colour for CSS that looks as light does on the screen.
export const css = light => `#${light.clone().convertLinearToGamma(gamma).getHexString()}`;

export const sides = {
  object: {colour: '#d55e00', name: 'necks', words: 'neck',
    text: 'necks, in files “object”: the body is narrow there'},
  complement: {colour: '#0072b2', name: 'openings', words: 'opening',
    text: 'openings, in files “complement”: the space outside is narrow there, as in a hole'},
  mixed: {colour: '#009e73', name: 'mixed', words: 'neck and opening',
    text: 'mixed: partly the one, partly the other'},
};
export const selection = '#f0e442';
export const seed = '#f0e442';

const partHues = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#f0e442', '#7d8fb3'];

// What depends on the theme. Parts are tints, so that the curves stand out.
export function scheme(theme) {
  const dark = theme === 'dark';
  const toward = light(dark ? '#6c737b' : '#f4f4f2');
  return {
    surface: light(dark ? '#9aa3ad' : '#d3d7dc'),
    parts: partHues.map(hue => light(hue).lerp(toward, 0.5)),
    casing: dark ? '#ffffff' : '#14171a',
    edges: dark ? '#000000' : '#20252b',
    inside: dark ? 0.3 : 0.45, // the brightness of what is seen through a cut
  };
}
