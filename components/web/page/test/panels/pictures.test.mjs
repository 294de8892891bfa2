// Takes the screenshots for docs/web.md and the README, and writes them to the folder PONGSIM_PICTURES. Without it, the
// screenshots are taken, but not written.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { choose, openPage, openPanel, panel, patience, pongsim, repository, shownPose, until } from './page.mjs';
import { chunksOf, movingWebp } from './webp.mjs';

function keep(name, picture) {
  const folder = process.env.PONGSIM_PICTURES;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, name), picture);
}

/// @return The PNG files as WebP, which has a tenth of the size.
async function asWebp(tab, pictures) {
  const other = await tab.context().newPage();
  const texts = await other.evaluate(async (files) => {
    const canvas = document.createElement('canvas');
    const found = [];
    for (const file of files) {
      const bytes = Uint8Array.from(atob(file), (letter) => letter.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      Object.assign(canvas, { width: bitmap.width, height: bitmap.height });
      canvas.getContext('2d').drawImage(bitmap, 0, 0);
      found.push(canvas.toDataURL('image/webp', 0.8).split(',')[1]);
    }
    return found;
  }, pictures.map((picture) => picture.toString('base64')));
  return texts.map((text) => Buffer.from(text, 'base64'));
}

/// Waits until the view is sharp: while something moves, it may have a lower resolution.
const sharp = (tab) => until(() => tab.locator('#view canvas').evaluate((canvas) => canvas.width / canvas.clientWidth), (ratio) => ratio >= 1, 'a sharp view');

const calm = { animations: 'disabled', caret: 'hide' };

test('the page', async () => {
  const viewport = { width: 1100, height: 680 };
  const page = await openPage(`${repository}worlds/pong_world.sdf`, { viewport });
  const { tab } = page;
  try {
    await choose(tab, 'pong_bot');
    await openPanel(tab, 'Key publisher');
    await until(() => shownPose(tab), (pose) => pose.length === 6, 'a pose');
    await sharp(tab);
    keep('web-page.png', await tab.screenshot(calm));
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});

/// Panels for the robot's camera and lidar, beside the view.
const gui = `<gui>
  <plugin filename="MinimalScene" name="3D View"><camera_pose>-5.5 0 4.5 0 0.62 0</camera_pose></plugin>
  <plugin filename="ImageDisplay" name="Camera">
    <ignition-gui><title>Camera</title></ignition-gui><topic>/camera</topic>
  </plugin>
  <plugin filename="VisualizeLidar" name="Lidar"><topic>/lidar</topic></plugin>
  <plugin filename="KeyPublisher" name="Keys"/>
</gui>`;

test('a robot that is driven with the arrow keys, with what its lidar and its camera see', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'pongsim-drive-'));
  const world = join(folder, 'drive.sdf');
  writeFileSync(world, readFileSync(`${repository}worlds/pong_lidar.sdf`, 'utf8').replace(/<world name="[^"]*">/, `$&${gui}`));
  const viewport = { width: 960, height: 600 };
  const page = await openPage(world, { viewport });
  const { tab } = page;
  try {
    await panel(tab, 'Key publisher').waitFor();
    const pictures = [];
    const keys = { 1: 'ArrowUp', 9: 'ArrowLeft', 17: 'ArrowUp', 23: 'ArrowRight', 31: 'ArrowUp' };
    for (let i = 0; i < 36; i++) {
      if (keys[i]) await tab.locator('body').press(keys[i]);
      pongsim('world', 'step', '200', '--timeout', String(patience));
      const before = pictures.at(-1);
      pictures.push(await until(() => tab.screenshot(calm), (picture) => !before?.equals(picture), 'another picture'));
    }
    const moving = movingWebp(await asWebp(tab, pictures), viewport, 120);
    assert.equal(chunksOf(moving).filter(({ name }) => name === 'ANMF').length, pictures.length);
    keep('web-drive.webp', moving);
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
    rmSync(folder, { recursive: true });
  }
});

test('what sensors see, and a plot', async () => {
  const world = new URL('camera.sdf', import.meta.url).pathname;
  const page = await openPage(world, { options: [], viewport: { width: 1200, height: 1080 } });
  const { tab } = page;
  try {
    await panel(tab, 'Front camera').getByText('64 × 48').waitFor();
    await panel(tab, 'Visualize lidar').getByText('90 rays').waitFor();
    await panel(tab, 'Spawn').getByRole('button', { name: 'Close Spawn' }).click();
    const plot = await openPanel(tab, 'Plot');
    await plot.getByLabel('Topic').selectOption('/world/camera_world/model/arm/joint_state');
    await plot.getByLabel('Number').selectOption('joint[shoulder].axis1.position');
    await plot.getByRole('button', { name: 'Plot', exact: true }).click();
    const field = panel(tab, 'Joint position controller').getByLabel('shoulder, number');
    await field.fill('1.2');
    await field.press('Enter');
    await until(() => tab.locator('#stats-sim').textContent(), (text) => text > '0 00:00:03', 'three seconds');
    await tab.getByRole('button', { name: 'Pause' }).click();
    await sharp(tab);
    // waits until the view has been drawn: an image of one colour would be smaller
    await until(() => tab.locator('.stage').screenshot(calm), (picture) => picture.length > 12_000, 'the view is drawn');
    keep('web-panels.png', await tab.screenshot(calm));
    assert.deepEqual(page.errors, []);
  } finally {
    await page.close();
  }
});
