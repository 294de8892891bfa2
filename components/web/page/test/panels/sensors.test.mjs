// Messages of sensors in the panels of a world's `<gui>`; plots compared with what is published.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openPage, openPanel, panel, pongsim, until } from './page.mjs';

const joints = '/world/camera_world/model/arm/joint_state';
let page;
before(async () => (page = await openPage(new URL('camera.sdf', import.meta.url).pathname, { options: [] })));
after(() => page.close());

test('the panels that the world asks for are open, where it says', async () => {
  const { tab } = page;
  await panel(tab, 'Joint position controller').waitFor();
  const titles = await tab.locator('section.panel h2').allTextContents();
  assert.deepEqual(titles.sort(), [
    'Entity tree', 'Front camera', 'Joint position controller', 'Spawn', 'Visualize lidar', 'World control', 'World stats',
  ]);
  assert.equal(await tab.locator('.corner-right h2', { hasText: 'World control' }).count(), 1);
});

test("the image panel has the camera's pixels", async () => {
  const front = panel(page.tab, 'Front camera');
  await front.getByText('64 × 48').waitFor();
  // the camera's scene is static, so all images are equal
  const image = JSON.parse(pongsim('topic', '-e', '-t', '/camera', '-n', '1', '--json'));
  const pixels = Buffer.from(image.data, 'base64');
  assert.equal(pixels.length, 64 * 48 * 3);
  const shown = await front.locator('canvas').evaluate((canvas) => [...canvas.getContext('2d').getImageData(0, 0, 64, 48).data]);
  assert.deepEqual(shown.filter((_, i) => i % 4 < 3), [...pixels]);
  // the pixel in the middle shows the red ball
  const [red, green] = shown.slice(4 * (24 * 64 + 32));
  assert.ok(red > 2 * green, `red ${red}, green ${green}`);
});

test('the lidar sees the ball', async () => {
  await panel(page.tab, 'Visualize lidar').getByText(/90 rays, to 8 m, nearest 1\.6/).waitFor();
});

test('a slider moves a joint, and the plot has the numbers that are published', async () => {
  const { tab } = page;
  const plot = await openPanel(tab, 'Plot');
  await plot.getByLabel('Topic').selectOption(joints);
  await plot.getByLabel('Number').selectOption('joint[shoulder].axis1.position');
  const published = new Map();
  const echo = spawn(process.env.PONGSIM, ['topic', '-e', '-t', joints, '--json'], { stdio: ['ignore', 'pipe', 'inherit'] });
  let rest = '';
  echo.stdout.on('data', (text) => {
    const lines = (rest + text).split('\n');
    rest = lines.pop();
    for (const line of lines) {
      const { header, joint } = JSON.parse(line);
      const time = Number(header.stamp.sec ?? 0) + Number(header.stamp.nsec ?? 0) / 1e9;
      published.set(time.toFixed(9), joint[1].axis1.position ?? 0);
    }
  });
  await plot.getByRole('button', { name: 'Plot', exact: true }).click();
  await until(() => published.size, (size) => size > 0, 'joint states');
  await panel(tab, 'Joint position controller').getByLabel('shoulder, number').fill('0.9');
  await panel(tab, 'Joint position controller').getByLabel('shoulder, number').press('Enter');
  await until(() => [...published.values()].at(-1), (position) => Math.abs(position - 0.9) < 0.05, 'it is there');
  const download = tab.waitForEvent('download');
  await plot.getByRole('button', { name: 'CSV' }).click();
  const rows = readFileSync(await (await download).path(), 'utf8').trim().split('\n').slice(1).map((row) => row.split(',').map(Number));
  echo.kill('SIGINT');
  await once(echo, 'exit');
  const both = rows.filter(([time]) => published.has(time.toFixed(9)));
  assert.ok(both.length > 20, `${both.length} of ${rows.length} rows and ${published.size} messages`);
  for (const [time, value] of both) assert.equal(value, published.get(time.toFixed(9)), `at ${time} s`);
  assert.ok(await plot.locator('.uplot canvas').isVisible());
});

test('the labels of a plot are whole, however large its numbers are', async () => {
  const { tab } = page;
  await panel(tab, 'Plot').getByRole('button', { name: /^Remove/ }).click();
  // records the texts in canvases, and where they begin
  await tab.evaluate(() => {
    window.written = [];
    const { fillText } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
      const { a, e } = this.getTransform();
      const width = this.measureText(text).width;
      window.written.push({ text, left: a * (x - { right: width, center: width / 2 }[this.textAlign] || 0) + e });
      fillText.call(this, text, x, y);
    };
  });
  const plot = panel(tab, 'Plot');
  await plot.getByLabel('Topic').selectOption('/clock');
  // from 0 to a billion in each second
  await plot.getByLabel('Number').selectOption('sim.nsec');
  await plot.getByRole('button', { name: 'Plot', exact: true }).click();
  const labels = await until(() => tab.evaluate(() => window.written.splice(0)), (found) => found.some(({ text }) => text === '1e9'), 'labels');
  for (const { text, left } of labels) assert.ok(left >= 0, `'${text}' begins at ${left}`);
  // the legend has the value
  await until(() => plot.locator('.legend output').textContent(), (text) => Number(text) > 0, 'a value');
});

test('messages of any topic are echoed', async () => {
  const echo = await openPanel(page.tab, 'Topic echo');
  await echo.getByLabel('Topic', { exact: true }).selectOption('/clock');
  await until(() => echo.locator('pre').textContent(), (text) => /"sec"|"nsec"/.test(text), 'a message');
  await echo.getByText(/^\d+(?:\.\d+)? per second$/).waitFor();
});

test('the performance panel has frames, the time of a request, and what arrives', async () => {
  const { tab } = page;
  const performance = await openPanel(tab, 'Performance');
  const row = performance.locator('tr', { has: tab.locator('td', { hasText: /^\/camera$/ }) });
  // images of 64 x 48 pixels with 3 bytes, ten times a simulated second
  await until(() => row.locator('td').nth(2).textContent(), (text) => /kB$/.test(text) && parseFloat(text) > 9, 'images');
  await until(() => tab.locator('#performance-trip').textContent(), (text) => /^\d+ ms$/.test(text), 'an answer');
  await until(() => tab.locator('#performance-work').textContent(), (text) => parseInt(text, 10) > 0, 'a frame');
  await until(() => tab.locator('#performance-frames').textContent(), (text) => /per second/.test(text), 'frames');
  assert.match(await tab.locator('#performance-total').textContent(), /B per second/);
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
