// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the pages have in common: pages that the program writes, and what is seen of them.
//
//   CONSTRICTIONS_PROGRAM=... CONSTRICTIONS_MESH_DIR=... node test/run.js
import assert from 'node:assert/strict';
import {after, before} from 'node:test';
import {mkdtempSync, rmSync} from 'node:fs';
import {execFileSync} from 'node:child_process';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {tmpdir} from 'node:os';
import {openBrowser, patience} from '../browser.js';

const program = process.env.CONSTRICTIONS_PROGRAM;
export const meshes = process.env.CONSTRICTIONS_MESH_DIR;
export const folder = mkdtempSync(join(tmpdir(), 'constrictions-'));
let browser;

// Opens the browser before the tests of a file, and closes it after them.
export function useBrowser() {
  before(async () => browser = await openBrowser());
  after(async () => {
    await browser?.close();
    rmSync(folder, {recursive: true});
  });
}

// Writes the page of a mesh, and returns its name.
export function write(mesh, ...options) {
  const page = join(folder, 'page.html');
  execFileSync(program, ['view', mesh, '-o', page, '--quiet', ...options]);
  return page;
}

// Opens a page; whatever it says on the console, and every address that it asks for, is noted. `first` is called in the
// page before its own scripts.
export async function open(page, hash = '', viewport = {width: 800, height: 500}, options = {}, first = null) {
  const tab = await browser.newPage({viewport, ...options});
  tab.setDefaultTimeout(patience);
  tab.said = [];
  tab.asked = [];
  tab.on('console', message => tab.said.push(`${message.type()}: ${message.text()}`));
  tab.on('pageerror', error => tab.said.push(error.message));
  tab.on('request', request => tab.asked.push(request.url()));
  if (first)
    await tab.addInitScript(first);
  await tab.goto(pathToFileURL(page).href + hash);
  await settled(tab);
  return tab;
}

export const settled = tab => tab.evaluate(() => window.viewer.settled());
export const state = tab => tab.evaluate(() => window.viewer.state());

// The pixels of the canvas as they are, [r, g, b, a, ...], from the lower left.
export const pixelsNow = async tab => Buffer.from(await tab.evaluate(() => {
  const canvas = document.getElementById('canvas');
  const gl = canvas.getContext('webgl2');
  const data = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  let text = '';
  for (let i = 0; i < data.length; i += 8192)
    text += String.fromCharCode(...data.subarray(i, i + 8192));
  return btoa(text);
}), 'base64');

// Those of what is to be seen in the end.
export const pixels = tab => settled(tab).then(() => pixelsNow(tab));

export function covered(p) {
  let n = 0;
  for (let i = 3; i < p.length; i += 4)
    n += p[i] > 0;
  return n / (p.length / 4);
}

// The share of pixels that differ clearly.
export function difference(p, q) {
  assert.equal(p.length, q.length);
  let n = 0;
  for (let i = 0; i < p.length; i += 4)
    if (Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) + Math.abs(p[i + 2] - q[i + 2]) +
        Math.abs(p[i + 3] - q[i + 3]) > 24)
      ++n;
  return n / (p.length / 4);
}

// How many pixels are nearly of a colour.
export const count = (p, [r, g, b], tolerance = 12) => {
  let n = 0;
  for (let i = 0; i < p.length; i += 4)
    if (p[i + 3] > 0 && Math.max(Math.abs(p[i] - r), Math.abs(p[i + 1] - g), Math.abs(p[i + 2] - b)) <= tolerance)
      ++n;
  return n;
};
export const vermillion = [0xd5, 0x5e, 0x00], yellow = [0xf0, 0xe4, 0x42];
