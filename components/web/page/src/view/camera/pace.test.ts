import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Pace } from './pace.ts';

/// The resolutions for this number of consecutive frames.
function draw(pace: Pace, count: number, interval: number, begin = 0): number[] {
  return Array.from({ length: count }, (_, i) => pace.next(begin + i * interval));
}

test('who keeps up draws whole pictures', () => {
  assert.ok(draw(new Pace(), 100, 17).every((share) => share === 1));
});

test('who does not draws coarser ones, but not ever coarser', () => {
  const shares = draw(new Pace(), 100, 200);
  assert.equal(shares[5], 1);
  assert.equal(shares[12], 0.75);
  assert.equal(shares.at(-1), 0.5);
});

test('who is quick again draws whole ones again', () => {
  const pace = new Pace();
  draw(pace, 100, 200);
  assert.equal(draw(pace, 100, 17, 30_000).at(-1), 1);
});

test('pictures that are seldom wanted are whole', () => {
  assert.ok(draw(new Pace(), 100, 2000).every((share) => share === 1));
});
