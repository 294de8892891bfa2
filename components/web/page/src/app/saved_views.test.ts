import assert from 'node:assert/strict';
import test from 'node:test';
import { parseViews, withView, type SavedView } from './saved_views.ts';

const view = (name: string): SavedView => ({ name, pose: [1, 2, 3, 0, 0.5, 0] });

test('views are read as they were written, and nothing else', () => {
  assert.deepEqual(parseViews(JSON.stringify([view('door')])), [view('door')]);
  for (const text of ['', 'null', '7', '{}', '[7, null, {"name": "x"}, {"name": "", "pose": [1,2,3,4,5,6]}, {"name": "y", "pose": [1,2]}]']) {
    assert.deepEqual(parseViews(text), [], text);
  }
});

test('a view replaces that of the same name, and there are not too many', () => {
  const moved: SavedView = { name: 'a', pose: [9, 9, 9, 0, 0, 0] };
  assert.deepEqual(withView([view('a'), view('b')], moved), [view('b'), moved]);
  let views: SavedView[] = [];
  for (let i = 0; i < 80; ++i) views = withView(views, view(String(i)));
  assert.equal(views.length, 50);
});
