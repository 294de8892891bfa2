// The moving-robot tutorial of docs/web.md, step by step as written there: by mouse, by keyboard only, on a phone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, panel, pongsim, repository, until } from './page.mjs';

const world = `${repository}worlds/pong_world.sdf`;

/// Where the robot is, from the outside: x, y [m], and the yaw [rad].
function robot() {
  const { pose } = JSON.parse(pongsim('topic', '-e', '-t', '/world/pong_world/pose/info', '-n', '1', '--json'));
  const { position, orientation } = pose.find(({ name }) => name === 'pong_bot');
  return [position.x ?? 0, position.y ?? 0, 2 * Math.atan2(orientation?.z ?? 0, orientation?.w ?? 1)];
}

const drives = ([x, y], what) => until(robot, ([x2, y2]) => Math.hypot(x2 - x, y2 - y) > 0.3, what);
const turns = ([, , yaw], what) => until(robot, ([, , yaw2]) => Math.abs(yaw2 - yaw) > 0.2, what);
async function stands(what) {
  let before = [Infinity, Infinity];
  await until(() => {
    const now = robot();
    const moved = Math.hypot(now[0] - before[0], now[1] - before[1]);
    before = now;
    return moved;
  }, (moved) => moved < 1e-3, what);
}

/// Presses Tab until something has the focus.
async function tabTo(tab, isThere, what) {
  for (let i = 0; i < 60; ++i) {
    await tab.keyboard.press('Tab');
    if (await tab.evaluate(isThere)) return;
  }
  assert.fail(`Tab does not lead to ${what}`);
}

test('by mouse', async () => {
  const page = await openPage(world, { options: [] });
  const { tab } = page;
  try {
    await tab.getByRole('button', { name: 'Pause' }).waitFor();
    await tab.getByText('Panels ▾').click();
    await tab.getByRole('button', { name: 'Teleop', exact: true }).click();
    let from = robot();
    const pad = await panel(tab, 'Teleop').locator('.joystick').boundingBox();
    const [x, y] = [pad.x + pad.width / 2, pad.y + pad.height / 2];
    await tab.mouse.move(x, y);
    await tab.mouse.down();
    await tab.mouse.move(x, y - 40, { steps: 3 });
    await drives(from, 'the joystick drives it');
    from = robot();
    await tab.mouse.move(x - 40, y, { steps: 3 });
    await turns(from, 'to the left');
    await tab.mouse.up();
    await stands('released, it stands');
    await panel(tab, 'Entity tree').getByText('pong_bot', { exact: true }).dblclick();
    await panel(tab, 'Component inspector').getByText('pong_bot').first().waitFor();
    await tab.getByRole('button', { name: 'Reset', exact: true }).click();
    await until(robot, ([x2, y2]) => Math.hypot(x2, y2) < 0.1, 'it is at the start');
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});

test('by keyboard only', async () => {
  const page = await openPage(world, { options: [] });
  const { tab } = page;
  try {
    await tabTo(tab, () => document.activeElement.textContent.startsWith('Panels'), 'the menu Panels');
    await tab.keyboard.press('Enter');
    await tabTo(tab, () => document.activeElement.textContent === 'Key publisher', 'the Key publisher');
    await tab.keyboard.press('Enter');
    await panel(tab, 'Key publisher').waitFor();
    await tabTo(tab, () => document.activeElement.tagName === 'CANVAS', 'the view');
    let from = robot();
    await tab.keyboard.press('ArrowUp');
    await drives(from, 'it drives');
    from = robot();
    await tab.keyboard.press('ArrowLeft');
    await turns(from, 'it turns');
    await tab.keyboard.press('Space');
    await stands('it stands');
    const eye = () => tab.evaluate(() => location.hash);
    const before = await eye();
    await tabTo(tab, () => document.activeElement.textContent === 'Z', 'the axes');
    await tab.keyboard.press('Enter');
    await until(eye, (hash) => hash !== before, 'the view is from above');
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});

test('on a phone', async () => {
  const page = await openPage(world, { options: [], viewport: { width: 390, height: 800 }, hasTouch: true });
  const { tab } = page;
  try {
    await tab.getByText('Panels ▾').tap();
    await tab.getByRole('button', { name: 'Teleop', exact: true }).tap();
    const view = await tab.locator('#view canvas').boundingBox();
    const pad = await until(() => panel(tab, 'Teleop').locator('.joystick').boundingBox(), (box) => box && box.y + box.height <= 800, 'the joystick is on the screen');
    assert.ok(view.y >= 0 && pad.y >= view.y + view.height, 'below the view');
    const client = await tab.context().newCDPSession(tab);
    const touch = (type, ...touchPoints) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
    const [x, y] = [pad.x + pad.width / 2, pad.y + pad.height / 2];
    let from = robot();
    await touch('touchStart', { x, y });
    await touch('touchMove', { x, y: y - 40 });
    await drives(from, 'the thumb drives it');
    await touch('touchEnd');
    await stands('released, it stands');
    // one finger on the view turns it
    const eye = () => tab.evaluate(() => location.hash);
    const before = await eye();
    await touch('touchStart', { x: 195, y: view.y + view.height / 2 });
    await touch('touchMove', { x: 255, y: view.y + view.height / 2 });
    await touch('touchEnd');
    await until(eye, (hash) => hash !== before, 'the view turns');
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});
