// SPDX-License-Identifier: GPL-3.0-or-later
// node picture.js PAGE.html OUT.png WIDTHxHEIGHT ADDRESS...
//
// Takes a picture of a page, as it is at an address such as '#select=1&theme=dark'; see src/address.js. With panel=0
// only what is drawn is in the picture, without the empty space around it. Pictures of several addresses are put side by
// side.
import {writeFileSync} from 'node:fs';
import {pathToFileURL} from 'node:url';
import {openBrowser, patience} from './browser.js';

const margin = 8;

// The rectangle of the canvas that is drawn on.
function drawnBox(margin) {
  const canvas = document.getElementById('canvas'), gl = canvas.getContext('webgl2');
  const {width, height} = canvas, data = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  let [left, right, top, bottom] = [width, 0, height, 0];
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      if (data[4 * ((height - 1 - y) * width + x) + 3] > 0) {
        left = Math.min(left, x);
        right = Math.max(right, x + 1);
        top = Math.min(top, y);
        bottom = Math.max(bottom, y + 1);
      }
  left = Math.max(0, left - margin);
  top = Math.max(0, top - margin);
  return {x: left, y: top, width: Math.min(width, right + margin) - left, height: Math.min(height, bottom + margin) - top};
}

const [page, out, size, ...addresses] = process.argv.slice(2);
const [width, height] = size.split('x').map(Number);
const browser = await openBrowser();
try {
  const pictures = [];
  for (const address of addresses) {
    const tab = await browser.newPage({viewport: {width, height}});
    tab.setDefaultTimeout(patience);
    await tab.goto(pathToFileURL(page).href + address);
    await tab.evaluate(() => window.viewer.settled());
    const clip = /[#&]panel=0/.test(address) ? await tab.evaluate(drawnBox, margin) : undefined;
    pictures.push(await tab.screenshot({clip}));
    await tab.close();
  }
  if (pictures.length === 1)
    writeFileSync(out, pictures[0]);
  else {
    const tab = await browser.newPage({viewport: {width: 4000, height}});
    await tab.setContent(`<div style="display: inline-flex; gap: 24px; align-items: flex-end; background: white">${
      pictures.map(p => `<img src="data:image/png;base64,${p.toString('base64')}">`).join('')}</div>`);
    await tab.locator('div').screenshot({path: out});
  }
} finally {
  await browser.close();
}
