// The layout of the page: panels move, docks have sizes; both are saved, and with the viewpoint they are in the address.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, openPanel, panel, repository, until } from './page.mjs';

let page;
before(async () => (page = await openPage(`${repository}worlds/pong_world.sdf`)));
after(() => page.close());

const dockOf = (tab, title) => panel(tab, title).evaluate((frame) => frame.parentElement.className);
const widthOf = (tab, dock) => tab.locator(`.dock.${dock}`).evaluate((element) => element.clientWidth);
const hash = (tab) => tab.evaluate(() => decodeURIComponent(location.hash.replaceAll('+', ' ')));
const viewOf = async (tab) => /view=([^&]*)/.exec(await hash(tab))?.[1];

async function assertAsArranged(tab, view) {
  await panel(tab, 'Topic echo').waitFor();
  assert.match(await dockOf(tab, 'Entity tree'), /corner-right/);
  assert.match(await dockOf(tab, 'Topic echo'), /left/);
  assert.equal(await panel(tab, 'World stats').getByRole('button', { name: 'Fold World stats' }).getAttribute('aria-expanded'), 'false');
  assert.equal(await panel(tab, 'Topic echo').getByLabel('Topic', { exact: true }).inputValue(), '/clock');
  assert.equal(await panel(tab, 'Plot').locator('.legend li').count(), 1);
  assert.equal(await widthOf(tab, 'right'), 370);
  if (!view) return;
  // the next change of the layout writes the address anew, with the viewpoint that the view has
  await panel(tab, 'World control').getByRole('button', { name: 'Fold' }).click();
  await until(() => hash(tab), (text) => text.includes('"World control","place":"corner-left","isFolded":true'), 'the address');
  assert.equal(await viewOf(tab), view);
  await panel(tab, 'World control').getByRole('button', { name: 'Fold' }).click();
  await until(() => hash(tab), (text) => !text.includes('"World control","place":"corner-left","isFolded":true'), 'the address');
}

test('panels move, docks have sizes, and the address tells all of it', async () => {
  const { tab } = page;
  await panel(tab, 'Entity tree').getByRole('button', { name: 'Move Entity tree over the view' }).click();
  const line = tab.getByRole('separator', { name: 'Size of the panels on the right' });
  await line.focus();
  await line.press('ArrowLeft');
  const box = await line.boundingBox();
  await tab.mouse.move(box.x + 2, box.y + 200);
  await tab.mouse.down();
  await tab.mouse.move(box.x + 2 - 20, box.y + 200, { steps: 3 });
  await tab.mouse.up();
  await panel(tab, 'World stats').getByRole('button', { name: 'Fold World stats' }).click();
  const echo = await openPanel(tab, 'Topic echo');
  await echo.getByLabel('Topic', { exact: true }).selectOption('/clock');
  for (const to of ['to the right', 'over the view', 'to the left over the view', 'to the left']) {
    await echo.getByRole('button', { name: `Move Topic echo ${to}`, exact: true }).click();
  }
  const plot = await openPanel(tab, 'Plot');
  await plot.getByLabel('Topic').selectOption('/world/pong_world/stats');
  await plot.getByLabel('Number').selectOption('real_time_factor');
  await plot.getByRole('button', { name: 'Plot', exact: true }).click();
  const before = await viewOf(tab);
  const view = await tab.locator('#view canvas').boundingBox();
  await tab.mouse.move(view.x + 100, view.y + 100);
  await tab.mouse.wheel(0, -200);
  await until(() => hash(tab), (text) => text.includes('real_time_factor') && text.includes('Topic echo'), 'the address');
  await until(() => viewOf(tab), (now) => now && now !== before, 'the viewpoint');
  await assertAsArranged(tab, await viewOf(tab));
});

test('a reload, and whoever gets the address, sees the same', async () => {
  const { tab } = page;
  const view = await viewOf(tab);
  await tab.reload();
  await assertAsArranged(tab, view);
  // a browser that knows nothing
  const context = await tab.context().browser().newContext({ viewport: { width: 1280, height: 800 } });
  const other = await context.newPage();
  await other.goto(tab.url());
  await assertAsArranged(other, view);
  await context.close();
});

test('the layout of a world is there again without its address', async () => {
  const { tab } = page;
  await tab.goto('about:blank');
  await tab.goto(page.address);
  await assertAsArranged(tab);
});

test('the panels are again those that the world asks for, on demand', async () => {
  const { tab } = page;
  await tab.locator('summary', { hasText: 'Panels' }).click();
  await tab.getByRole('button', { name: 'As the world asks for' }).click();
  const isUsual = async () => {
    const titles = await tab.locator('section.panel h2').allTextContents();
    return titles.sort().join() === 'Component inspector,Entity tree,World control,World stats';
  };
  await until(isUsual, (is) => is, 'the usual panels');
  assert.match(await dockOf(tab, 'Entity tree'), /right/);
  assert.equal(await widthOf(tab, 'right'), 330);
  await tab.goto('about:blank');
  await tab.goto(page.address);
  await panel(tab, 'Entity tree').waitFor();
  assert.ok(await isUsual());
});

test('panels of one side are tabs, by mouse and by keys, also after a reload', async () => {
  const { tab } = page;
  const tree = panel(tab, 'Entity tree');
  const inspector = panel(tab, 'Component inspector');
  await tree.getByRole('button', { name: 'Show the panels of this side as tabs' }).click();
  const isSeen = async (seen, hidden) => {
    await seen.waitFor();
    assert.equal(await hidden.isVisible(), false);
  };
  await isSeen(tree, inspector);
  await tab.getByRole('tab', { name: 'Component inspector' }).click();
  await isSeen(inspector, tree);
  await tab.getByRole('tab', { name: 'Component inspector' }).press('ArrowLeft');
  await isSeen(tree, inspector);
  await tab.keyboard.press('ArrowRight');
  await isSeen(inspector, tree);
  await until(() => hash(tab), (text) => text.includes('"tabs":{"right":1}'), 'the address');
  await tab.reload();
  await isSeen(inspector, tree);
  // a panel that opens there is shown, and with the last but one there are no tabs
  await inspector.getByRole('button', { name: 'Close Component inspector' }).click();
  await tree.waitFor();
  assert.equal(await tab.getByRole('tab').count(), 0);
});

test('rubbish in the address is no harm', async () => {
  const { tab } = page;
  await tab.goto('about:blank');
  await tab.goto(`${page.address}#world=pong_world&view=1,2,x&panels=%7B"panels":[7,{"id":"Nothing","title":"t","place":"left"}]%7D`);
  await tab.locator('.bar').waitFor();
  await openPanel(tab, 'Entity tree');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
