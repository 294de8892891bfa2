import assert from 'node:assert/strict';
import test from 'node:test';
import { distanceText } from './measure.ts';

test('a distance has its parts along the axes', () => {
  assert.equal(distanceText([1, 1, 0], [3, -0.5, 0]), '2.500 m (x 2.000, y -1.500, z 0.000)');
  assert.equal(distanceText([0, 0, 1e-9], [0, 0, 0]), '0.000 m (x 0.000, y 0.000, z 0.000)');
});
