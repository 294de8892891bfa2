// Models in the page: selected, moved, dragged, removed, inserted, copied.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, openPanel, panel, pongsim, repository, shownPose, until } from './page.mjs';

let page;
before(async () => (page = await openPage(`${repository}worlds/pong_world.sdf`)));
after(() => page.close());

const item = (name) => panel(page.tab, 'Entity tree').getByRole('treeitem', { name: new RegExp(`^${name} \\w+$`) });

test('the tree finds what is inside', async () => {
  await item('pong_bot').waitFor();
  await page.tab.getByLabel('Search entities').fill('chassis');
  await item('chassis').first().waitFor();
  await until(() => item('ground_plane').count(), (count) => count === 0, 'only what has the word');
  await page.tab.getByLabel('Search entities').fill('');
});

test('the inspector tells of a link', async () => {
  await page.tab.getByLabel('Search entities').fill('chassis');
  await item('chassis').first().locator('> .row .name').click();
  await panel(page.tab, 'Component inspector').getByText('Mass [kg]').waitFor();
  await page.tab.getByLabel('Search entities').fill('');
});

test('a model moves to where the numbers say', async () => {
  const transform = await openPanel(page.tab, 'Transform control');
  await choose(page.tab, 'pong_bot');
  await transform.getByText('pong_bot').waitFor();
  await transform.getByLabel('X [m]').fill('1.5');
  await transform.getByLabel('Y [m]').fill('-1');
  await transform.getByRole('button', { name: 'Move there' }).click();
  await until(() => shownPose(page.tab), ([x, y]) => x === 1.5 && y === -1, 'it is there');
});

test('a shape is added where the view is clicked', async () => {
  const { tab } = page;
  await tab.locator('summary', { hasText: 'Add' }).click();
  await tab.locator('.menu .items button', { hasText: 'sphere' }).click();
  const box = await tab.locator('#view').boundingBox();
  await tab.mouse.move(box.x + box.width / 2, box.y + box.height * 0.45);
  await tab.mouse.move(box.x + box.width / 2 + 5, box.y + box.height * 0.45);
  await tab.mouse.click(box.x + box.width / 2 + 5, box.y + box.height * 0.45);
  await item('sphere').waitFor();
});

test('a file that is dropped is a model', async () => {
  const { tab } = page;
  const drop = (name, text) => tab.evaluate(([fileName, content]) => {
    const data = new DataTransfer();
    data.items.add(new File([content], fileName));
    window.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
  }, [name, text]);
  await drop('crate.sdf', '<sdf version="1.9"><model name="crate"><static>true</static><link name="l"/></model></sdf>');
  await item('crate').waitFor();
  await drop('note.txt', 'no model at all');
  await tab.getByText('note.txt has no model').waitFor();
  await drop('torn.sdf', '<sdf version="1.9"><model name="torn"><link');
  await tab.locator('.toast.error', { hasText: 'Spawn torn' }).waitFor();
});

test('what is chosen is removed', async () => {
  await choose(page.tab, 'crate');
  await page.tab.locator('body').press('Delete');
  await until(() => item('crate').count(), (count) => count === 0, 'it has gone');
});

test('a model is copied as SDF', async () => {
  const { tab } = page;
  await tab.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await choose(tab, 'pong_bot');
  await tab.locator('summary', { hasText: 'Edit' }).click();
  await tab.getByRole('button', { name: 'Copy as SDF' }).click();
  const sdf = await until(() => tab.evaluate(() => navigator.clipboard.readText()), (text) => text !== '', 'SDF');
  assert.match(sdf, /<model name="pong_bot">/);
  assert.match(sdf, /<joint name=/);
});

test('a light goes off and on, and is dimmed', async () => {
  const lights = await openPanel(page.tab, 'Lights');
  const box = lights.getByRole('checkbox', { name: 'sun is on' });
  const sun = () => {
    const scene = JSON.parse(pongsim('service', '-s', '/world/pong_world/scene/info', '--req', '', '--json'));
    return scene.light.find(({ name }) => name === 'sun');
  };
  const isOff = ({ header }) => header?.data.some(({ key, value }) => key === 'isLightOn' && value[0] === '0') ?? false;
  await box.uncheck();
  await until(sun, isOff, 'off');
  const bright = lights.getByLabel('Intensity of sun');
  await bright.fill('0.5');
  await bright.press('Enter');
  await until(sun, (light) => light.intensity === 0.5 && isOff(light), 'dimmed, and still off');
  await box.press('Space');
  await until(sun, (light) => !isOff(light) && light.intensity === 0.5, 'on again');
  // by the keyboard: the checkbox has kept the focus, although the world was read again
  await page.tab.keyboard.press('Space');
  await until(sun, isOff, 'off again');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
