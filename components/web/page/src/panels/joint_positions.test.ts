import assert from 'node:assert/strict';
import test from 'node:test';
import { rangeOf } from './joint_positions.ts';

test('a slider goes from limit to limit, or as far as makes sense', () => {
  assert.deepEqual(rangeOf('revolute', { limitLower: -0.5, limitUpper: 2 }), [-0.5, 2]);
  assert.deepEqual(rangeOf('revolute', { limitLower: -1e16, limitUpper: 1e16 }), [-Math.PI, Math.PI]);
  assert.deepEqual(rangeOf('continuous', { limitLower: -Infinity, limitUpper: Infinity }), [-Math.PI, Math.PI]);
  assert.deepEqual(rangeOf('prismatic', undefined), [-1, 1]);
});
