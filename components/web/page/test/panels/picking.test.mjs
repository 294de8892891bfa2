// A model is selected by a click in the view, and dragged by its handles.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, openPanel, panel, shownPose, until } from './page.mjs';

let page;
before(async () => {
  page = await openPage(new URL('camera.sdf', import.meta.url).pathname);
  await openPanel(page.tab, 'Component inspector');
});
after(() => page.close());

const ball = () => panel(page.tab, 'Entity tree').getByRole('treeitem', { name: 'ball model' });

async function middle() {
  const box = await page.tab.locator('#view canvas').first().boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2, height: box.height };
}

test('a click in the view chooses what is there', async () => {
  const { tab } = page;
  await choose(tab, 'ball');
  await tab.locator('body').press('f');
  await choose(tab, 'eye');
  const { x, y } = await middle();
  // repeated, because the ball is in the middle only after the next frame has been drawn
  await until(async () => {
    await tab.mouse.click(x, y);
    return ball().getAttribute('aria-selected');
  }, (selected) => selected === 'true', 'the ball is picked');
});

test('its handle along y drags it to the left', async () => {
  const { tab } = page;
  await until(() => shownPose(tab), ([, y]) => y === 0, 'where it was');
  await tab.locator('body').press('t');
  const { x, y, height } = await middle();
  await tab.mouse.move(x - 0.1 * height, y);
  await tab.mouse.down();
  await tab.mouse.move(x - 0.3 * height, y, { steps: 5 });
  await tab.mouse.up();
  const [px, py, pz] = await until(() => shownPose(tab), (pose) => pose[1] > 0.1, 'it is dragged');
  assert.ok(Math.abs(px - 2) < 0.01 && Math.abs(pz - 0.5) < 0.01, `it is at ${px} ${py} ${pz}`);
});

test('a copy is pasted where the view is clicked', async () => {
  const { tab } = page;
  await tab.locator('body').press('Escape');
  await tab.locator('body').press('Control+c');
  await tab.locator('body').press('Control+v');
  const { x, y, height } = await middle();
  await tab.mouse.move(x, y + 0.2 * height);
  await tab.mouse.move(x, y + 0.21 * height);
  await tab.mouse.click(x, y + 0.21 * height);
  await panel(tab, 'Entity tree').getByRole('treeitem', { name: /^ball\S+ model$/ }).waitFor();
});

test('Delete removes what is chosen', async () => {
  const { tab } = page;
  await choose(tab, 'ball');
  await tab.locator('body').press('Delete');
  await until(() => ball().count(), (count) => count === 0, 'it has gone');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
