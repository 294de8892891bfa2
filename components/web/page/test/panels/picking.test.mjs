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

test('its pose is a table whose numbers keep their places', async () => {
  const numbers = await page.tab.locator('#inspector-pose .number').evaluateAll((cells) => cells.map(({ value }) => value));
  assert.deepEqual(numbers, ['2.000', '0.000', '0.500', '0.000', '0.000', '0.000']);
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

test('a move is undone and redone, by keys and in the menu', async () => {
  const { tab } = page;
  const [, moved] = await shownPose(tab);
  await tab.locator('body').press('Control+z');
  await until(() => shownPose(tab), ([, y]) => Math.abs(y) < 1e-6, 'it is back');
  await tab.locator('body').press('Control+Shift+z');
  await until(() => shownPose(tab), ([, y]) => Math.abs(y - moved) < 1e-6, 'it is moved again');
  await tab.locator('summary', { hasText: 'Edit' }).click();
  await tab.getByRole('button', { name: 'Undo Move ball' }).click();
  await until(() => shownPose(tab), ([, y]) => Math.abs(y) < 1e-6, 'it is back');
  // in a field, the keys are the field's
  const search = panel(tab, 'Entity tree').getByLabel('Search entities');
  await search.fill('ba');
  await search.press('Control+Shift+z');
  await search.fill('');
  await search.blur();
  assert.ok(Math.abs((await shownPose(tab))[1]) < 1e-6);
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

test('a copy is removed and brought back without a question', async () => {
  const { tab } = page;
  const copy = panel(tab, 'Entity tree').getByRole('treeitem', { name: /^ball\S+ model$/ });
  await copy.locator('> .row .name').click();
  await tab.locator('body').press('Delete');
  await until(() => copy.count(), (count) => count === 0, 'it has gone');
  await tab.locator('body').press('Control+z');
  await copy.waitFor();
  // and the paste itself
  await tab.locator('body').press('Control+z');
  await until(() => copy.count(), (count) => count === 0, 'it has gone');
  await tab.locator('body').press('Control+Shift+z');
  await copy.waitFor();
});

test('Delete removes what is chosen after a question, and undo brings it back', async () => {
  const { tab } = page;
  await choose(tab, 'ball');
  const before = await shownPose(tab);
  const question = tab.getByRole('alertdialog', { name: 'Remove ball?' });
  await tab.locator('body').press('Delete');
  await question.getByText('without its plugins').waitFor();
  await tab.keyboard.press('Escape');
  await question.waitFor({ state: 'detached' });
  assert.equal(await ball().count(), 1);
  await tab.locator('body').press('Delete');
  await question.getByRole('button', { name: 'Remove' }).click();
  await until(() => ball().count(), (count) => count === 0, 'it has gone');
  await tab.locator('body').press('Control+z');
  await ball().waitFor();
  await choose(tab, 'ball');
  assert.deepEqual(await shownPose(tab), before);
  await tab.locator('body').press('Control+Shift+z');
  await until(() => ball().count(), (count) => count === 0, 'it has gone again');
});

test('a distance is measured, by keys and by clicks', async () => {
  const { tab } = page;
  const measured = tab.locator('.measured');
  await tab.locator('body').press('m');
  await tab.locator('.toast', { hasText: 'first point' }).waitFor();
  await tab.keyboard.press('Enter');
  await tab.locator('.toast', { hasText: 'second point' }).waitFor();
  for (const key of ['Shift+ArrowUp', 'Shift+ArrowUp', 'ArrowLeft', 'Enter']) await tab.keyboard.press(key);
  const text = await measured.textContent();
  const [, x, y] = /x (\S+), y (\S+), z/.exec(text).map(Number);
  // along the axes of the world, wherever the view looks
  assert.deepEqual([Math.abs(x), Math.abs(y)].sort(), [0.1, 2]);
  await measured.getByRole('button', { name: 'Close the measurement' }).click();
  assert.equal(await measured.count(), 0);
  await tab.getByRole('button', { name: 'Measure' }).click();
  const at = await middle();
  await tab.mouse.move(at.x, at.y + 0.3 * at.height);
  await tab.mouse.click(at.x, at.y + 0.3 * at.height);
  await tab.locator('.toast', { hasText: 'second point' }).waitFor();
  await tab.mouse.move(at.x + 50, at.y + 0.3 * at.height);
  await tab.mouse.click(at.x + 50, at.y + 0.3 * at.height);
  assert.ok(parseFloat(await measured.textContent()) > 0.05, await measured.textContent());
  // Escape ends another one before its end
  await tab.locator('body').press('m');
  await tab.keyboard.press('Escape');
  assert.equal(await measured.count(), 0);
});

test('after a reset there is nothing to undo', async () => {
  const { tab } = page;
  await tab.getByRole('button', { name: 'Step' }).click();
  await until(() => tab.locator('#stats-iterations').textContent(), (text) => text === '1', 'a step');
  await tab.getByRole('button', { name: 'Reset' }).click();
  await ball().waitFor();
  await tab.locator('summary', { hasText: 'Edit' }).click();
  assert.ok(await tab.getByRole('button', { name: 'Undo', exact: true }).isDisabled());
  await tab.keyboard.press('Escape');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
