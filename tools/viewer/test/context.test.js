// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of what the page does when the browser takes its graphics away, has none at first, or changes the window; see
// pages.js.
import assert from 'node:assert/strict';
import {before, describe, it} from 'node:test';
import {join} from 'node:path';
import {covered, difference, meshes, open, pixels, pixelsNow, settled, useBrowser, write} from './pages.js';

// What the browser and three.js themselves say when a context comes or goes is no error of the page.
const errors = tab => tab.said.filter(text => !/^log: THREE|CONTEXT_LOST_WEBGL/.test(text));

const lose = tab => tab.evaluate(() => new Promise(told => {
  const canvas = document.getElementById('canvas');
  canvas.addEventListener('webglcontextlost', told, {once: true});
  window.loseContext = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
  window.loseContext.loseContext();
}));
const restore = tab => tab.evaluate(() => new Promise(told => {
  document.getElementById('canvas').addEventListener('webglcontextrestored', told, {once: true});
  window.loseContext.restoreContext();
}));

// The pixels that the page draws by itself, within two frames.
const drawn = async tab => {
  await tab.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
  return pixelsNow(tab);
};

// The pages of these tests are changed before their own scripts run: here `when(context, lose)` is called as soon as
// the page has the context of its canvas.
const losing = when => `{
  const {getContext} = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function(...what) {
    const context = getContext.apply(this, what);
    if (this.id === 'canvas' && context && !window.loseContext) {
      window.loseContext = context.getExtension('WEBGL_lose_context');
      (${when})(context, () => window.loseContext.loseContext());
    }
    return context;
  };
}`;

describe('the graphics of the page', () => {
  const lost = /^The browser has lost its graphics/;
  let page, whole;

  useBrowser();
  before(async () => {
    page = write(join(meshes, 'cactus.off'));
    const tab = await open(page);
    whole = await pixels(tab);
    assert.ok(covered(whole) > 0.1);
    await tab.close();
  });

  it('are drawn again when they were lost and are back, and the page says so meanwhile', async () => {
    const tab = await open(page), failure = tab.locator('#failure'), save = tab.locator('#save-picture');
    await lose(tab);
    assert.match(await failure.textContent(), lost);
    assert.ok(await failure.isVisible());
    assert.ok(await save.isDisabled());
    await settled(tab);
    await restore(tab);
    assert.ok(!await failure.isVisible());
    assert.ok(await save.isEnabled());
    assert.equal(difference(whole, await drawn(tab)), 0);
    await tab.click('#parts');
    const grey = await drawn(tab);
    assert.ok(difference(whole, grey) > 0.05, 'it does not follow the buttons any more');
    await lose(tab);
    await tab.click('#parts');
    await restore(tab);
    assert.equal(difference(whole, await drawn(tab)), 0, 'it does not show what was chosen meanwhile');
    assert.deepEqual(errors(tab), []);
    await tab.close();
  });

  for (const [moment, when] of [
    ['before the first picture', (context, lose) => requestAnimationFrame(lose)],
    ['as soon as they are there', (context, lose) => lose()],
    ['while three.js looks at them', (context, lose) => {
      context.getShaderPrecisionFormat = (...what) => {
        delete context.getShaderPrecisionFormat;
        lose();
        return context.getShaderPrecisionFormat(...what);
      };
    }],
  ])
    it(`are drawn when they were lost ${moment}, and are back`, async () => {
      const tab = await open(page, '', undefined, {}, losing(when));
      await tab.waitForFunction(() => window.loseContext && document.getElementById('failure').textContent);
      assert.match(await tab.locator('#failure').textContent(), lost);
      await restore(tab);
      await tab.locator('#failure').waitFor({state: 'hidden'});
      assert.equal(difference(whole, await drawn(tab)), 0);
      assert.deepEqual(errors(tab), []);
      await tab.close();
    });

  it('may be missing at first: the page says so, and draws once there are some', async () => {
    const tab = await open(page, '', undefined, {}, () => {
      const {getContext} = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function(kind, ...what) {
        return kind.startsWith('webgl') && !window.hasGraphics ? null : getContext.call(this, kind, ...what);
      };
    });
    const failure = tab.locator('#failure');
    assert.match(await failure.textContent(), /^The browser has no graphics to draw the surface with/);
    assert.ok(await failure.isVisible());
    assert.ok(await tab.locator('#save-picture').isDisabled());
    assert.equal(await tab.locator('#list li:visible').count(), 3);
    await tab.locator('#list button').first().click();
    await tab.keyboard.press('Escape');
    await tab.hover('h1');
    await tab.evaluate(() => window.hasGraphics = true);
    await failure.waitFor({state: 'hidden'});
    assert.ok(await tab.locator('#save-picture').isEnabled());
    assert.equal(difference(whole, await drawn(tab)), 0);
    assert.deepEqual(errors(tab), []);
    await tab.close();
  });

  it('are never empty while the window changes its size', async () => {
    const tab = await open(page);
    // this observer is called after that of the page, when the frame is about to be shown
    await tab.evaluate(() => {
      window.empty = window.frames = 0;
      const canvas = document.getElementById('canvas'), gl = canvas.getContext('webgl2');
      new ResizeObserver(() => {
        const row = new Uint8Array(4 * canvas.width);
        gl.readPixels(0, Math.floor(canvas.height / 2), canvas.width, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
        ++window.frames;
        window.empty += row.every(x => x === 0);
      }).observe(canvas);
    });
    for (const height of [480, 520, 500]) {
      await tab.setViewportSize({width: 800, height});
      await settled(tab);
    }
    assert.ok(await tab.evaluate(() => window.frames) >= 3);
    assert.equal(await tab.evaluate(() => window.empty), 0);
    await tab.close();
  });
});
