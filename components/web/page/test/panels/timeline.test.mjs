// The timeline: back within a run, and to any time of a recording.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openPage, openPanel, pongsim, repository, until } from './page.mjs';

const world = `${repository}worlds/pong_world.sdf`;
const folder = mkdtempSync(join(tmpdir(), 'pongsim-timeline-'));
after(() => rmSync(folder, { recursive: true }));

const iterations = async (tab) => Number(await tab.locator('#stats-iterations').textContent());
const slider = (tab) => tab.locator('#timeline');
const bound = async (tab, name) => Number(await slider(tab).getAttribute(name));

// what a user's drag does, to an exact time
const drag = (tab, time) => slider(tab).evaluate((input, value) => {
  input.value = String(value);
  input.dispatchEvent(new Event('input'));
}, time);

test('a run goes back, and on from there', async () => {
  const page = await openPage(world);
  const { tab } = page;
  await openPanel(tab, 'Timeline');
  await tab.getByRole('button', { name: 'Play on' }).click();
  await until(() => bound(tab, 'max'), (end) => end > 1.2, 'more than two kept states');
  await tab.getByRole('button', { name: 'Hold' }).click();
  await tab.getByRole('button', { name: 'Play on' }).waitFor();
  const steps = await iterations(tab);
  await drag(tab, (await bound(tab, 'min')) + 0.6);
  const back = await until(() => iterations(tab), (count) => count < steps, 'an earlier step');
  assert.ok(back >= 500 && back < 700, `${back}`);
  // what comes after can still be seen, until it goes on
  assert.ok((await bound(tab, 'max')) > 0.9);
  await tab.getByRole('button', { name: 'Play on' }).click();
  await until(() => iterations(tab), (count) => count > back + 100, 'it goes on');
  assert.deepEqual(page.errors, []);
  await page.close();
});

test('a recording goes to any time, and in a loop', async () => {
  pongsim('run', world, '-z', '0', '--iterations', '1500', '--record-path', join(folder, 'run'));
  const page = await openPage(`--playback=${join(folder, 'run')}`);
  const { tab } = page;
  await openPanel(tab, 'Timeline');
  await until(() => bound(tab, 'max'), (end) => Math.abs(end - 1.5) < 0.02, 'its length');
  await drag(tab, 1.2);
  await until(() => iterations(tab), (count) => Math.abs(count - 1200) <= 1, 'the time asked for');
  await tab.getByLabel('Loop').check();
  await tab.getByRole('button', { name: 'Play on' }).click();
  // it comes to the end, and begins again
  await until(() => iterations(tab), (count) => count < 1000, 'the beginning');
  assert.deepEqual(page.errors, []);
  await page.close();
});
