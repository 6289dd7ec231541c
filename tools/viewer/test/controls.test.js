// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of what a user can choose, at the size of a desk and of a phone, light and dark; see pages.js.
import assert from 'node:assert/strict';
import {before, describe, it} from 'node:test';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {count, covered, difference, meshes, open, pixels, settled, state, useBrowser, vermillion, write, yellow}
  from './pages.js';

const desk = {width: 1000, height: 700}, phone = {width: 390, height: 844};
const still = {reducedMotion: 'reduce'}; // flights take no time

// A place of the canvas, with nothing in front of it, where there is a curve, a part between curves, or nothing.
const placeOf = (tab, what) => tab.evaluate(async what => {
  await window.viewer.settled();
  const test = {
    curve: (r, g, b) => r === 0xd5 && g === 0x5e && b === 0,
    part: (r, g, b, a) => a === 255 && r !== 0xd5 && Math.abs(r - g) + Math.abs(g - b) > 30,
    nothing: (r, g, b, a) => a === 0,
  }[what];
  const canvas = document.getElementById('canvas'), gl = canvas.getContext('webgl2');
  const {width, height} = canvas, data = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
  const box = canvas.getBoundingClientRect();
  const margin = what === 'curve' ? 0 : 3, isThere = i => test(...data.subarray(4 * i, 4 * i + 4));
  for (let i = margin * width; i < (height - margin) * width; ++i) {
    const place = [box.left + (i % width + 0.5) / width * box.width,
      box.bottom - (Math.floor(i / width) + 0.5) / height * box.height];
    if ([0, margin, -margin, margin * width, -margin * width].every(step => isThere(i + step))
        && document.elementFromPoint(...place) === canvas)
      return place;
  }
  return null;
}, what);

// The rectangle of what can be seen, if need be after scrolling.
const inView = async (tab, selector) => {
  await tab.locator(selector).scrollIntoViewIfNeeded();
  const box = await tab.locator(selector).boundingBox(), {width, height} = tab.viewportSize();
  assert.ok(box, `${selector} is not there`);
  assert.ok(box.x >= 0 && box.y >= 0 && box.x + box.width <= width + 0.5 && box.y + box.height <= height + 0.5,
    `${selector} is not in view: ${JSON.stringify(box)}`);
  return box;
};
const value = (tab, id, x) => tab.locator(id).fill(String(x));

describe('the controls', () => {
  let page, tab;

  useBrowser();
  before(async () => {
    page = write(join(meshes, 'cactus.off'));
    tab = await open(page, '', desk, still);
  });

  it('opens where more of the curves is seen than from most directions', async () => {
    const other = await open(page, '#panel=0', {width: 500, height: 500});
    const first = count(await pixels(other), vermillion, 60);
    const others = [];
    for (const view of ['1,0,0', '-1,0,0', '0,1,0', '0,-1,0', '0,0,1', '0,0,-1']) {
      await other.evaluate(view => location.hash = `panel=0&view=${view}`, view);
      await settled(other);
      others.push(count(await pixels(other), vermillion, 60));
    }
    await other.close();
    assert.ok(first > 0.8 * Math.max(...others), `${first} pixels of curves at first, ${others} from the axes`);
    assert.ok(others.filter(n => n < first).length >= 4, `${first} pixels of curves at first, ${others} from the axes`);
  });

  it('names what the pointer is on', async () => {
    const hover = tab.locator('#hover');
    const cursor = () => tab.evaluate(() => getComputedStyle(document.getElementById('canvas')).cursor);
    const place = await placeOf(tab, 'curve');
    await tab.mouse.move(...place);
    await hover.filter({hasText: /^Constriction \d+ · neck · length [\d.]+ · prominence [\d.]+$/}).waitFor();
    assert.equal(await cursor(), 'pointer');
    assert.ok((await state(tab)).hovered >= 0);
    await tab.mouse.move(...await placeOf(tab, 'part'));
    await hover.filter({hasText: /^(Part|Constriction) \d+/}).waitFor();
    await tab.mouse.move(...await placeOf(tab, 'nothing'));
    await hover.waitFor({state: 'hidden'});
    assert.equal(await cursor(), 'auto');
    assert.equal((await state(tab)).hovered, -1);
  });

  it('lights up the curve whose row the pointer is on', async () => {
    const before = await pixels(tab);
    await tab.locator('#list button').first().hover();
    assert.equal((await state(tab)).hovered, 0);
    assert.ok(difference(before, await pixels(tab)) > 0);
    await tab.mouse.move(999, 699);
    assert.equal(difference(before, await pixels(tab)), 0);
  });

  it('counts on each chip what the list has of that side', async () => {
    for (const at of ['0', '300', '800']) {
      await value(tab, '#prominence', at);
      const rows = await tab.locator('#list li:visible').count();
      const chips = await tab.locator('#sides .number').allTextContents();
      assert.equal(chips.reduce((sum, n) => sum + Number(n), 0), rows);
      assert.equal(await tab.locator('#curves-tab span').textContent(), String(rows));
    }
    await tab.evaluate(() => location.hash = 'prominence=0.05');
    await settled(tab);
  });

  it('says in words in what curves differ, and what all have in common', async () => {
    assert.match(await tab.locator('#count').textContent(),
      /^3 of \d+ constrictions shown\. All are necks, proved strict\.$/);
    const rows = await tab.locator('#list li:visible .more').allTextContents();
    assert.equal(new Set(rows).size, rows.length, `${rows}`);
    assert.ok(!/complement|object/.test(rows.join()), `${rows}`);
  });

  it('lists the parts with area and volume, and shows one alone', async () => {
    await tab.locator('#parts-tab').click();
    assert.ok(!await tab.locator('#list').isVisible());
    const rows = await tab.locator('#part-list li').allTextContents();
    const {parts} = await state(tab);
    assert.equal(rows.length, parts);
    assert.ok(parts > 2);
    assert.match(rows[0], /^Part 0\d+.*%area [\d.e-]+ · volume [\d.e-]+$/);
    const sum = rows.reduce((s, row) => s + Number(row.match(/area ([\d.e-]+) · volume [\d.e-]+$/)[1]), 0);
    const area = await tab.evaluate(() => window.viewer.data.mesh.area);
    assert.ok(Math.abs(sum - area) < 0.01 * area, `${sum} of ${area}`);

    const before = await pixels(tab);
    const smallest = rows.length - 1;
    await tab.locator('#part-list button').nth(smallest).click();
    await settled(tab);
    assert.equal((await state(tab)).isolated, smallest);
    assert.equal(await tab.locator('#part-list button[aria-pressed=true]').count(), 1);
    await tab.mouse.move(999, 699);
    await tab.evaluate(() => { document.activeElement.blur(); });
    await tab.keyboard.press('r');
    const alone = await pixels(tab);
    assert.ok(covered(alone) < 0.6 * covered(before), 'the other parts are still there');
    assert.ok(count(alone, vermillion) > 0, 'its curve is not there');
    await tab.keyboard.press('Escape');
    assert.equal((await state(tab)).isolated, -1);
    assert.ok(difference(before, await pixels(tab)) < 0.01);
  });

  it('draws the parts apart', async () => {
    await tab.locator('#parts-tab').click();
    const before = covered(await pixels(tab)), box = await tab.evaluate(() => window.viewer.state().position);
    await value(tab, '#apart', 100);
    const s = await state(tab);
    assert.equal(s.apart, 1);
    assert.ok(Math.hypot(...s.position) > Math.hypot(...box), 'what is apart does not fit into the view');
    assert.ok(covered(await pixels(tab)) < before);
    // a curve is where it is drawn
    await tab.mouse.move(...await placeOf(tab, 'curve'));
    await tab.locator('#hover').filter({hasText: /^Constriction/}).waitFor();
    await tab.mouse.move(999, 699);
    await value(tab, '#apart', 0);
    assert.ok(Math.abs(covered(await pixels(tab)) - before) < 0.002);
    await tab.keyboard.press('Escape');
  });

  it('has as many parts as are asked for, cut by the most prominent curves', async () => {
    await tab.locator('#parts-tab').click();
    const slider = tab.locator('#number-of-parts');
    const [least, most] = [Number(await slider.getAttribute('min')), Number(await slider.getAttribute('max'))];
    assert.equal(least, 1);
    for (const n of [1, 2, 3, most]) {
      await slider.fill(String(n));
      const {parts, shown} = await state(tab);
      assert.equal(parts, n);
      assert.deepEqual(shown, shown.map((_, i) => i), 'the shown are not the first');
      assert.equal(await tab.locator('#number-of-parts-value').textContent(), `${n} of ${most}`);
      assert.equal(await tab.locator('#part-list li').count(), n);
      assert.equal(await tab.locator('#parts-tab span').textContent(), String(n));
    }
    // a threshold frees it
    await slider.fill('1');
    await value(tab, '#prominence', 0);
    assert.equal((await state(tab)).parts, most);
    await tab.evaluate(() => location.hash = 'prominence=0.05&list=parts');
    await settled(tab);
  });

  it('cuts the surface open', async () => {
    const before = await pixels(tab);
    await tab.click('#section');
    const cut = await pixels(tab);
    assert.ok(difference(before, cut) > 0.02);
    assert.match(await tab.locator('#section-value').textContent(), /^[xyz] = -?[\d.e-]+$/);
    await tab.click('#section-z');
    assert.match(await tab.locator('#section-value').textContent(), /^z = /);
    await value(tab, '#section-at', 1000);
    const upper = covered(await pixels(tab));
    await tab.click('#section-flip');
    const lower = covered(await pixels(tab));
    assert.ok(Math.min(upper, lower) < 0.01 * Math.max(upper, lower), 'at the end one side is not empty');
    await tab.click('#section');
    assert.ok(!await tab.locator('#section-plane').isVisible());
    assert.equal(difference(before, await pixels(tab)), 0);
  });

  it('has a scale that is right', async () => {
    const {bar, expected} = await tab.evaluate(() => {
      const marks = document.getElementById('marks'), {width, height} = marks;
      const {data} = marks.getContext('2d').getImageData(0, 0, width, height);
      // the longest run of ink in a row is the bar
      let bar = 0;
      for (let y = 0; y < height; ++y)
        for (let x = 0, run = 0; x < width; ++x) {
          run = data[4 * (y * width + x) + 3] > 100 ? run + 1 : 0;
          bar = Math.max(bar, run);
        }
      const {position, target} = window.viewer.state(), {data: page} = window.viewer;
      const length = Number(marks.getAttribute('aria-label').match(/bar is (\S+) units? of the file/)[1]);
      const away = Math.hypot(...position.map((x, i) => x - target[i]));
      const pixels = document.getElementById('canvas').clientHeight / 2 / Math.tan(Math.PI / 12) / away;
      return {bar: bar / width * marks.clientWidth, expected: length / page.radius * pixels};
    });
    assert.ok(expected > 40 && Math.abs(bar - expected) < 3, `${bar} pixels instead of ${expected}`);
  });

  it('keeps the whole in sight when the camera is near', async () => {
    assert.ok(!await tab.locator('#inset').isVisible());
    await tab.evaluate(() => location.hash = 'list=curves');
    await tab.locator('#list button').nth(2).click();
    await settled(tab);
    const box = await inView(tab, '#inset'), stage = await tab.locator('#stage').boundingBox();
    const p = await pixels(tab);
    const inInset = (x, y) => x >= box.x - stage.x && x < box.x - stage.x + box.width
      && y >= box.y - stage.y && y < box.y - stage.y + box.height;
    let n = 0;
    for (let y = 0; y < stage.height; ++y)
      for (let x = 0; x < stage.width; ++x)
        if (inInset(x, y) && p[4 * (Math.floor(stage.height - 1 - y) * stage.width + x) + 3] > 0)
          ++n;
    const share = n / (box.width * box.height);
    assert.ok(share > 0.05 && share < 0.9, `${share} of the inset is covered`);
    await tab.click('#inset');
    await settled(tab);
    assert.ok(!await tab.locator('#inset').isVisible());
    await tab.keyboard.press('Escape');
  });

  it('opens the legend beside the list', async () => {
    const before = await tab.locator('#list').boundingBox();
    await tab.click('#legend summary');
    assert.deepEqual(await tab.locator('#list').boundingBox(), before);
    await inView(tab, '#explained');
    await tab.keyboard.press('Escape');
    assert.ok(!await tab.locator('#explained').isVisible());
  });

  it('marks what has the focus in the colour of the page', async () => {
    await tab.locator('#canvas').click({position: {x: 5, y: 300}});
    await tab.keyboard.press('ArrowDown');
    const {colour, accent} = await tab.evaluate(() => {
      const style = getComputedStyle(document.getElementById('canvas')), probe = document.createElement('i');
      probe.style.color = 'var(--accent)';
      document.body.append(probe);
      const accent = getComputedStyle(probe).color;
      probe.remove();
      return {colour: style.outlineStyle === 'none' ? 'none' : style.outlineColor, accent};
    });
    assert.ok(colour === 'none' || colour === accent, `the frame is ${colour}`);
    await tab.keyboard.press('Escape');
    await tab.keyboard.press('r');
    await settled(tab);
  });

  // What a click downloads: its name and bytes.
  async function saved(id) {
    await tab.click('#save summary');
    const [download] = await Promise.all([tab.waitForEvent('download'), tab.click(id)]);
    assert.ok(!await tab.locator('#save-picture').isVisible(), 'the menu is still open');
    return {name: download.suggestedFilename(), bytes: readFileSync(await download.path())};
  }

  it('saves the picture', async () => {
    const {name, bytes} = await saved('#save-picture');
    assert.equal(name, 'cactus.png');
    assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
    const {width, height} = await tab.locator('#canvas').boundingBox();
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], [width, height]);
    const colours = await tab.evaluate(async url => {
      const image = new Image();
      image.src = url;
      await image.decode();
      const canvas = Object.assign(document.createElement('canvas'), {width: image.width, height: image.height});
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      const {data} = context.getImageData(0, 0, image.width, image.height);
      const {data: corner} = context.getImageData(0, image.height - 76, 210, 76);
      let opaque = 0, curve = 0, ink = 0;
      for (let i = 0; i < data.length; i += 4) {
        opaque += data[i + 3] === 255;
        curve += data[i] === 0xd5 && data[i + 1] === 0x5e && data[i + 2] === 0;
      }
      for (let i = 0; i < corner.length; i += 4)
        ink += corner[i] + corner[i + 1] + corner[i + 2] < 150;
      return {opaque: opaque / (data.length / 4), curve, ink};
    }, `data:image/png;base64,${bytes.toString('base64')}`);
    assert.equal(colours.opaque, 1);
    assert.ok(colours.curve > 100, 'there are no curves');
    assert.ok(colours.ink > 50, 'there is no scale');
  });

  it('saves what is shown as tables', async () => {
    const {shown, parts} = await state(tab), curves = await tab.evaluate(() => window.viewer.data.curves);
    const table = await saved('#save-curves');
    assert.equal(table.name, 'cactus-constrictions.csv');
    const [head, ...rows] = table.bytes.toString().trimEnd().split('\n').map(line => line.split(','));
    assert.equal(rows.length, shown.length);
    rows.forEach((row, i) => {
      const record = Object.fromEntries(head.map((name, j) => [name, row[j]]));
      assert.equal(Number(record.id), shown[i]);
      assert.equal(Number(record.length), curves[shown[i]].length);
      assert.equal(Number(record.centroid_y), curves[shown[i]].centroid[1]);
      assert.equal(record.certificate, 'strict_constriction');
      assert.ok(Number(record.left_part) < parts && record.left_part !== record.right_part);
    });
    const partTable = await saved('#save-parts');
    assert.equal(partTable.name, 'cactus-parts.csv');
    assert.equal(partTable.bytes.toString().trimEnd().split('\n').length, parts + 1);
  });

  it('saves a link that shows the same again', async () => {
    await tab.evaluate(() => location.hash =
      'list=parts&part=1&apart=0.3&section=y,0.1,lower&theme=dark&zoom=1.4&view=1,0.3,0.2');
    await settled(tab);
    await tab.click('#save summary');
    await tab.click('#save-link');
    await tab.locator('#message').filter({hasText: 'address bar'}).waitFor();
    const hash = await tab.evaluate(() => location.hash);
    for (const said of ['part=1', 'apart=0.3', 'section=y,0.1,lower', 'theme=dark', 'list=parts'])
      assert.ok(hash.includes(said), `${hash} does not say ${said}`);
    const again = await open(page, hash, desk, still);
    assert.ok(difference(await pixels(tab), await pixels(again)) < 0.005);
    assert.ok(await again.locator('#part-list').isVisible());
    assert.deepEqual(again.said, []);
    await again.close();
    await tab.close();
  });

  for (const [size, viewport] of Object.entries({desk, phone}))
    for (const colorScheme of ['light', 'dark'])
      it(`can be used at the size of a ${size}, ${colorScheme}`, async () => {
        const touch = viewport === phone && {hasTouch: true, isMobile: true};
        const used = await open(page, '', viewport, {...still, colorScheme, ...touch});
        assert.equal((await state(used)).theme, colorScheme);
        for (const id of ['#parts', '#edges', '#section', '#whole', '#theme', '#save summary', '#marks', '#player',
          '#curves-tab', '#parts-tab'])
          await inView(used, id);
        const first = await pixels(used);

        await used.locator('#section').click();
        for (const id of ['#section-x', '#section-y', '#section-z', '#section-at', '#section-flip'])
          await inView(used, id);
        assert.ok(difference(first, await pixels(used)) > 0.005);
        await used.locator('#section').click();

        await used.locator('#save summary').click();
        for (const id of ['#save-picture', '#save-curves', '#save-parts', '#save-link'])
          await inView(used, id);
        await used.keyboard.press('Escape');

        await used.locator('#parts-tab').click();
        for (const id of ['#number-of-parts', '#apart'])
          await inView(used, id);
        await value(used, '#apart', 60);
        assert.ok(difference(first, await pixels(used)) > 0.005);
        await value(used, '#apart', 0);
        await used.locator('#part-list button').last().click();
        await settled(used);
        assert.ok((await state(used)).isolated > 0);
        await used.locator('#part-list button').last().click();
        await used.locator('#curves-tab').focus();
        await used.keyboard.press('ArrowLeft');
        assert.ok(await used.locator('#part-list').isVisible(), 'arrows do not go from list to list');
        await used.locator('#curves-tab').click();
        await used.locator('#list button').first().click();
        await settled(used);
        await inView(used, '#inset');
        assert.ok(count(await pixels(used), yellow) > 50);
        await used.locator('#legend summary').click();
        await inView(used, '#explained');
        await used.locator('#legend summary').click();

        // all that can be used has a name, and text stands out from its ground
        const {nameless, faint} = await used.evaluate(() => {
          const luminance = colour => {
            const [r, g, b] = colour.match(/[\d.]+/g).map(x => (x / 255) ** 2.2);
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
          };
          const groundOf = e => {
            for (; e; e = e.parentElement)
              if (!/, 0\)$|transparent/.test(getComputedStyle(e).backgroundColor))
                return getComputedStyle(e).backgroundColor;
          };
          const nameless = [], faint = [];
          for (const e of document.querySelectorAll('button, input, summary, canvas, output')) {
            const labels = [...(e.labels ?? [])].map(l => l.textContent).join('').trim();
            const name = e.textContent.trim() || e.getAttribute('aria-label') || labels;
            if (!name)
              nameless.push(e.id);
            if (e.checkVisibility() && e.textContent.trim()) {
              const [x, y] = [luminance(getComputedStyle(e).color), luminance(groundOf(e))];
              if ((Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05) < 4.5)
                faint.push(e.id || e.textContent);
            }
          }
          return {nameless, faint};
        });
        assert.deepEqual(nameless, []);
        assert.deepEqual(faint, []);
        assert.equal(await used.evaluate(() => document.documentElement.scrollWidth), viewport.width);
        assert.deepEqual(used.said, []);
        await used.close();
      });
});
