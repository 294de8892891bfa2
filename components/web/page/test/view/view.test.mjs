// The view in a browser: images, picking, handles, files.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { after, before, beforeEach, describe, test } from 'node:test';

import * as browser from './browser.mjs';
import * as scenes from './scenes.mjs';

// largest allowed differences from the golden images: graphics drivers round differently
const meanLimit = 2;
const shareLimit = 0.01;

describe('the view', { skip: browser.without }, () => {
  let opened;
  let tab;
  before(async () => {
    opened = await browser.openView();
    tab = opened.tab;
    await tab.waitForFunction(() => 'view' in window);
  });
  after(async () => opened?.close());
  beforeEach(async () => {
    await tab.evaluate(() => {
      window.events.length = 0;
      for (const overlay of ['frames', 'joints', 'centres', 'inertia', 'collisions', 'contacts', 'wireframe', 'transparent']) {
        window.view.setOverlay(overlay, false);
      }
      window.view.setLidar('/scan', null);
      window.view.select(null);
      window.view.setTool('select');
      window.view.showGhost(null);
      window.view.follow(null);
    });
  });

  const show = (scene, eye) => browser.show(tab, scene, eye);
  const colorAt = (x, y) => browser.colorAt(tab, x, y);
  const events = () => tab.evaluate(() => window.events);
  const frame = (ids, poses) => tab.evaluate(([i, p]) => window.view.applyFrame({
    timeNs: 0n, revision: 0, ids: new Uint32Array(i), poses: new Float32Array(p),
  }), [ids, poses]);

  /// Waits until the colour of a pixel fulfils a condition.
  async function waitForColor(isWanted, x = 0.5, y = 0.5) {
    let color;
    for (let i = 0; i < 200; ++i) {
      color = await colorAt(x, y);
      if (isWanted(color)) return;
      await tab.evaluate(() => window.drawn());
    }
    assert.fail(`at ${x}, ${y} is ${color}`);
  }

  async function compare(name, isOurs = true) {
    if (isOurs && process.env.PONGSIM_RENEW_GOLDEN) {
      mkdirSync('test/view/golden', { recursive: true });
      writeFileSync(`test/view/golden/${name}.png`, Buffer.from(await tab.evaluate(() => window.screenshotText()), 'base64'));
    }
    const { mean, share } = await tab.evaluate((path) => window.difference(path), `golden/${name}.png`);
    const isSame = mean <= meanLimit && share <= shareLimit;
    if (!isSame && process.env.PONGSIM_KEEP_PICTURES) {
      const picture = Buffer.from(await tab.evaluate(() => window.screenshotText()), 'base64');
      writeFileSync(`${process.env.PONGSIM_KEEP_PICTURES}/${name}.png`, picture);
    }
    assert.ok(isSame, `${name}: mean difference ${mean} of 255, ${100 * share} % of the pixels differ`);
  }

  const isGreen = ([r, g, b]) => g > 60 && g > 2 * r && g > 2 * b;
  const isBlue = ([r, g, b]) => b > 60 && b > 2 * r && b > 2 * g;
  const isRed = ([r, g, b]) => r > 60 && r > 2 * g && r > 2 * b;

  test('everything that cameras see is as in the golden picture', async () => {
    await show(scenes.everything(), { position: [-6, 0, 4], orientation: [0, 0.2474, 0, 0.9689] });
    // the textured square and the hills appear when their files have been loaded
    await waitForColor(isBlue, 0.72, 0.3);
    await waitForColor(([, g, b]) => g > b + 5, 0.45, 0.25);
    await compare('everything');
    assert.deepEqual(await events(), []);
  });

  test("the view shows what the simulator's own camera sees", async () => {
    const scene = JSON.parse(readFileSync('test/view/files/camera_scene.json', 'utf8'));
    await tab.evaluate(() => window.view.setAsCameras(true));
    await show(scene, { position: [-6, 0, 4], orientation: [0, 0.247404, 0, 0.968912] });
    await waitForColor(isBlue, 0.72, 0.3);
    await waitForColor(([, g, b]) => g > b + 5, 0.45, 0.25);
    await compare('camera', false);
    await tab.evaluate(() => window.view.setAsCameras(false));
  });

  test('overlays are as in the golden picture', async () => {
    await show(scenes.scene([scenes.ground, scenes.robot()], { grid: true }), {
      position: [-2, 1.2, 1.6], orientation: [0.06, 0.2, -0.28, 0.93],
    });
    await tab.evaluate(async () => {
      const { view } = window;
      for (const overlay of ['joints', 'centres', 'inertia', 'collisions']) view.setOverlay(overlay, true, 10);
      view.setOverlay('frames', true, 20);
      view.setOverlay('transparent', true, 10);
      view.select(10);
      view.setLidar('/scan', {
        frame: 'model10::base::lidar', angleMin: -1, angleStep: 0.1, count: 21, rangeMin: 0.1, rangeMax: 3,
        ranges: Array.from({ length: 21 }, (_, i) => (i % 5 === 0 ? Infinity : 1 + i / 20)),
      });
      view.setContacts('/contacts', { contact: [{ position: [{ x: -0.5, y: 0.4 }], normal: [{ z: 1 }] }] });
      await window.drawn();
    });
    await compare('overlays');
  });

  for (const file of ['square.obj', 'square.gltf', 'square.glb', 'square.dae']) {
    test(`${file} is shown with its texture the right way round`, async () => {
      await show(scenes.scene([
        scenes.model(10, [0, 0, 0], { type: scenes.type.mesh, mesh: { filename: `/meshes/${file}`, submesh: file === 'square.dae' ? 'low' : '' } }),
      ]), scenes.eyeAt(-2));
      await waitForColor(isGreen, 0.3, 0.5);
      await waitForColor(isBlue, 0.7, 0.5);
      assert.deepEqual(await events(), []);
    });
  }

  test('a mesh without materials has that of its visual, and its scale', async () => {
    const geometry = { type: scenes.type.mesh, mesh: { filename: '/meshes/square.stl', scale: { x: 1, y: 0.1, z: 1 } } };
    await show(scenes.scene([scenes.model(10, [0, 0, 0], geometry, scenes.paint(0.9, 0.05, 0.05))]), scenes.eyeAt(-2));
    await waitForColor(isRed);
    assert.ok(!isRed(await colorAt(0.7, 0.5)));
  });

  test('files that are not there are told of once, and the rest is shown', async () => {
    const lost = (id, filename) => scenes.model(id, [0, 0, 0], { type: scenes.type.mesh, mesh: { filename } });
    const models = [
      lost(10, '/meshes/lost.dae'), lost(20, '/meshes/lost.dae'), lost(30, '/hills.png'),
      scenes.model(40, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(0.9, 0.05, 0.05)),
    ];
    await show(scenes.scene(models), scenes.eyeAt(-3));
    await tab.waitForFunction(() => window.events.length >= 2);
    const texts = (await events()).map(({ problem }) => problem).sort();
    assert.match(texts[0], /'\/hills\.png'.*\.dae, \.stl, \.obj/);
    assert.match(texts[1], /'\/meshes\/lost\.dae'.*there is no/);
    await waitForColor(isRed);
    opened.errors.length = 0;
  });

  test('models move as frames say, and nothing is drawn when nothing moves', async () => {
    const red = scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(0.9, 0.05, 0.05));
    await show(scenes.scene([red]), scenes.eyeAt(-4));
    await waitForColor(isRed);
    await frame([10, 11], [0, 5, 0, 0, 0, 0, 1, 0, 5, 0, 0, 0, 0, 1]);
    await waitForColor((color) => !isRed(color));
    await frame([10, 11], [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]);
    await waitForColor(isRed);
    const drawn = await tab.evaluate(async () => {
      await window.drawn();
      let calls = 0;
      const { requestAnimationFrame: before } = window;
      window.requestAnimationFrame = (next) => (++calls, before(next));
      await new Promise((resolve) => before(() => before(() => before(resolve))));
      window.requestAnimationFrame = before;
      return calls;
    });
    assert.equal(drawn, 0);
  });

  test('a click picks the model under the pointer, and the sky is nothing', async () => {
    await show(scenes.scene([
      scenes.model(10, [0, 1, 0], scenes.box(1, 1, 1), scenes.paint(1, 0, 0)),
      scenes.model(20, [0, -1, 0], scenes.box(1, 1, 1), scenes.paint(0, 1, 0)),
    ]), scenes.eyeAt(-4));
    await tab.mouse.click(110, 120);
    await tab.mouse.click(210, 120);
    await tab.mouse.click(160, 10);
    assert.deepEqual(await events(), [{ pick: 10 }, { pick: 20 }, { pick: null }]);
  });

  test('the pointer turns, pans and zooms, and that picks nothing', async () => {
    await show(scenes.scene([]), scenes.eyeAt(-4));
    const eye = () => tab.evaluate(() => window.view.camera());
    const drag = async (button) => {
      await tab.mouse.move(100, 100);
      await tab.mouse.down({ button });
      await tab.mouse.move(130, 100, { steps: 3 });
      await tab.mouse.up({ button });
    };
    await drag('left');
    const panned = await eye();
    assert.ok(panned.position[1] > 0.1 && Math.abs(panned.orientation[2]) < 1e-9, 'the world follows the pointer');
    await drag('middle');
    const turned = await eye();
    assert.ok(turned.orientation[2] < -0.01);
    await tab.mouse.wheel(0, -200);
    await tab.waitForFunction((before) => window.view.camera().position[0] > before, turned.position[0]);
    assert.deepEqual(await events(), []);
  });

  test('handles move a model: it is shown there, its pose is told, and frames have the last word', async () => {
    const red = scenes.model(10, [0, 0, 0], scenes.box(0.5, 0.5, 0.5), scenes.paint(0.9, 0.05, 0.05));
    await show(scenes.scene([red]), scenes.eyeAt(-4));
    await tab.evaluate(async () => {
      window.view.select(10);
      window.view.setTool('move');
      await window.drawn();
    });
    // seen along x, the arrow along y points to the left
    await tab.mouse.move(135, 120);
    await tab.evaluate(() => window.drawn());
    await tab.mouse.down();
    await tab.mouse.move(75, 120, { steps: 5 });
    const during = await events();
    assert.ok(during.length > 0 && during.every((event) => event.move === 10 && event.during));
    await tab.mouse.up();
    const last = (await events()).at(-1);
    assert.equal(last.during, false);
    const [x, y, z] = last.pose.position;
    assert.ok(y > 0.3 && Math.abs(x) < 1e-6 && Math.abs(z) < 1e-6, `it is at ${x} ${y} ${z}`);
    assert.ok(!(await events()).some((event) => 'pick' in event));
    await tab.evaluate(() => window.view.setTool('select'));
    await waitForColor((color) => !isRed(color));
    await frame([10, 11], [0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]);
    await waitForColor(isRed);
  });

  test('with Control handles stop at whole metres', async () => {
    const red = scenes.model(10, [0, 0.3, 0], scenes.box(0.5, 0.5, 0.5), scenes.paint(0.9, 0.05, 0.05));
    await show(scenes.scene([red]), scenes.eyeAt(-4, 0.3));
    await tab.evaluate(async () => {
      window.view.select(10);
      window.view.setTool('move');
      await window.drawn();
    });
    await tab.keyboard.down('Control');
    await tab.mouse.move(135, 120);
    await tab.evaluate(() => window.drawn());
    await tab.mouse.down();
    await tab.mouse.move(75, 120, { steps: 5 });
    await tab.mouse.up();
    await tab.keyboard.up('Control');
    assert.equal((await events()).at(-1).pose.position[1], 1);
  });

  test('a ghost stands where the pointer is until a click or Escape', async () => {
    await show(scenes.scene([scenes.ground]), { position: [0, 0, 10], orientation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] });
    const wanted = { link: [{ visual: [{ geometry: scenes.box(1, 1, 1) }] }] };
    await tab.evaluate((message) => window.view.showGhost(message), wanted);
    await tab.mouse.move(160, 120);
    await tab.mouse.click(160, 120);
    const [{ place }] = await events();
    assert.ok(Math.hypot(place.position[0], place.position[1]) < 0.2 && Math.abs(place.position[2] - 0.5) < 1e-6,
      `it is at ${place.position}`);
    await tab.evaluate((message) => window.view.showGhost(message), wanted);
    await tab.keyboard.press('Escape');
    assert.deepEqual((await events()).at(-1), { place: null });
    await tab.mouse.click(160, 120);
    assert.deepEqual((await events()).at(-1), { pick: 9100 });
  });

  test('shadows are there and can be switched off', async () => {
    // the light shines towards -y, so the shadow is to the right of the box in the view from above
    const light = { ...scenes.sun, direction: { y: -1, z: -1 } };
    const above = { position: [0, -1, 6], orientation: [0, Math.SQRT1_2, 0, Math.SQRT1_2] };
    const models = [scenes.ground, scenes.model(10, [0, 0, 0.5], scenes.box(1, 1, 1), scenes.paint(0.9, 0.05, 0.05))];
    await show(scenes.scene(models, { light: [light] }), above);
    await waitForColor(([r]) => r < 140);
    await tab.evaluate(() => window.view.setShadows(false));
    await waitForColor(([r]) => r > 170);
    await tab.evaluate(() => window.view.setShadows(true));
    await waitForColor(([r]) => r < 140);
    await show(scenes.scene(models, { light: [light], shadows: false }), above);
    await waitForColor(([r]) => r > 170);
  });

  test('wireframe and transparent are of the model that they are asked for', async () => {
    await show(scenes.scene([
      scenes.model(10, [0, 1, 0], scenes.box(1, 1, 1), scenes.paint(0.9, 0.05, 0.05)),
      scenes.model(20, [0, -1, 0], scenes.box(1, 1, 1), scenes.paint(0.05, 0.8, 0.05)),
    ]), scenes.eyeAt(-4));
    const [left, right] = [0.36, 0.64];
    await waitForColor(isRed, left, 0.47);
    const red = await colorAt(left, 0.47);
    await tab.evaluate(() => window.view.setOverlay('transparent', true, 10));
    await waitForColor(([r, g]) => g > red[1] + 30 && r > g, left, 0.47);
    await tab.evaluate(() => window.view.setOverlay('transparent', false, 10));
    await tab.evaluate(() => window.view.setOverlay('wireframe', true, 10));
    await waitForColor(([r, g, b]) => r > 100 && Math.abs(r - g) < 10 && Math.abs(g - b) < 10, left, 0.47);
    await waitForColor(isGreen, right, 0.47);
    await tab.evaluate(() => window.view.setOverlay('wireframe', false));
    await waitForColor(isRed, left, 0.47);
  });

  test('a point cloud is where its sensor is, in its colours', async () => {
    await show(scenes.scene([scenes.model(10, [0, 0, 0], scenes.box(0.1, 0.1, 0.1), scenes.paint(1, 0, 0), {
      sensor: [{ id: 16, name: 'eye', pose: { position: { y: 0.5 }, orientation: { w: 1 } } }],
    })]), scenes.eyeAt(-4));
    await tab.evaluate(() => {
      // a wall of blue points, 1 m wide
      const points = Array.from({ length: 10_000 }, (_, i) => [0, (i % 100) / 100 - 0.5, Math.floor(i / 100) / 100 - 0.5]);
      const data = new DataView(new ArrayBuffer(points.length * 16));
      points.forEach((point, i) => {
        point.forEach((value, k) => data.setFloat32(16 * i + 4 * k, value, true));
        data.setUint32(16 * i + 12, 0x0000ff, true);
      });
      const field = ['x', 'y', 'z', 'rgb'].map((name, k) => ({ name, offset: 4 * k, datatype: 6, count: 1 }));
      window.view.setPointCloud('/points', {
        header: { data: [{ key: 'frame_id', value: ['model10::link::eye'] }] },
        field, pointStep: 16, width: points.length, height: 1, data: new Uint8Array(data.buffer),
      });
    });
    await waitForColor(isBlue, 0.4, 0.45);
    assert.ok(!isBlue(await colorAt(0.6, 0.45)));
    await tab.evaluate(() => window.view.setPointCloud('/points', null));
    await waitForColor((color) => !isBlue(color), 0.4, 0.45);
  });

  test('the keys of the view turn it and go nearer', async () => {
    await show(scenes.scene([]), scenes.eyeAt(-4));
    const eye = () => tab.evaluate(() => window.view.camera());
    await tab.focus('canvas');
    await tab.keyboard.press('+');
    assert.ok((await eye()).position[0] > -4);
    await tab.keyboard.press('Shift+ArrowRight');
    assert.ok((await eye()).orientation[2] < -0.01);
    const before = await eye();
    await tab.keyboard.press('ArrowRight');
    assert.deepEqual(await eye(), before, 'arrows are for driving');
  });

  test('the eye follows, looks from sides, and sees all of what it looks at', async () => {
    await show(scenes.scene([scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(1, 0, 0))]), scenes.eyeAt(-4));
    await tab.evaluate(() => window.view.follow(10));
    await frame([10, 11], [0, 7, 0, 0, 0, 0, 1, 0, 7, 0, 0, 0, 0, 1]);
    await tab.waitForFunction(() => Math.abs(window.view.camera().position[1] - 7) < 1e-3);
    await waitForColor(isRed);
    await tab.evaluate(() => window.view.lookFrom('top'));
    assert.ok((await tab.evaluate(() => window.view.camera())).position[2] > 3);
    await waitForColor(isRed);
    await tab.evaluate(() => window.view.lookAt(10));
    await waitForColor(isRed);
    assert.ok(!isRed(await colorAt(0.02, 0.02)));
  });

  test('it turns around what it follows, wherever the pointer is, and zooms to it', async () => {
    const wall = scenes.model(20, [30, 0, 0], scenes.box(1, 100, 100), scenes.paint(0, 1, 0));
    const robot = scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(1, 0, 0));
    await show(scenes.scene([robot, wall]), scenes.eyeAt(-4));
    await tab.evaluate(() => window.view.follow(10));
    await waitForColor(isRed);
    // from a point of the wall, beside the robot
    await tab.mouse.move(280, 120);
    await tab.mouse.down({ button: 'middle' });
    await tab.mouse.move(80, 120, { steps: 5 });
    await tab.mouse.up({ button: 'middle' });
    await waitForColor(isRed);
    const near = await tab.evaluate(() => Math.hypot(...window.view.camera().position));
    assert.ok(near < 11, `${near} m away`);
    await tab.mouse.move(20, 20);
    await tab.mouse.wheel(0, -300);
    await tab.waitForFunction((before) => Math.hypot(...window.view.camera().position) < before - 0.1, near);
    await waitForColor(isRed);
  });

  test('a new size is drawn at once, so that the picture never goes away', async () => {
    await show(scenes.scene([scenes.model(10, [0, 0, 0], scenes.box(1, 1, 1), scenes.paint(1, 0, 0))]), scenes.eyeAt(-4));
    await waitForColor(isRed);
    // this observer runs after the view's, before the browser shows the page
    const middles = await tab.evaluate(async () => {
      const place = document.getElementById('view');
      const read = () => {
        const { canvas } = window.view;
        const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
        context.drawImage(canvas, 0, 0);
        return [...context.getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data];
      };
      const found = [];
      for (const width of [300, 280, 260]) {
        const sized = new Promise((resolve) => {
          const observer = new ResizeObserver(() => {
            if (place.clientWidth !== width) return;
            observer.disconnect();
            resolve(read());
          });
          observer.observe(place);
        });
        place.style.width = `${width}px`;
        found.push(await sized);
      }
      place.style.width = '';
      return found;
    });
    for (const color of middles) assert.ok(isRed(color), String(color));
  });

  test('a trail is where a model has been', async () => {
    await show(scenes.scene([scenes.model(10, [0, 5, 0], scenes.box(0.1, 0.1, 0.1), scenes.paint(1, 0, 0))]), scenes.eyeAt(-4));
    const before = await colorAt();
    await tab.evaluate(() => window.view.setTrail(10, true));
    for (const y of [3, 1, -1, -3]) {
      await frame([10, 11], [0, y, 0, 0, 0, 0, 1, 0, y, 0, 0, 0, 0, 1]);
      await tab.evaluate(() => window.drawn());
    }
    await waitForColor((color) => color.some((value, i) => Math.abs(value - before[i]) > 30), 0.5, 0.5);
    const isGone = (color) => color.every((value, i) => Math.abs(value - before[i]) < 5);
    await tab.evaluate(() => window.view.setTrail(10, false));
    await waitForColor(isGone);
    // removing an entity removes its trail
    await tab.evaluate(() => window.view.setTrail(10, true));
    for (const y of [-3, 3]) {
      await frame([10, 11], [0, y, 0, 0, 0, 0, 1, 0, y, 0, 0, 0, 0, 1]);
      await tab.evaluate(() => window.drawn());
    }
    await waitForColor((color) => !isGone(color));
    await tab.evaluate((scene) => window.view.setScene(scene), scenes.scene([]));
    await waitForColor(isGone);
  });

  test('a screenshot is a PNG of the size of the view, a video a WebM with pictures in it', async () => {
    await show(scenes.scene([scenes.robot()]), scenes.eyeAt(-4));
    const [png, webm, ms] = await tab.evaluate(async () => {
      const head = async (blob) => [...new Uint8Array(await blob.arrayBuffer()).slice(0, 24)];
      const screenshot = await head(await window.view.screenshot());
      window.view.startVideo();
      for (let i = 0; i < 20; ++i) await window.drawn();
      const video = await window.view.stopVideo();
      const bytes = new Uint8Array(await video.arrayBuffer());
      const duration = bytes.findIndex((byte, i) => byte === 0x44 && bytes[i + 1] === 0x89 && bytes[i + 2] === 0x88);
      const ms = duration < 0 ? NaN : new DataView(bytes.buffer).getFloat64(duration + 3);
      return [screenshot, [...(await head(video)), video.size], ms];
    });
    assert.ok(ms > 100 && ms < 60_000, `it is ${ms} ms long`);
    assert.deepEqual(png.slice(0, 8), [0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);
    assert.deepEqual(png.slice(16, 24), [0, 0, 1, 64, 0, 0, 0, 240]);
    assert.deepEqual(webm.slice(0, 4), [0x1a, 0x45, 0xdf, 0xa3]);
    assert.ok(webm.at(-1) > 500);
  });

  test('a thousand models that move are drawn in a few goes', async () => {
    const models = Array.from({ length: 1000 }, (_, i) =>
      scenes.model(10 + 4 * i, [i % 40, Math.floor(i / 40), 0], scenes.box(0.3, 0.3, 0.3), scenes.paint(i / 1000, 0.5, 0.5)));
    await show(scenes.scene(models), { position: [-10, 12, 10], orientation: [0, 0.2474, 0, 0.9689] });
    const { calls, cost } = await tab.evaluate(async () => {
      const ids = new Uint32Array(2000);
      const poses = new Float32Array(14000);
      for (let i = 0; i < 2000; ++i) {
        ids[i] = 10 + 4 * (i >> 1) + (i & 1);
        poses.set([(i >> 1) % 40, Math.floor((i >> 1) / 40), 0.5, 0, 0, 0, 1], 7 * i);
      }
      let cost = 0;
      let calls = 0;
      for (let k = 0; k < 10; ++k) {
        const begin = performance.now();
        window.view.applyFrame({ timeNs: 0n, revision: 0, ids, poses });
        cost += performance.now() - begin;
        await window.drawn();
        calls = window.view.statistics.drawCalls;
      }
      return { calls, cost: cost / 10 };
    });
    console.log(`1,000 models: ${calls} draw calls, ${cost.toFixed(2)} ms to take a frame of poses`);
    assert.ok(calls <= 10, `${calls} draw calls`);
  });

  test('the page has logged no error', () => assert.deepEqual(opened.errors, []));
});

test('without WebGL the view says so', { skip: browser.without }, async () => {
  const opened = await browser.openView(['--disable-3d-apis']);
  try {
    const deadline = Date.now() + 20_000;
    while (opened.errors.length === 0 && Date.now() < deadline) await opened.tab.evaluate(() => new Promise((r) => setTimeout(r, 20)));
    assert.match(opened.errors.join('\n'), /WebGL/);
  } finally {
    await opened.close();
  }
});
