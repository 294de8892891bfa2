// An actor is shown at the position on its trajectory.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { choose, openPage, panel, shownPose, until } from './page.mjs';

let page;
before(async () => {
  page = await openPage(new URL('actor.sdf', import.meta.url).pathname, { options: [] });
});
after(() => page.close());

const walker = () => panel(page.tab, 'Entity tree').getByRole('treeitem', { name: 'walker actor' });

test('it goes along its trajectory', async () => {
  const { tab } = page;
  await choose(tab, 'walker');
  const [before] = await until(() => shownPose(tab), ([x, y, z]) => x > 0 && y === 0 && z === 0.5, 'it is on its way');
  await until(() => shownPose(tab), ([x]) => x > before + 0.01, 'it goes on');
});

test('it is picked in the view where it is now', async () => {
  const { tab } = page;
  // paused, because otherwise the actor could have moved on by the time of the click
  await tab.locator('body').press('Space');
  await tab.getByRole('button', { name: 'Play' }).waitFor();
  const canvas = await tab.locator('#view canvas').first().boundingBox();
  await until(async () => {
    await choose(tab, 'walker');
    await tab.locator('body').press('f');
    await choose(tab, 'post');
    await tab.mouse.click(canvas.x + canvas.width / 2, canvas.y + canvas.height / 2);
    return walker().getAttribute('aria-selected');
  }, (selected) => selected === 'true', 'the actor is picked');
});

test('nothing has gone wrong in the page', () => assert.deepEqual(page.errors, []));
