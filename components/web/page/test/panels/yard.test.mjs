// Panels that change the world: wrenches, lights, models from files and addresses, seed, update rates, joints.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, openPanel, panel, pongsim, shownPose, until } from './page.mjs';

let page;
before(async () => (page = await openPage(new URL('yard.sdf', import.meta.url).pathname)));
after(() => page.close());

const item = (name) => panel(page.tab, 'Entity tree').getByRole('treeitem', { name: new RegExp(`^${name} \\w+$`) });
const control = () => panel(page.tab, 'World control');
const iterations = async () => Number(await page.tab.locator('#stats-iterations').textContent());
const scene = () => JSON.parse(pongsim('service', '-s', '/world/yard/scene/info', '--req', '', '--json'));

async function step(count) {
  const before = await iterations();
  await control().getByLabel('Steps').fill(String(count));
  await control().getByRole('button', { name: 'Step' }).click();
  await until(iterations, (now) => now === before + count, `${count} steps`);
}

async function reset() {
  await control().getByRole('button', { name: 'Reset' }).click();
  await until(iterations, (count) => count === 0, 'the start');
}

test('a force lasts until it is ended', async () => {
  const { tab } = page;
  const force = await openPanel(tab, 'Apply force torque');
  await choose(tab, 'block');
  await force.getByLabel('y [N]', { exact: true }).fill('-20');
  assert.equal(await force.getByText('no system ApplyLinkWrench').isVisible(), false);
  await force.getByRole('button', { name: 'From now on' }).click();
  // messages and requests are handled in order: when `step` returns, the world has received the wrench
  await until(async () => {
    await step(100);
    return shownPose(tab);
  }, ([, y]) => y < -0.05, 'it is pushed');
  await force.getByRole('button', { name: 'End' }).click();
  const speed = async () => {
    const [, from] = await shownPose(tab);
    await step(20);
    return from - (await shownPose(tab))[1];
  };
  // without force and friction the velocity is constant
  await until(async () => [await speed(), await speed()], ([first, second]) => Math.abs(second - first) < 2e-4, 'it is no longer pushed');
  await reset();
});

test('a torque for one step turns', async () => {
  const { tab } = page;
  const force = panel(tab, 'Apply force torque');
  await until(() => shownPose(tab), ([, y]) => y === 0, 'the start');
  await force.getByLabel('y [N]', { exact: true }).fill('0');
  await force.getByLabel('z [N m]', { exact: true }).fill('300');
  await force.getByRole('button', { name: 'For one step' }).click();
  await until(async () => {
    await step(50);
    return shownPose(tab);
  }, (pose) => pose[5] > 0.02, 'it turns');
  await force.getByRole('button', { name: 'Close Apply force torque' }).click();
  await reset();
});

test('lights of each kind are added', async () => {
  const { tab } = page;
  const lights = await openPanel(tab, 'Lights');
  const box = await tab.locator('#view').boundingBox();
  for (const [i, kind] of ['point', 'spot', 'directional'].entries()) {
    await lights.getByRole('button', { name: `+ ${kind}` }).click();
    await tab.mouse.move(box.x + box.width * (0.4 + 0.1 * i), box.y + box.height * 0.5);
    await tab.mouse.click(box.x + box.width * (0.4 + 0.1 * i), box.y + box.height * 0.5);
    await lights.getByRole('checkbox', { name: `${kind} is on` }).waitFor();
    const added = scene().light.find(({ name }) => name === kind);
    assert.equal((added?.type ?? 'POINT').toLowerCase(), kind);
    assert.equal(added.pose.position.z, 3);
  }
  await lights.getByRole('button', { name: 'spot', exact: true }).click();
  await tab.locator('body').press('Delete');
  await until(scene, ({ light }) => !light.some(({ name }) => name === 'spot'), 'it has gone');
  await lights.getByRole('button', { name: 'Close Lights' }).click();
});

test('all files that are chosen are inserted, and models by their address', async () => {
  const { tab } = page;
  const spawn = await openPanel(tab, 'Spawn');
  const file = (name) => ({
    name: `${name}.sdf`, mimeType: 'application/xml',
    buffer: Buffer.from(`<sdf version="1.9"><model name="${name}"><static>true</static><link name="l"/></model></sdf>`),
  });
  await spawn.getByLabel('SDF or URDF files').setInputFiles([file('one'), file('two'), file('three')]);
  for (const name of ['one', 'two', 'three']) await item(name).waitFor();
  await spawn.getByLabel('Address of a model').fill('model://no_such_model');
  await spawn.getByRole('button', { name: 'Add', exact: true }).click();
  await tab.locator('.toast.error', { hasText: 'Spawn' }).waitFor();
  await choose(tab, 'two');
  await tab.locator('summary', { hasText: 'Edit' }).click();
  await tab.getByRole('button', { name: 'Remove', exact: true }).click();
  await until(scene, ({ model }) => !model.some(({ name }) => name === 'two'), 'it has gone');
  await spawn.getByRole('button', { name: 'capsule' }).click();
  const box = await tab.locator('#view').boundingBox();
  await tab.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.4);
  await tab.mouse.click(box.x + box.width * 0.5, box.y + box.height * 0.4);
  await item('capsule').waitFor();
  await spawn.getByRole('button', { name: 'Close Spawn' }).click();
});

test('the tree keeps its rows when the world changes', async () => {
  const { tab } = page;
  const row = item('block');
  const same = await row.elementHandle();
  const center = await row.locator('> .row .name').boundingBox();
  await tab.mouse.move(center.x + 5, center.y + center.height / 2);
  await tab.mouse.down();
  pongsim('service', '-s', '/world/yard/create', '--reqtype', 'ignition.msgs.EntityFactory', '--reptype', 'ignition.msgs.Boolean',
    '--timeout', '20000', '--req', 'sdf: "<sdf version=\'1.9\'><model name=\'late\'><static>true</static><link name=\'l\'/></model></sdf>"');
  await item('late').waitFor();
  await tab.mouse.up();
  assert.ok(await same.evaluate((element) => element.isConnected));
  await until(() => row.getAttribute('aria-selected'), (selected) => selected === 'true', 'the click counts');
});

test('a slider moves a joint, and the inspector has its position', async () => {
  const { tab } = page;
  const joints = await openPanel(tab, 'Joint position controller');
  await item('gate').locator('> .row .twist').click();
  await choose(tab, 'hinge');
  // the controller names its own topic
  assert.equal(await joints.getByLabel('Topic of hinge').inputValue(), '/hinge_target');
  const slider = joints.getByRole('slider', { name: 'hinge' });
  await slider.press('End');
  const position = async () => Number((await tab.locator('#inspector-joint').textContent()).split(',')[0]);
  await until(async () => {
    await step(200);
    return position();
  }, (angle) => angle > 1, 'it opens');
  await joints.getByRole('button', { name: 'Close Joint position controller' }).click();
});

test('the seed of a reset decides the noise', async () => {
  const { tab } = page;
  const echo = await openPanel(tab, 'Topic echo');
  await echo.getByLabel('Topic', { exact: true }).selectOption('/imu');
  const noise = async (seed) => {
    await control().getByLabel('Seed').fill(String(seed));
    await reset();
    await step(20);
    const text = await until(() => echo.locator('pre').textContent(), (found) => /"linear_acceleration": \{\s*"x": [-\d.e]+/.test(found), 'acceleration');
    return /"linear_acceleration": \{\s*"x": ([-\d.e]+)/.exec(text)[1];
  };
  await echo.getByLabel('Messages to keep').fill('1');
  const first = await noise(7);
  await until(() => noise(8), (other) => other !== first, 'another seed is another noise');
  await until(() => noise(7), (again) => again === first, 'the same seed is the same noise');
});

test('a topic is echoed as many times as asked for, and not while paused', async () => {
  const { tab } = page;
  const echo = panel(tab, 'Topic echo');
  const count = async () => (await echo.locator('pre').textContent()).split('linear_acceleration":').length - 1;
  await echo.getByLabel('Messages to keep').fill('3');
  await step(100);
  await until(count, (kept) => kept === 3, 'three');
  // a smaller limit takes effect at once, without a further message
  await echo.getByLabel('Messages to keep').fill('2');
  await until(count, (kept) => kept === 2, 'two');
  await echo.getByLabel('Paused').check();
  const before = await echo.locator('pre').textContent();
  await step(100);
  assert.equal(await echo.locator('pre').textContent(), before);
  await echo.getByRole('button', { name: 'Close Topic echo' }).click();
});

test('a message is published at a rate until it is stopped', async () => {
  const { tab } = page;
  const echo = await openPanel(tab, 'Topic echo');
  const publisher = await openPanel(tab, 'Publisher');
  await publisher.getByLabel('Topic', { exact: true }).fill('/counted');
  await publisher.getByLabel('Rate [Hz]').fill('20');
  await publisher.getByRole('button', { name: 'Publish', exact: true }).click();
  await publisher.getByRole('button', { name: 'Stop', exact: true }).waitFor();
  assert.match(pongsim('topic', '-e', '-t', '/counted', '-n', '3', '--json'), /\{[^]*\{[^]*\{/);
  await publisher.getByRole('button', { name: 'Stop', exact: true }).click();
  await publisher.getByRole('button', { name: 'Publish', exact: true }).waitFor();
  await publisher.getByRole('button', { name: 'Close Publisher' }).click();
  await echo.getByRole('button', { name: 'Close Topic echo' }).click();
});

test('messages are filtered and cleared', async () => {
  const messages = await openPanel(page.tab, 'Messages');
  await messages.locator('li.error', { hasText: 'no_such_model' }).first().waitFor();
  assert.ok(await messages.locator('li.info').count() > 0);
  await messages.getByLabel('Messages shown').selectOption('error');
  assert.equal(await messages.locator('li.info').count(), 0);
  assert.ok(await messages.locator('li.error').count() > 0);
  await messages.getByRole('button', { name: 'Clear' }).click();
  assert.deepEqual(await messages.locator('li').allTextContents(), ['Nothing']);
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
