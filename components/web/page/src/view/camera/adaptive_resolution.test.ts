import assert from 'node:assert/strict';
import { test } from 'node:test';

import { AdaptiveResolution } from './adaptive_resolution.ts';

/// The resolutions for this number of consecutive frames.
function draw(resolution: AdaptiveResolution, count: number, interval: number, begin = 0): number[] {
  return Array.from({ length: count }, (_, i) => resolution.next(begin + i * interval));
}

test('quick frames have the full resolution', () => {
  assert.ok(draw(new AdaptiveResolution(), 100, 17).every((share) => share === 1));
});

test('slow frames have a reduced resolution, down to half', () => {
  const shares = draw(new AdaptiveResolution(), 100, 200);
  assert.equal(shares[5], 1);
  assert.equal(shares[12], 0.75);
  assert.equal(shares.at(-1), 0.5);
});

test('the resolution is full again once frames are quick again', () => {
  const resolution = new AdaptiveResolution();
  draw(resolution, 100, 200);
  assert.equal(draw(resolution, 100, 17, 30_000).at(-1), 1);
});

test('frames far apart have the full resolution', () => {
  assert.ok(draw(new AdaptiveResolution(), 100, 2000).every((share) => share === 1));
});
