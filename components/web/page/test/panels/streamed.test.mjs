// Pictures that the server draws: without WebGL, and where the user wants them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, openPanel, panel, repository, until } from './page.mjs';

const world = `${repository}worlds/pong_world.sdf`;
const withoutWebGl = ['--disable-gpu', '--disable-3d-apis'];

/// The picture as text, and how many colours it has.
const look = (tab) => tab.evaluate(() => {
  const canvas = document.querySelector('#view canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  let hash = 0;
  for (let i = 0; i < data.length; i += 4) {
    const colour = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
    if (colours.size < 1000) colours.add(colour);
    hash = (Math.imul(hash, 31) + colour) | 0;
  }
  return { hash, colours: colours.size, width: canvas.width };
});

const shown = (tab) => until(() => look(tab), ({ colours }) => colours > 50, 'a picture');

/// Waits for another picture than this one.
const other = (tab, { hash }, what) => until(() => look(tab), (now) => now.hash !== hash, what);

test('without WebGL the page shows pictures of the server, around which the mouse turns', async () => {
  const page = await openPage(world, { flags: withoutWebGl });
  const { tab } = page;
  try {
    await tab.getByText('This browser has no WebGL 2').waitFor();
    const first = await shown(tab);
    assert.ok(first.width > 300, `${first.width} pixels`);
    const canvas = await tab.locator('#view canvas').boundingBox();
    const [x, y] = [canvas.x + canvas.width / 2, canvas.y + canvas.height / 2];
    await tab.mouse.move(x, y);
    await tab.mouse.down({ button: 'middle' });
    await tab.mouse.move(x + 120, y + 20, { steps: 4 });
    await tab.mouse.up({ button: 'middle' });
    const turned = await other(tab, first, 'it turns');
    await tab.mouse.wheel(0, -300);
    const near = await other(tab, turned, 'it comes nearer');
    await tab.locator('#view canvas').focus();
    await tab.keyboard.press('Shift+ArrowLeft');
    const byKey = await other(tab, near, 'a key turns it');
    await tab.locator('body').press('h');
    await other(tab, byKey, 'the view is reset');
    // the world moves in it
    const before = await look(tab);
    await tab.getByRole('button', { name: 'Play' }).click();
    const teleop = await openPanel(tab, 'Teleop');
    await teleop.getByRole('button', { name: 'Forward' }).click();
    await other(tab, before, 'the robot drives');
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});

test('who may only look gets pictures, too', async () => {
  const page = await openPage(world, { flags: withoutWebGl, options: ['--paused', '--web-read-only'] });
  try {
    const first = await shown(page.tab);
    await page.tab.locator('#view canvas').focus();
    await page.tab.keyboard.press('Shift+ArrowLeft');
    await other(page.tab, first, 'it turns');
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});

test('the user has the server draw, and the browser again', async () => {
  const page = await openPage(world);
  const { tab } = page;
  try {
    await (await openPanel(tab, 'View')).getByLabel('The server draws the picture').click();
    await tab.getByText('The server draws the world').waitFor();
    await shown(tab);
    await until(() => tab.evaluate(() => location.hash), (hash) => hash.includes('picture=server'), 'it is in the address');
    await panel(tab, 'View').getByLabel('The server draws the picture').click();
    await tab.getByText('The server draws the world').waitFor({ state: 'detached' });
    await tab.locator('#view canvas[aria-label^="3D view"]').waitFor();
    assert.ok(!(await tab.evaluate(() => location.hash)).includes('picture='));
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});
