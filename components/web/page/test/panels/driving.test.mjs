// The moving robot tutorial by mouse and keyboard: open the Key publisher, play, drive by the arrow keys.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, openPanel, panel, repository, shownPose, until } from './page.mjs';

let page;
before(async () => (page = await openPage(`${repository}worlds/pong_world.sdf`)));
after(() => page.close());

test('the robot drives with the arrows', async () => {
  const { tab } = page;
  const keys = await openPanel(tab, 'Key publisher');
  const [box, label] = await Promise.all([keys.locator('input[type=checkbox]').boundingBox(), keys.locator('label').first().boundingBox()]);
  assert.ok(label.x - box.x < 40, 'the box is beside its label');
  await choose(tab, 'pong_bot');
  const [x, y] = await until(() => shownPose(tab), (pose) => pose.length === 6, 'a pose');
  await tab.getByRole('button', { name: 'Play' }).click();
  await tab.getByRole('button', { name: 'Pause' }).waitFor();
  await tab.locator('body').press('ArrowUp');
  assert.equal(await tab.locator('.last-key').textContent(), 'ArrowUp (16777235)');
  await until(() => shownPose(tab), ([x2, y2]) => Math.hypot(x2 - x, y2 - y) > 0.3, 'it drives');
  const before = (await shownPose(tab))[5];
  await tab.locator('body').press('ArrowLeft');
  await until(() => shownPose(tab), (pose) => Math.abs(pose[5] - before) > 0.2, 'it turns');
  // while the Key publisher is on, the space bar stops the robot instead of pausing the world
  await tab.locator('body').press('Space');
  await tab.getByRole('button', { name: 'Pause' }).waitFor();
  assert.equal(await tab.locator('.last-key').textContent(), '  (32)');
});

test('a panel that is opened meanwhile does not take the arrows', async () => {
  const { tab } = page;
  for (const title of ['Plot', 'Publisher']) {
    await openPanel(tab, title);
    await tab.keyboard.press('ArrowDown');
    await until(() => tab.locator('.last-key').textContent(), (key) => key.startsWith('ArrowDown'), `the arrow beside ${title}`);
    await tab.keyboard.press('ArrowUp');
    await until(() => tab.locator('.last-key').textContent(), (key) => key.startsWith('ArrowUp'), `the arrow beside ${title}`);
  }
  // neither does a list from which the mouse has chosen
  const topic = panel(tab, 'Plot').getByLabel('Topic', { exact: true });
  await topic.click();
  await topic.selectOption('/clock');
  await tab.keyboard.press('ArrowDown');
  await until(() => tab.locator('.last-key').textContent(), (key) => key.startsWith('ArrowDown'), 'the arrow after a choice');
  for (const title of ['Plot', 'Publisher']) await panel(tab, title).getByRole('button', { name: `Close ${title}` }).click();
});

test('sliders drive it, too', async () => {
  const { tab } = page;
  await panel(tab, 'Key publisher').getByRole('button', { name: 'Close Key publisher' }).click();
  const teleop = await openPanel(tab, 'Teleop');
  const [x, y] = await shownPose(tab);
  await teleop.getByRole('button', { name: 'Forward' }).click();
  await until(() => shownPose(tab), ([x2, y2]) => Math.hypot(x2 - x, y2 - y) > 0.3, 'it drives');
  await teleop.getByRole('button', { name: 'Stop' }).click();
});

test('a gamepad drives it, and lets go', async () => {
  const { tab } = page;
  const hold = (axes) => tab.evaluate((given) => {
    navigator.getGamepads = () => [{ connected: true, axes: given }];
  }, axes);
  const [x, y] = await shownPose(tab);
  await hold([0, -1, 0, 0]);
  await until(() => shownPose(tab), ([x2, y2]) => Math.hypot(x2 - x, y2 - y) > 0.3, 'it drives');
  await hold([0.05, 0.02, 0, 0]);
  const teleop = panel(tab, 'Teleop');
  await until(() => teleop.getByLabel('Forward [m/s]').inputValue(), (value) => Number(value) === 0, 'it stops');
});

test('a message by a form made from its type drives it', async () => {
  const { tab } = page;
  const publisher = await openPanel(tab, 'Publisher');
  await publisher.locator('summary', { hasText: /^angular$/ }).click();
  await publisher.locator('details', { has: tab.locator('summary', { hasText: /^angular$/ }) }).getByLabel('z').fill('0.8');
  const before = (await shownPose(tab))[5];
  await publisher.getByRole('button', { name: 'Publish', exact: true }).click();
  await until(() => shownPose(tab), (pose) => Math.abs(pose[5] - before) > 0.3, 'it turns');
  await publisher.getByLabel('Type').fill('ignition.msgs.NoSuch');
  await publisher.getByLabel('Type').blur();
  await publisher.getByText('The message type ignition.msgs.NoSuch is unknown').waitFor();
});

test('a service is called by a form made from its type', async () => {
  const { tab } = page;
  const service = await openPanel(tab, 'Service');
  await service.getByRole('combobox', { name: 'Service' }).fill('/world/pong_world/control');
  await service.getByRole('combobox', { name: 'Service' }).blur();
  await service.getByText('ignition.msgs.WorldControl → ignition.msgs.Boolean').waitFor();
  await service.getByLabel('pause', { exact: true }).check();
  await service.getByRole('button', { name: 'Call' }).click();
  await service.getByText('"data": true').waitFor();
  await tab.getByRole('button', { name: 'Play', exact: true }).waitFor();
  await service.getByRole('combobox', { name: 'Service' }).fill('/world/pong_world/controll');
  await service.getByRole('combobox', { name: 'Service' }).blur();
  await service.getByText('There is no service /world/pong_world/controll').waitFor();
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
