// What the inspector changes, by entering values, and that each change is undone and made again.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, panel, pongsim, shownPose, until } from './page.mjs';

let page;
before(async () => (page = await openPage(new URL('yard.sdf', import.meta.url).pathname)));
after(() => page.close());

const inspector = () => panel(page.tab, 'Component inspector');
const item = (name) => panel(page.tab, 'Entity tree').getByRole('treeitem', { name: new RegExp(`^${name} \\w+$`) });
const scene = () => JSON.parse(pongsim('service', '-s', '/world/yard/scene/info', '--req', '', '--json'));
const unfold = (name) => item(name).locator('> .row .twist').click();

async function enter(name, value) {
  const field = inspector().getByLabel(name, { exact: true });
  await field.fill(value);
  await field.press('Enter');
  return field;
}

/// Enters values of several fields before the world can answer the first.
const enterAtOnce = (values) => page.tab.evaluate((all) => {
  for (const [name, value] of Object.entries(all)) {
    const field = document.querySelector(`.inspector [aria-label="${name}"]`);
    field.value = value;
    field.dispatchEvent(new Event('input', { bubbles: true }));
    field.dispatchEvent(new Event('change', { bubbles: true }));
  }
}, values);

/// Undoes the last change and makes it again: `look` returns what it is now.
async function thereAndBack(look, first, then, what) {
  await until(look, then, `${what}: changed`);
  // also while the field still has the focus
  await page.tab.keyboard.press('Control+z');
  await until(look, first, `${what}: undone`);
  await page.tab.keyboard.press('Control+Shift+z');
  await until(look, then, `${what}: made again`);
  await page.tab.keyboard.press('Control+z');
  await until(look, first, `${what}: undone again`);
}

test('the gravity of the world', async () => {
  // nothing is selected
  const field = await enter('Gravity z', '-1.62');
  await thereAndBack(() => field.inputValue(), (text) => text === '-9.8', (text) => text === '-1.62', 'gravity');
});

test('numbers of gravity that are entered at once', async () => {
  await enterAtOnce({ 'Gravity x': '1', 'Gravity y': '2' });
  const values = () => Promise.all(['Gravity x', 'Gravity y'].map((name) => inspector().getByLabel(name, { exact: true }).inputValue()));
  await until(values, ([x, y]) => x === '1' && y === '2', 'both');
  await page.tab.keyboard.press('Control+z');
  await until(values, ([x, y]) => x === '1' && y === '0', 'the second undone');
  await page.tab.keyboard.press('Control+z');
  await until(values, ([x, y]) => x === '0' && y === '0', 'the first undone');
});

test('the pose of a model', async () => {
  await choose(page.tab, 'block');
  await until(() => shownPose(page.tab), ([, , z]) => Math.abs(z - 0.6) < 1e-6, 'a pose');
  await enter('yaw', '0.5');
  await thereAndBack(() => shownPose(page.tab), (pose) => Math.abs(pose[5]) < 1e-6, (pose) => Math.abs(pose[5] - 0.5) < 1e-6, 'yaw');
  assert.ok(Math.abs((await shownPose(page.tab))[2] - 0.6) < 1e-6, 'the others stay');
});

test('numbers that are entered at once are all changed, and undone one by one', async () => {
  const { tab } = page;
  await choose(tab, 'block');
  await until(() => shownPose(tab), ([x, y]) => Math.abs(x) + Math.abs(y) < 9, 'a pose');
  const [x, y] = await shownPose(tab);
  await enterAtOnce({ x: String(x + 1), y: String(y + 2) });
  const isAt = (dx, dy) => (pose) => Math.abs(pose[0] - x - dx) < 1e-5 && Math.abs(pose[1] - y - dy) < 1e-5;
  await until(() => shownPose(tab), isAt(1, 2), 'both');
  await tab.keyboard.press('Control+z');
  await until(() => shownPose(tab), isAt(1, 0), 'the second undone');
  await tab.keyboard.press('Control+z');
  await until(() => shownPose(tab), isAt(0, 0), 'the first undone');
});

test('the pose of a link is only to be read', async () => {
  await unfold('block');
  await choose(page.tab, 'body');
  await until(() => inspector().getByLabel('yaw', { exact: true }).evaluate(({ readOnly }) => readOnly), (is) => is, 'read only');
});

test('the mass of a link', async () => {
  const field = await enter('Mass', '3.5');
  await thereAndBack(() => field.inputValue(), (text) => text === '1', (text) => text === '3.5', 'mass');
});

test('what the world refuses is not shown, and no change', async () => {
  const field = await enter('Mass', '-1');
  await page.tab.locator('.toast.error', { hasText: 'Mass' }).waitFor();
  await until(() => field.inputValue(), (text) => text === '1', 'as it was');
});

test('the colour of a visual', async () => {
  await unfold('body');
  await panel(page.tab, 'Entity tree').getByRole('treeitem', { name: 'visual visual' }).last().locator('> .row .name').click();
  const field = inspector().getByLabel('Colour', { exact: true });
  await until(() => field.inputValue(), (text) => text === '#cc1a1a', 'that of the file');
  await field.fill('#0000ff');
  const look = () => scene().model.find(({ name }) => name === 'block').link[0].visual[0].material.diffuse;
  await thereAndBack(look, ({ r }) => Math.abs(r - 0.8) < 0.01, ({ r, b }) => !r && b === 1, 'colour');
});

test('the position of a joint', async () => {
  await unfold('gate');
  await choose(page.tab, 'hinge');
  const shown = async () => Number((await page.tab.locator('#inspector-joint').textContent()).split(',')[0]);
  await until(shown, (angle) => angle === 0, 'the start');
  await enter('Position', '0.75');
  await thereAndBack(shown, (angle) => Math.abs(angle) < 1e-6, (angle) => Math.abs(angle - 0.75) < 1e-6, 'position');
});

test('a light', async () => {
  await choose(page.tab, 'sun');
  const sun = () => scene().light.find(({ name }) => name === 'sun');
  await enter('Intensity', '0.25');
  await thereAndBack(sun, ({ intensity }) => intensity === 1, ({ intensity }) => intensity === 0.25, 'intensity');
  const isOff = ({ header }) => header?.data.some(({ key, value }) => key === 'isLightOn' && value[0] === '0') ?? false;
  await inspector().getByLabel('On', { exact: true }).uncheck();
  await until(sun, isOff, 'off');
  await inspector().getByLabel('Colour', { exact: true }).fill('#ff0000');
  await until(sun, (light) => isOff(light) && !light.diffuse.g, 'red, and still off');
  await enter('z', '12');
  await thereAndBack(sun, ({ pose }) => pose.position.z === 10, ({ pose }) => pose.position.z === 12, 'height');
});

test('nothing has gone wrong in the page', () => {
  // the refusal above is no error of the page
  assert.deepEqual(page.errors, []);
});
