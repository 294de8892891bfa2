// The tree of topics, contacts without a sensor, saved views, parallel projection, and what the server sends to whom.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { openPage, openPanel, panel, repository, until } from './page.mjs';

let page;
before(async () => (page = await openPage(`${repository}worlds/pong_world.sdf`, { options: [] })));
after(() => page.close());

test('topics are found by name and type, and open in a panel', async () => {
  const { tab } = page;
  const topics = await openPanel(tab, 'Topics');
  await topics.locator('summary', { hasText: 'world/pong_world' }).click();
  await topics.getByTitle('Show /world/pong_world/stats').waitFor();
  await topics.getByLabel('Search topics').fill('worldstat pong');
  await until(() => topics.locator('.topics button').allTextContents(), (names) => names.join() === 'world/pong_world/stats', 'the one that is left');
  await topics.getByRole('button', { name: 'world/pong_world/stats' }).click();
  await panel(tab, 'Topic echo').getByText('"iterations"').waitFor();
  await topics.getByLabel('Search topics').fill('no such topic');
  await topics.getByText('No topic has that name or type').waitFor();
});

test('contacts come without a contact sensor', async () => {
  const { tab } = page;
  const view = await openPanel(tab, 'View');
  await view.getByLabel('Contacts', { exact: true }).check();
  const performance = await openPanel(tab, 'Performance');
  await performance.getByText('/world/pong_world/contacts').first().waitFor();
  await view.getByLabel('Contacts', { exact: true }).uncheck();
});

test('the server tells what it sends to whom', async () => {
  const performance = panel(page.tab, 'Performance');
  await performance.locator('#performance-sent tr', { hasText: 'this page' }).filter({ hasText: '/world/pong_world/' }).first().waitFor();
  await performance.locator('#performance-clients').getByText('this page').waitFor();
  const { tab } = page;
  await tab.evaluate(() => (window.other = new WebSocket(location.origin.replace(/^http/, 'ws'), 'foxglove.websocket.v1')));
  await until(() => performance.locator('#performance-clients dd').first().textContent(), (count) => count === '2', 'another client');
  await performance.locator('#performance-sent tr', { hasText: 'foxglove.websocket.v1' }).first().waitFor();
  await tab.evaluate(() => window.other.close());
  await until(() => performance.locator('#performance-clients dd').first().textContent(), (count) => count === '1', 'it has gone');
});

test('a view is saved, and looked from again after a reload', async () => {
  const { tab } = page;
  const view = panel(tab, 'View');
  const eye = async () => new URLSearchParams((await tab.evaluate(() => location.hash)).slice(1)).get('view');
  await view.getByRole('button', { name: 'top', exact: true }).click();
  const above = await until(eye, (text) => text?.split(',')[4] > 1.5, 'from above');
  await view.getByLabel('Name of the view').fill('above');
  await view.getByRole('button', { name: 'Save view' }).click();
  await tab.getByRole('button', { name: 'Look along X' }).click();
  await until(eye, (text) => text !== above, 'from elsewhere');
  await tab.reload();
  await panel(tab, 'View').getByRole('button', { name: 'above', exact: true }).click();
  await until(eye, (text) => text === above, 'from above again');
  await panel(tab, 'View').getByRole('button', { name: 'Forget above' }).click();
  assert.equal(await panel(tab, 'View').getByRole('button', { name: 'above', exact: true }).count(), 0);
});

test('in parallel projection a click still selects', async () => {
  const { tab } = page;
  await panel(tab, 'View').getByLabel('Orthographic').check();
  await panel(tab, 'Entity tree').getByText('pong_bot', { exact: true }).dblclick();
  await tab.locator('body').press('Escape');
  const { x, y, width, height } = await tab.locator('#view canvas').boundingBox();
  await panel(tab, 'Entity tree').getByText('sun', { exact: true }).click();
  await until(async () => {
    await tab.mouse.click(x + width / 2, y + height / 2);
    return panel(tab, 'Entity tree').locator('[aria-selected=true]').first().getAttribute('aria-label');
  }, (name) => name === 'pong_bot model', 'the robot in the middle');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
