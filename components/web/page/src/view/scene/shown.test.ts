import assert from 'node:assert/strict';
import { test } from 'node:test';

import { contentOf } from './content.ts';
import { Shown } from './shown.ts';

const { places } = contentOf({ model: [{ id: 1, link: [{ id: 2 }] }, { id: 3 }] });

test('an overlay of a model is one of its links, and of no other model', () => {
  const shown = new Shown();
  shown.set('inertia', true, 1);
  assert.ok(shown.has('inertia', 2, places));
  assert.ok(!shown.has('inertia', 3, places));
  assert.ok(!shown.has('joints', 2, places));
  shown.set('inertia', false, 1);
  assert.ok(!shown.has('inertia', 2, places));
});

test('off for all is off for each', () => {
  const shown = new Shown();
  shown.set('frames', true, 1);
  shown.set('frames', true);
  assert.ok(shown.has('frames', 3, places));
  shown.set('frames', false);
  assert.ok(!shown.has('frames', 2, places));
});
