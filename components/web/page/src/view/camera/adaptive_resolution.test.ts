import assert from 'node:assert/strict';
import { test } from 'node:test';

import { AdaptiveResolution } from './adaptive_resolution.ts';

/// The resolutions of this number of frames that take so long.
function draw(resolution: AdaptiveResolution, count: number, ms: number): number[] {
  return Array.from({ length: count }, () => resolution.next(ms));
}

test('quick frames have the full resolution', () => {
  assert.ok(draw(new AdaptiveResolution(), 100, 17).every((share) => share === 1));
});

test('slow frames have a reduced resolution, step by step', () => {
  const shares = draw(new AdaptiveResolution(), 100, 100);
  assert.equal(shares[5], 1);
  assert.equal(shares[12], 0.75);
  assert.equal(shares.at(-1), 0.35);
});

test('frames of seconds have the lowest resolution after three of them', () => {
  const shares = draw(new AdaptiveResolution(), 5, 2000);
  assert.deepEqual(shares, [1, 1, 0.35, 0.35, 0.35]);
});

test('one slow frame, such as the first, changes nothing', () => {
  const resolution = new AdaptiveResolution();
  draw(resolution, 1, 3000);
  // their mean is long
  assert.ok(draw(resolution, 3, 17).every((share) => share === 1));
});

test('the resolution is full again once frames are quick again', () => {
  const resolution = new AdaptiveResolution();
  draw(resolution, 100, 200);
  assert.equal(draw(resolution, 100, 15).at(-1), 1);
});
