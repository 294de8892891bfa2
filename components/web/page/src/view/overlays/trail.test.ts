import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { Path } from './trail.ts';

test('a place counts if it is a centimetre from the last one', () => {
  const path = new Path();
  assert.ok(path.add(new Vector3(0, 0, 0)));
  assert.ok(!path.add(new Vector3(0.005, 0, 0)));
  assert.ok(path.add(new Vector3(0.011, 0, 0)));
  assert.equal(path.points.length, 6);
});

test('a long path stays whole and grows no further', () => {
  const path = new Path();
  for (let i = 0; i < 100_000; ++i) path.add(new Vector3(i, 0, 0));
  assert.ok(path.points.length <= 3 * 4000);
  assert.equal(path.points[0], 0);
  assert.equal(path.points.at(-3), 99_999);
  for (let i = 3; i < path.points.length; i += 3) assert.ok(path.points[i]! > path.points[i - 3]!);
});
