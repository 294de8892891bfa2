import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { Way } from './trail.ts';

test('a place counts if it is a centimetre from the last one', () => {
  const way = new Way();
  assert.ok(way.add(new Vector3(0, 0, 0)));
  assert.ok(!way.add(new Vector3(0.005, 0, 0)));
  assert.ok(way.add(new Vector3(0.011, 0, 0)));
  assert.equal(way.places.length, 6);
});

test('a long way stays whole and grows no further', () => {
  const way = new Way();
  for (let i = 0; i < 100_000; ++i) way.add(new Vector3(i, 0, 0));
  assert.ok(way.places.length <= 3 * 4000);
  assert.equal(way.places[0], 0);
  assert.equal(way.places.at(-3), 99_999);
  for (let i = 3; i < way.places.length; i += 3) assert.ok(way.places[i]! > way.places[i - 3]!);
});
