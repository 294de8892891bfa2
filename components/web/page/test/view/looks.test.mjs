// What the view adds to what cameras see, and what it leaves out: outline, background, light, crowds.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';

import * as browser from './browser.mjs';
import * as scenes from './scenes.mjs';

describe('the looks of the view', { skip: browser.without }, () => {
  let opened;
  let tab;
  before(async () => {
    opened = await browser.openView();
    tab = opened.tab;
    await tab.waitForFunction(() => 'view' in window);
  });
  after(async () => opened?.close());

  const show = (scene, eye) => browser.show(tab, scene, eye);
  const colorAt = (x, y) => browser.colorAt(tab, x, y);

  for (const theme of ['dark', 'light']) {
    test(`what is selected has a line around it that is seen on ${theme} ground`, async () => {
      const shade = theme === 'dark' ? 0.05 : 0.95;
      const big = scenes.model(20, [2, 0, 0], scenes.box(0.1, 20, 20), scenes.paint(shade, shade, shade));
      const small = scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(shade, shade, shade));
      await show(scenes.scene([small, big]), scenes.eyeAt(-4));
      // the box is 4 m away minus a half: its left edge is this far from the middle
      const edge = 0.5 - (0.5 / 3.5 / Math.tan(1.05 / 2) / 2) * (240 / 320);
      const row = async () => Promise.all(Array.from({ length: 9 }, (_, i) => colorAt(edge + (i - 4) / 320, 0.5)));
      const before = await row();
      await tab.evaluate(() => window.view.select(10));
      const orange = ([r, g, b]) => r > 180 && r > b + 80 && g > b;
      const after = await row();
      assert.ok(!before.some(orange) && after.some(orange), JSON.stringify([before, after]));
      await tab.evaluate(() => window.view.select(null));
      assert.deepEqual(await row(), before);
    });
  }

  test('the background is that of the theme, unless the world has one', async () => {
    const usual = scenes.scene([]);
    await tab.evaluate(() => window.view.setTheme('dark'));
    await show(usual, scenes.eyeAt(-4));
    const dark = await colorAt(0.5, 0.05);
    await tab.evaluate(() => window.view.setTheme('light'));
    const light = await colorAt(0.5, 0.05);
    assert.ok(dark[0] < 90 && light[0] > 180, `${dark} ${light}`);
    await show({ ...usual, background: { r: 1, g: 0, b: 0, a: 1 } }, scenes.eyeAt(-4));
    assert.deepEqual(await colorAt(0.5, 0.05), [255, 0, 0]);
  });

  test('edges between faces without sun are seen', async () => {
    // the sun is behind the box, whose two faces towards the viewpoint get none of it
    const light = { ...scenes.sun, direction: { x: -1, y: 0, z: -1 } };
    const turned = scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(0.7, 0.7, 0.7));
    turned.pose.orientation = { z: Math.sin(Math.PI / 8), w: Math.cos(Math.PI / 8) };
    await show(scenes.scene([turned], { light: [light], shadows: false }), scenes.eyeAt(-4));
    const [left, right] = [await colorAt(0.42, 0.5), await colorAt(0.58, 0.5)];
    assert.ok(Math.abs(left[0] - right[0]) > 12, `${left} ${right}`);
  });

  test('bodies darken the ground where they stand, and not where they hover', async () => {
    // without a sun, so without its shadows
    const on = (height) => scenes.scene([scenes.ground, scenes.model(10, [0, 0, height + 0.5], scenes.box(1, 1, 1))], { light: [] });
    // on the ground, 5 cm before the foot of the box: 2.45 m ahead of the eye and 1.5 m below it, where it looks 26.6 degrees down
    const eye = { position: [-3, 0, 1.5], orientation: [0, 0.2298, 0, 0.9732] };
    const foot = 0.5 + Math.tan(Math.atan2(1.5, 2.45) - 0.4637) / Math.tan(1.05 / 2) / 2;
    const atFoot = () => colorAt(0.5, foot);
    await show(on(1), eye);
    const [bright] = await atFoot();
    await show(on(0), eye);
    const [dark] = await atFoot();
    assert.ok(dark < bright - 12, `${dark} ${bright}`);
    // the whole ground is not darker
    assert.ok(Math.abs((await colorAt(0.1, 0.9))[0] - bright) < 3);
    // it is cast by what is in the world now
    const moveTo = (z) => tab.evaluate((height) => window.view.applyFrame({
      timeNs: 0n, revision: 0, ids: new Uint32Array([10, 11]),
      poses: new Float32Array([0, 0, height, 0, 0, 0, 1, 0, 0, height, 0, 0, 0, 1]),
    }), z);
    await moveTo(1.5);
    assert.ok(Math.abs((await atFoot())[0] - bright) < 3);
    await moveTo(0.5);
    for (const [off, back] of [['setShadows(false)', 'setShadows(true)'], ['setAsCameras(true)', 'setAsCameras(false)']]) {
      await tab.evaluate(`window.view.${off}`);
      const [without] = await atFoot();
      assert.ok(without > dark + 12, `${off}: ${without} ${dark}`);
      await tab.evaluate(`window.view.${back}`);
    }
    assert.ok(Math.abs((await atFoot())[0] - dark) < 3);
  });

  test('of three thousand spheres few triangles are drawn, and those out of view cast their shadows', async () => {
    const sphere = { type: scenes.type.sphere, sphere: { radius: 0.5 } };
    const models = Array.from({ length: 3000 }, (_, i) =>
      scenes.model(10 + 4 * i, [3 * (i % 60), 3 * (Math.floor(i / 60) - 25), 0.5], sphere, scenes.paint(0.1, 0.2, 0.9)));
    const light = { ...scenes.sun, direction: { x: 1, z: -0.3 } };
    await show(scenes.scene([scenes.ground, ...models], { light: [light] }), { position: [-2, 0.5, 1.5], orientation: [0, 0.2474, 0, 0.9689] });
    const triangles = await tab.evaluate(() => window.view.statistics.triangles);
    console.log(`3,000 spheres: ${triangles} triangles`);
    // each has 2,208
    assert.ok(triangles > 5000 && triangles < (3000 * 2208) / 20, `${triangles} triangles`);
    // the spheres behind the viewpoint shade the ground before it, as the light comes from there
    const low = { position: [1.5, 0, 0.7], orientation: [0, 0.3827, 0, 0.9239] };
    await show(scenes.scene([scenes.ground, ...models], { light: [light] }), low);
    const shaded = await colorAt(0.5, 0.6);
    await tab.evaluate(() => window.view.setShadows(false));
    const bright = await colorAt(0.5, 0.6);
    await tab.evaluate(() => window.view.setShadows(true));
    assert.ok(bright[0] > shaded[0] + 20, `${shaded} ${bright}`);
  });

  test('the page has logged no error', () => assert.deepEqual(opened.errors, []));
});
