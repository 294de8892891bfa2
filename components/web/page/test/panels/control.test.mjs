// Play, pause, step and reset by the page's buttons.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, panel, pongsim, repository, until } from './page.mjs';

let page;
before(async () => (page = await openPage(`${repository}worlds/pong_world.sdf`)));
after(() => page.close());

const iterations = async () => Number(await page.tab.locator('#stats-iterations').textContent());

test('the world is there, and stands still', async () => {
  await until(iterations, (count) => count === 0, 'no steps');
  assert.equal(await page.tab.title(), 'pong_world · pongsim');
  await page.tab.getByRole('button', { name: 'Play' }).waitFor();
});

test('a step is one, or as many as are asked for', async () => {
  await page.tab.getByRole('button', { name: 'Step' }).click();
  await until(iterations, (count) => count === 1, 'one step');
  await page.tab.getByLabel('Steps').fill('25');
  await page.tab.getByRole('button', { name: 'Step' }).click();
  await until(iterations, (count) => count === 26, '25 more');
});

test('it plays and pauses', async () => {
  await page.tab.getByRole('button', { name: 'Play' }).click();
  await page.tab.getByRole('button', { name: 'Pause' }).waitFor();
  await until(iterations, (count) => count > 200, 'it runs');
  await page.tab.getByRole('button', { name: 'Pause' }).click();
  await page.tab.getByRole('button', { name: 'Play' }).waitFor();
});

test('the space bar plays and pauses, too', async () => {
  await page.tab.locator('body').press('Space');
  await page.tab.getByRole('button', { name: 'Pause' }).waitFor();
  await page.tab.locator('body').press('Space');
  await page.tab.getByRole('button', { name: 'Play' }).waitFor();
});

test('a reset leads back to the start', async () => {
  await page.tab.getByRole('button', { name: 'Reset' }).click();
  await until(iterations, (count) => count === 0, 'the start');
  assert.equal(await page.tab.locator('#stats-sim').textContent(), '0 00:00:00.000');
});

test('the speed is the real-time factor that the world keeps', async () => {
  const factor = () => {
    const stats = JSON.parse(pongsim('topic', '-e', '-t', '/world/pong_world/stats', '-n', '1', '--json'));
    return stats.real_time_factor ?? stats.realTimeFactor ?? 0;
  };
  await page.tab.getByLabel('Speed').fill('0.25');
  await page.tab.getByLabel('Speed').press('Enter');
  await page.tab.getByRole('button', { name: 'Play' }).click();
  await until(factor, (value) => Math.abs(value - 0.25) < 0.03, 'a quarter');
  // 0: as fast as possible
  await page.tab.getByLabel('Speed').fill('0');
  await page.tab.getByLabel('Speed').press('Enter');
  await until(factor, (value) => value > 0.4, 'more than a quarter');
});

test('nothing has gone wrong in the page', async () => {
  assert.deepEqual(page.errors, []);
  assert.equal(await panel(page.tab, 'World control').count(), 1);
});
