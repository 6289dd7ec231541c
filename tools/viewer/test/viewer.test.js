// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the pages that the program writes, in a browser without a screen; see pages.js.
import assert from 'node:assert/strict';
import {before, describe, it} from 'node:test';
import {copyFileSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {count, covered, difference, folder, meshes, open, pixels, settled, state, useBrowser, vermillion, write, yellow}
  from './pages.js';

// A dumbbell: a surface of revolution, closed by a vertex at each end, as the text of an OFF file. Its radius is not even,
// by such a share of it.
function dumbbell(rings, corners, roughness = 0, neck = 0) {
  const points = ['0 0 -1.2'], faces = [];
  for (let i = 0; i < rings; ++i) {
    const z = -1.2 + 2.4 * (i + 1) / (rings + 1), r = Math.sqrt(1.44 - z * z) * (0.2 + (z - neck) ** 2);
    for (let j = 0; j < corners; ++j) {
      const angle = 2 * Math.PI * j / corners, x = r * (1 + roughness * Math.sin(2.1 * i) * Math.sin(1.7 * j));
      points.push(`${x * Math.cos(angle)} ${x * Math.sin(angle)} ${z}`);
    }
  }
  points.push('0 0 1.2');
  const vertex = (i, j) => 1 + i * corners + j % corners;
  for (let j = 0; j < corners; ++j) {
    faces.push(`3 0 ${vertex(0, j + 1)} ${vertex(0, j)}`, `3 ${points.length - 1} ${vertex(rings - 1, j)} ${vertex(rings - 1, j + 1)}`);
    for (let i = 0; i + 1 < rings; ++i)
      faces.push(`3 ${vertex(i, j)} ${vertex(i, j + 1)} ${vertex(i + 1, j + 1)}`, `3 ${vertex(i, j)} ${vertex(i + 1, j + 1)} ${vertex(i + 1, j)}`);
  }
  return `OFF\n${points.length} ${faces.length} 0\n${points.join('\n')}\n${faces.join('\n')}\n`;
}

describe('the viewer', () => {
  let cactus;

  useBrowser();
  before(async () => cactus = await open(write(join(meshes, 'cactus.off'))));

  it('needs no network, and says nothing', async () => {
    assert.deepEqual(cactus.said, []);
    assert.deepEqual(cactus.asked.filter(url => !url.startsWith('file:') && !url.startsWith('data:')), []);
    assert.equal(cactus.asked.filter(url => url.startsWith('file:')).length, 1);
  });

  it('draws the surface and the curves', async () => {
    const p = await pixels(cactus);
    const share = covered(p);
    assert.ok(share > 0.1 && share < 0.6, `${share} of the canvas is covered`);
    assert.ok(count(p, vermillion) > 100, 'there are no curves');
    assert.equal(count(p, yellow), 0, 'something is selected');
  });

  it('colours the parts', async () => {
    const before = await pixels(cactus);
    await cactus.click('#parts');
    const grey = await pixels(cactus);
    assert.ok(difference(before, grey) > 0.05);
    await cactus.click('#parts');
    assert.equal(difference(before, await pixels(cactus)), 0);
  });

  it('lists the constrictions by prominence', async () => {
    const rows = await cactus.locator('#list li:visible').allTextContents();
    const {shown} = await state(cactus);
    assert.equal(rows.length, shown.length);
    assert.ok(rows.length >= 3);
    const prominences = await cactus.evaluate(() => window.viewer.data.curves.map(c => c.prominence));
    assert.deepEqual(prominences, [...prominences].sort((a, b) => b - a));
    assert.match(rows[0], /^0 · length 0\.599.*0\.61.*parts \d and \d/);
  });

  it('flies to the constriction that is clicked in the list, and lights it up', async () => {
    const before = await pixels(cactus), {position} = await state(cactus);
    await cactus.locator('#list button').nth(1).click();
    const p = await pixels(cactus), s = await state(cactus);
    assert.equal(s.selected, 1);
    assert.ok(Math.hypot(...s.position.map((x, i) => x - position[i])) > 0.2, 'the camera has not moved');
    assert.ok(difference(before, p) > 0.1);
    assert.ok(count(p, yellow) > 100, 'nothing is lit up');
    assert.equal(await cactus.locator('#list button[aria-pressed=true]').count(), 1);
    await cactus.keyboard.press('Escape');
    assert.equal((await state(cactus)).selected, -1);
    await cactus.click('#whole');
    assert.ok(difference(before, await pixels(cactus)) < 0.01, 'this is not the first view');
  });

  it('selects the curve that is clicked on the surface', async () => {
    const place = await cactus.evaluate(() => {
      const canvas = document.getElementById('canvas'), gl = canvas.getContext('webgl2');
      const data = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
      const box = canvas.getBoundingClientRect();
      for (let i = 0; i < data.length; i += 4)
        if (data[i] === 0xd5 && data[i + 1] === 0x5e && data[i + 2] === 0)
          return [box.left + (i / 4 % canvas.width) / canvas.width * box.width,
            box.bottom - Math.floor(i / 4 / canvas.width) / canvas.height * box.height];
    });
    await cactus.mouse.click(...place);
    await settled(cactus);
    assert.ok((await state(cactus)).selected >= 0);
    await cactus.keyboard.press('Escape');
    await cactus.keyboard.press('r');
    await settled(cactus);
  });

  it('shows weaker curves as the threshold falls, and fewer as it rises', async () => {
    const before = await state(cactus), p = await pixels(cactus);
    const set = value => cactus.locator('#prominence').fill(String(value));
    await set(0);
    const all = await state(cactus);
    assert.ok(all.shown.length > before.shown.length);
    assert.ok(difference(p, await pixels(cactus)) > 0.001);
    await set(1000);
    const none = await state(cactus);
    assert.deepEqual(none.shown, []);
    assert.ok(await cactus.locator('#empty').isVisible());
    const q = await pixels(cactus);
    assert.equal(count(q, vermillion), 0);
    await cactus.locator('#prominence').evaluate((input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    }, 380);
    const {shown, prominence} = await state(cactus);
    const curves = await cactus.evaluate(() => window.viewer.data.curves);
    assert.deepEqual(shown, curves.map((_, c) => c).filter(c => curves[c].prominence >= prominence));
  });

  it('plays from the coarsest level to the input', async () => {
    const level = cactus.locator('#level'), frames = Number(await level.getAttribute('max'));
    assert.ok(frames > 20);
    const seen = [];
    for (const frame of [0, Math.floor(frames / 2), frames - 1, frames]) {
      await level.fill(String(frame));
      const s = await state(cactus);
      assert.equal(s.frame, frame);
      seen.push({...s, pixels: await pixels(cactus), text: await cactus.locator('#status').textContent()});
    }
    assert.ok(seen[0].faces < seen[1].faces && seen[1].faces < seen[2].faces);
    assert.equal(seen[2].faces, 1236);
    for (let i = 0; i < 3; ++i)
      assert.ok(difference(seen[i].pixels, seen[i + 1].pixels) > 0.01, `frames ${i} and ${i + 1} look alike`);
    assert.match(seen[2].text, /Level 0 of .*: 620 vertices, [1-9][0-9]* curves/);
    // the surfaces of all levels are closed
    const euler = await cactus.evaluate(() => {
      const {playback} = window.viewer;
      return playback.frames.map((_, i) => {
        const {faces} = playback.surface(i), vertices = new Set(faces), edges = new Set();
        for (let f = 0; f < faces.length; f += 3)
          for (let j = 0; j < 3; ++j) {
            const a = faces[f + j], b = faces[f + (j + 1) % 3];
            edges.add(Math.min(a, b) * 65536 + Math.max(a, b));
          }
        return [vertices.size, vertices.size - edges.size + faces.length / 3];
      });
    });
    euler.forEach(([vertices, characteristic], i) => assert.equal(characteristic, 2, `frame ${i}, ${vertices} vertices`));
    assert.deepEqual(euler.map(([vertices]) => vertices),
      await cactus.evaluate(() => window.viewer.playback.frames.map(f => f.vertices)));
    await cactus.click('#result');
    assert.equal((await state(cactus)).frame, -1);
  });

  it('shows seeds as they appear, and each follows on to its constriction', async () => {
    const {seedFrame, ends} = await cactus.evaluate(() => {
      const {arrays} = window.viewer.data, {frame_begins, carried_curves, carried_are_seeds} = arrays;
      const last = frame_begins.length - 2;
      return {
        seedFrame: Array.from(frame_begins).findLastIndex(begin => begin <= carried_are_seeds.indexOf(1)),
        ends: Array.from(carried_curves.subarray(frame_begins[last], frame_begins[last + 1])),
      };
    });
    assert.ok(ends.includes(0) && ends.includes(1) && ends.includes(2));
    await cactus.locator('#prominence').fill('0');
    await cactus.locator('#level').fill(String(seedFrame));
    assert.ok(count(await pixels(cactus), yellow, 60) > 20, 'no seed is lit up');
    assert.match(await cactus.locator('#status').textContent(), /new seed/);
    await cactus.locator('#sides button').first().click();
    assert.match(await cactus.locator('#status').textContent(), /, 0 curves/);
    await cactus.locator('#sides button').first().click();
    assert.match(await cactus.locator('#status').textContent(), /new seed/);
    await cactus.keyboard.press('Escape');
  });

  it('plays by itself, and obeys the keyboard', async () => {
    await cactus.locator('#canvas').focus();
    await cactus.keyboard.press(' ');
    await cactus.waitForFunction(() => window.viewer.playback.frame > 2);
    await cactus.keyboard.press(' ');
    const {frame} = await state(cactus);
    await cactus.keyboard.press('.');
    assert.equal((await state(cactus)).frame, frame + 1);
    await cactus.keyboard.press('Escape');
    await cactus.keyboard.press('ArrowDown');
    await settled(cactus);
    const {selected, position} = await state(cactus);
    assert.equal(selected, (await state(cactus)).shown[0]);
    await cactus.keyboard.press('Shift+ArrowLeft');
    await settled(cactus);
    assert.notDeepEqual((await state(cactus)).position, position);
    await cactus.keyboard.press('Escape');
  });

  it('can be dark', async () => {
    const ground = () => cactus.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const before = await ground();
    await cactus.click('#theme');
    assert.notEqual(await ground(), before);
    await cactus.click('#theme');
    assert.equal(await ground(), before);
    const dark = await open(join(folder, 'page.html'), '', {width: 400, height: 300}, {colorScheme: 'dark'});
    assert.equal((await state(dark)).theme, 'dark');
    await dark.close();
  });

  it('turns by touch on a phone', async () => {
    const phone = await open(join(folder, 'page.html'), '', {width: 390, height: 800}, {hasTouch: true, isMobile: true});
    assert.ok(covered(await pixels(phone)) > 0.05);
    const wide = await phone.evaluate(() => document.documentElement.scrollWidth);
    assert.equal(wide, 390);
    const {position} = await state(phone);
    const session = await phone.context().newCDPSession(phone);
    const touch = (type, points) => session.send('Input.dispatchTouchEvent', {type, touchPoints: points});
    await touch('touchStart', [{x: 150, y: 200}]);
    await touch('touchMove', [{x: 190, y: 210}]);
    await touch('touchMove', [{x: 250, y: 220}]);
    await touch('touchEnd', []);
    await settled(phone);
    assert.notDeepEqual((await state(phone)).position, position);
    assert.deepEqual(phone.said, []);
    await phone.close();
  });

  it('takes the name of the file as text', async () => {
    // a name has no slash, so that no tag ends in it
    const name = `document.title='owned'<img src=x onerror="document.title='owned'">&amp;<!--.off`;
    const file = join(folder, '<script>' + name);
    copyFileSync(join(meshes, 'cactus.off'), file);
    const tab = await open(write(file, '--max', '1'));
    assert.deepEqual(tab.said, []);
    const shown = '<script>' + name;
    assert.equal(await tab.locator('#file').textContent(), shown);
    assert.equal(await tab.title(), `${shown} – constrictions`);
    assert.equal(await tab.locator('img').count(), 0);
    assert.ok(!readFileSync(join(folder, 'page.html'), 'utf8').includes(folder), 'the page tells the folder of the file');
    await tab.close();
  });

  it('obeys its address', async () => {
    write(join(meshes, 'cactus.off'));
    const tab = await open(join(folder, 'page.html'), '#panel=0&parts=0&theme=dark&select=1&view=1,0,0&up=0,1,0');
    assert.ok(!await tab.locator('#panel').isVisible());
    const s = await state(tab);
    assert.equal(s.theme, 'dark');
    assert.equal(s.selected, 1);
    await tab.close();
  });

  it('shows a surface without constrictions', async () => {
    const tab = await open(write(join(meshes, 'cactus.off'), '--max', '0'));
    assert.deepEqual(tab.said, []);
    assert.ok(covered(await pixels(tab)) > 0.1);
    assert.ok(await tab.locator('#empty').isVisible());
    await tab.locator('#level').fill('0');
    assert.ok(covered(await pixels(tab)) > 0.02);
    await tab.close();
  });

  it('draws a large surface simplified, and says so', async () => {
    const file = join(folder, 'dumbbell.off');
    writeFileSync(file, dumbbell(400, 132));
    const tab = await open(write(file, '--seeds', 'triangles', '--no-certify'), '#view=1,0.2,0.3');
    assert.deepEqual(tab.said, []);
    const p = await pixels(tab);
    assert.ok(covered(p) > 0.1);
    assert.ok(count(p, vermillion) > 50, 'there is no curve');
    assert.match(await tab.locator('#numbers').textContent(), /105,600 faces/);
    const {faces} = await state(tab);
    assert.ok(faces > 90000 && faces <= 100000);
    assert.equal(await tab.locator('#note').textContent(),
      `Drawn with ${faces.toLocaleString('en')} faces, simplified. The curves are exact, on the surface of the file.`);
    await tab.locator('#level').fill(await tab.locator('#level').evaluate(input => String(input.max - 1)));
    assert.match(await tab.locator('#status').textContent(), /Level 0 .*52,802 vertices.*drawn on a coarser level/);
    await tab.close();
  });

  it('draws the curves of a simplified surface on that', async () => {
    const file = join(folder, 'rough.off');
    // the neck is not in the middle, where the first two blocks of the simplification meet
    writeFileSync(file, dumbbell(400, 400, 0.004, -0.23));
    const tab = await open(write(file, '--seeds', 'triangles', '--no-certify'));
    // how high above the surface a point is, along the normal of the input there
    const {lifted, exact} = await tab.evaluate(() => {
      const {data, drawn} = window.viewer, {levels_points: p, levels_faces: faces, curve_points, curve_normals} = data.arrays;
      const difference = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
      const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      const height = (x, n) => {
        let best = Infinity;
        for (let f = 0; f < faces.length; f += 3) {
          const [a, b, c] = [0, 1, 2].map(i => difference(p.subarray(3 * faces[f + i], 3 * faces[f + i] + 3), x));
          // the signs of the volumes over the edges say whether the line through x meets the face
          if (Math.abs(a[0]) < 0.1 && Math.abs(a[1]) < 0.1 && Math.abs(a[2]) < 0.1
              && dot(cross(a, b), n) > 0 && dot(cross(b, c), n) > 0 && dot(cross(c, a), n) > 0) {
            const normal = cross(difference(b, a), difference(c, a));
            best = Math.min(best, Math.abs(dot(a, normal) / dot(n, normal)));
          }
        }
        return best;
      };
      const lifted = [], exact = [], points = drawn.points(0);
      for (let i = 0; i < points.length; i += 12) {
        const n = Array.from(curve_normals.subarray(i, i + 3)), length = Math.hypot(...n), unit = n.map(x => x / length);
        lifted.push(height(points.subarray(i, i + 3), unit));
        exact.push(height(curve_points.subarray(i, i + 3), unit));
      }
      return {lifted, exact};
    });
    assert.ok(exact.some(h => h > 1e-4 && h < 1), 'the curve is on the simplified surface anyway');
    const known = lifted.filter(h => h < 1); // of a line along an edge of the surface it is not known
    assert.ok(known.length > 0.8 * lifted.length);
    for (const h of known)
      assert.ok(Math.abs(h - 0.003) < 1e-5, `the curve is ${h} above the surface`);
    await tab.close();
  });
});
