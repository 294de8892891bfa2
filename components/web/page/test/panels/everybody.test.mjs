// Accessibility and robustness: keyboard, screen reader, narrow screen, no WebGL, a server that ends.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openPage, openPanel, panel, pongsim, repository, until } from './page.mjs';

const axe = readFileSync('node_modules/axe-core/axe.min.js', 'utf8');
const world = `${repository}worlds/pong_world.sdf`;
const panels = [
  'Key publisher', 'Teleop', 'Joint position controller', 'Image display', 'Visualize lidar', 'Point cloud', 'Plot', 'Topic echo', 'Publisher',
  'Transform control', 'Apply force torque', 'Spawn', 'Lights', 'View', 'Messages',
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

test('who may only look sees the world, and changes nothing', async () => {
  const other = await openPage(world, { options: ['--paused', '--web-read-only'] });
  const { tab } = other;
  try {
    await tab.getByText('connected, read-only').waitFor();
    await panel(tab, 'Entity tree').getByRole('treeitem', { name: /^pong_bot model$/ }).waitFor();
    await tab.getByRole('button', { name: 'Step' }).click();
    await tab.locator('.toast.error', { hasText: 'this page is read-only' }).waitFor();
    assert.deepEqual(other.errors, []);
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
