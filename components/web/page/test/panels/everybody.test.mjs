// Accessibility and robustness: keyboard, screen reader, narrow screen, no WebGL, a server that ends.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { choose, openPage, openPanel, panel, pongsim, repository, until } from './page.mjs';

const axe = readFileSync('node_modules/axe-core/axe.min.js', 'utf8');
const world = `${repository}worlds/pong_world.sdf`;
const panels = [
  'Key publisher', 'Teleop', 'Joint position controller', 'Image display', 'Visualize lidar', 'Point cloud', 'Plot', 'Topic echo', 'Topics', 'Publisher',
  'Service', 'Transform control', 'Apply force torque', 'Spawn', 'Lights', 'View', 'Timeline', 'Performance', 'Messages',
];

/// The accessibility violations that axe finds, shortened.
async function faults(tab) {
  // by the debugging protocol, because the page's content security policy allows no further scripts
  await tab.evaluate(axe);
  const { violations } = await tab.evaluate(() => window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'best-practice'] }));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 160)).join('\n  ')}`);
}

let page;
before(async () => (page = await openPage(world)));
after(() => page.close());

test('every panel opens, and axe finds nothing wrong, dark and light', async () => {
  const { tab } = page;
  for (const title of panels) await openPanel(tab, title);
  await panel(tab, 'Entity tree').getByRole('treeitem').first().locator('> .row .name').click();
  assert.deepEqual(await faults(tab), []);
  await tab.getByRole('button', { name: 'Dark or light' }).click();
  assert.equal(await tab.locator('html').getAttribute('data-theme'), 'light');
  assert.deepEqual(await faults(tab), []);
});

test('panels close and fold', async () => {
  const { tab } = page;
  for (const title of panels) await panel(tab, title).getByRole('button', { name: `Close ${title}` }).click();
  assert.equal(await panel(tab, 'Plot').count(), 0);
  const fold = panel(tab, 'World stats').getByRole('button', { name: 'Fold World stats' });
  await fold.click();
  assert.equal(await fold.getAttribute('aria-expanded'), 'false');
  assert.equal(await tab.locator('#stats-sim').isVisible(), false);
  await fold.click();
});

test('the keys are listed', async () => {
  const { tab } = page;
  await tab.locator('body').press('?');
  const help = tab.getByRole('dialog', { name: 'Keys' });
  await help.getByText('Play or pause').waitFor();
  assert.deepEqual(await faults(tab), []);
  await help.getByRole('button', { name: 'Close' }).click();
  await until(() => help.count(), (count) => count === 0, 'it is closed');
});

test('the tree is walked by keys', async () => {
  const { tab } = page;
  const item = panel(tab, 'Entity tree').getByRole('treeitem', { name: /^pong_bot model$/ });
  await item.focus();
  await item.press('ArrowRight');
  await until(() => item.getAttribute('aria-expanded'), (open) => open === 'true', 'it opens');
  await item.press('Enter');
  await until(() => item.getAttribute('aria-selected'), (chosen) => chosen === 'true', 'it is chosen');
});

test('a narrow screen has all below each other, and nothing beside', async () => {
  const { tab } = page;
  await tab.setViewportSize({ width: 390, height: 800 });
  const width = await tab.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `${width} pixels`);
  await panel(tab, 'Entity tree').scrollIntoViewIfNeeded();
  await tab.setViewportSize({ width: 1280, height: 800 });
});

test('panels over the view never cover each other', async () => {
  const { tab } = page;
  for (const width of [1280, 1100, 960, 850]) {
    await tab.setViewportSize({ width, height: 800 });
    const [left, right] = await Promise.all(['World stats', 'World control'].map((title) => panel(tab, title).boundingBox()));
    const isApart = left.x + left.width <= right.x || right.x + right.width <= left.x
      || left.y + left.height <= right.y || right.y + right.height <= left.y;
    assert.ok(isApart, `at ${width} pixels: ${JSON.stringify([left, right])}`);
  }
  await tab.setViewportSize({ width: 1280, height: 800 });
});

test('a small window keeps its view uncovered', async () => {
  const { tab } = page;
  await tab.setViewportSize({ width: 1000, height: 650 });
  const canvas = tab.locator('#view canvas');
  // the view's size follows that of the window
  const view = await until(() => canvas.boundingBox(), (box) => box.width < 700, 'it is smaller');
  assert.ok(view.height > 400, `it is ${view.height} pixels high`);
  for (const title of ['World stats', 'World control']) {
    const over = await panel(tab, title).boundingBox();
    assert.ok(over.y >= view.y + view.height, `${title} at ${over.y}, the view ends at ${view.y + view.height}`);
  }
  await tab.setViewportSize({ width: 1280, height: 800 });
});

test('a shape is placed by keys, and the focus is not lost', async () => {
  const { tab } = page;
  await tab.locator('summary', { hasText: 'Add' }).focus();
  await tab.keyboard.press('Enter');
  await tab.keyboard.press('Tab');
  await tab.keyboard.press('Enter');
  await tab.keyboard.press('Shift+ArrowUp');
  await tab.keyboard.press('ArrowLeft');
  await tab.keyboard.press('Enter');
  await panel(tab, 'Entity tree').getByRole('treeitem', { name: 'box model' }).waitFor();
  assert.equal(await tab.evaluate(() => document.activeElement.textContent), 'Add ▾');
  const { model } = JSON.parse(pongsim('service', '-s', '/world/pong_world/scene/info', '--req', '', '--json'));
  const { x, y } = model.find(({ name }) => name === 'box').pose.position;
  // the viewpoint looks along x; y is that of its target and one step to the left
  assert.ok(Number.isFinite(x) && Math.abs(y - 0.1) < 1e-3, `it is at ${x} ${y}`);
  // a cancelled one gives the focus back, too
  await tab.keyboard.press('Enter');
  await tab.keyboard.press('Tab');
  await tab.keyboard.press('Enter');
  await tab.keyboard.press('Escape');
  assert.equal(await tab.evaluate(() => document.activeElement.textContent), 'Add ▾');
});

test('what pongsim warns of is in the messages', async () => {
  const messages = await openPanel(page.tab, 'Messages');
  pongsim('topic', '-t', '/cmd_vel', '-m', 'ignition.msgs.Twist', '-p', 'linear: {x: 1e300}', '--timeout', '60');
  await messages.locator('li.warning', { hasText: 'cmd_vel' }).waitFor();
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));

test('a browser without WebGL gets everything else, and is told', async () => {
  const other = await openPage(world, { flags: ['--disable-gpu', '--disable-3d-apis'] });
  try {
    await other.tab.getByText('This browser has no WebGL 2').waitFor();
    await panel(other.tab, 'Entity tree').getByRole('treeitem', { name: /^pong_bot model$/ }).waitFor();
    await other.tab.getByRole('button', { name: 'Step' }).click();
    await until(() => other.tab.locator('#stats-iterations').textContent(), (text) => text === '1', 'a step');
  } finally {
    await other.close();
  }
});

test('a world in which nothing can be seen says so', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'pongsim-page-'));
  const file = join(folder, 'unseen.sdf');
  writeFileSync(file, `<sdf version="1.9"><world name="unseen">
    <plugin filename="ignition-gazebo-scene-broadcaster-system" name="ignition::gazebo::systems::SceneBroadcaster"/>
    <model name="ghost"><link name="l"/></model></world></sdf>`);
  const other = await openPage(file);
  try {
    await other.tab.getByText('there is nothing to see').waitFor();
    await other.tab.locator('summary', { hasText: 'Add' }).focus();
    for (const key of ['Enter', 'Tab', 'Enter', 'Enter']) await other.tab.keyboard.press(key);
    await panel(other.tab, 'Entity tree').getByRole('treeitem', { name: 'box model' }).waitFor();
    await other.tab.getByText('there is nothing to see').waitFor({ state: 'hidden' });
  } finally {
    await other.close();
    rmSync(folder, { recursive: true });
  }
});

test('who may only look sees the world, and changes nothing', async () => {
  const other = await openPage(world, { options: ['--paused', '--web-read-only'] });
  const { tab } = other;
  try {
    await tab.getByText('connected, read-only').waitFor();
    await panel(tab, 'Entity tree').getByRole('treeitem', { name: /^pong_bot model$/ }).waitFor();
    await panel(tab, 'World control').getByText('this page can only look').waitFor();
    for (const name of ['Play', 'Step', 'Reset', 'Move']) assert.ok(await tab.getByRole('button', { name, exact: true }).isDisabled(), name);
    const teleop = await openPanel(tab, 'Teleop');
    assert.ok(await teleop.getByRole('button', { name: 'Forward' }).isDisabled());
    await tab.locator('summary', { hasText: 'Add' }).click();
    assert.ok(await tab.getByRole('button', { name: 'box', exact: true }).isDisabled());
    await tab.keyboard.press('Escape');
    // keys are answered with the reason
    await choose(tab, 'sun');
    await tab.locator('body').press('Delete');
    await tab.locator('.toast.error', { hasText: 'this page is read-only' }).waitFor();
    assert.deepEqual(await faults(tab), []);
    assert.deepEqual(other.errors, []);
  } finally {
    await other.close();
  }
});

test('on a phone the scene is first, and Teleop drives by a finger', async () => {
  const other = await openPage(world, { options: [], viewport: { width: 390, height: 800 }, hasTouch: true });
  const { tab } = other;
  try {
    const view = await tab.locator('#view canvas').boundingBox();
    for (const first of await tab.locator('.panel').all()) assert.ok((await first.boundingBox()).y >= view.y + view.height);
    assert.ok(view.y + view.height < 500);
    const teleop = await openPanel(tab, 'Teleop');
    assert.equal(await tab.evaluate(() => document.activeElement.tagName), 'SECTION', 'no field, which would open a keyboard');
    // it is below the view, which stays
    const stick = await teleop.locator('.joystick').boundingBox();
    const stays = await tab.locator('#view canvas').boundingBox();
    assert.ok(stick.y >= stays.y + stays.height && stick.y + stick.height <= 800, JSON.stringify([stick, stays]));
    assert.ok(stays.y >= 0);
    const robot = () => JSON.parse(pongsim('topic', '-e', '-t', '/world/pong_world/pose/info', '-n', '1', '--json'))
      .pose.find(({ name }) => name === 'pong_bot').position;
    const from = robot();
    const touch = (type, x, y) => client.send('Input.dispatchTouchEvent', { type, touchPoints: type === 'touchEnd' ? [] : [{ x, y }] });
    const client = await tab.context().newCDPSession(tab);
    const [x, y] = [stick.x + stick.width / 2, stick.y + stick.height / 2];
    await touch('touchStart', x, y);
    await touch('touchMove', x, y - 40);
    await until(robot, (now) => Math.hypot((now.x ?? 0) - (from.x ?? 0), (now.y ?? 0) - (from.y ?? 0)) > 0.2, 'it drives');
    await touch('touchEnd');
    await until(() => teleop.locator('output').allTextContents(), (values) => values.join() === '0,0', 'it stops');
    assert.deepEqual(other.errors, []);
  } finally {
    await other.close();
  }
});

test('without the token the page asks for it', async () => {
  const token = 'abcdef0123456789abcdef0123456789';
  const other = await openPage(world, { environment: { PONGSIM_WEB_TOKEN: token }, first: '.bar' });
  const { tab, address } = other;
  try {
    await tab.goto(address.replace(/\?.*/, ''));
    await tab.getByText('This server asks for a token').waitFor();
    await tab.getByText('a token is needed').waitFor();
    assert.deepEqual(await faults(tab), []);
    await tab.getByLabel('Address or token').fill('wrong');
    await tab.getByRole('button', { name: 'Connect' }).click();
    await tab.getByText('the token is wrong').waitFor();
    await tab.getByLabel('Address or token').fill(address);
    await tab.getByRole('button', { name: 'Connect' }).click();
    await panel(tab, 'Entity tree').getByRole('treeitem', { name: 'pong_bot model' }).waitFor();
    assert.equal(await tab.getByText('This server asks for a token').isVisible(), false);
  } finally {
    await other.close();
  }
});

test('a server that goes away is told of', async () => {
  const other = await openPage(world);
  const { tab } = other;
  await other.endServer();
  await tab.getByText('connection lost, reconnecting').waitFor();
  await other.close();
});
