import assert from 'node:assert/strict';
import { test } from 'node:test';

import { skyColors, skyDome } from './sky.ts';

test('the sky is bright by day and dark by night', () => {
  const day = skyColors({ time: 12, sunrise: 6, sunset: 20 });
  const night = skyColors({ time: 23.9, sunrise: 6, sunset: 20 });
  assert.ok(Math.abs(day.zenith.b - 0.6) < 1e-9);
  assert.ok(night.zenith.b < 0.1);
});

test('a sky that does not know its day is bright', () => {
  assert.ok(Math.abs(skyColors({}).horizon.r - 0.55) < 1e-9);
});

test('the dome is drawn before everything and hides nothing', () => {
  const dome = skyDome(skyColors({}));
  assert.equal(dome.renderOrder, -1);
  assert.equal((dome.material as { depthWrite: boolean }).depthWrite, false);
});
