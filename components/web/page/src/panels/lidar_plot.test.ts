import assert from 'node:assert/strict';
import test from 'node:test';
import { hitsOf } from './lidar_plot.ts';

test('hits are where the rays end, and no hits are left out', () => {
  const scan = { angleMin: -Math.PI / 2, angleMax: Math.PI / 2, angleStep: 0, count: 3, ranges: [1, 2, Infinity, 3, 3, 4] };
  const round = (hits: [number, number][]): number[][] => hits.map((hit) => hit.map((value) => Math.round(1e6 * value) / 1e6 + 0));
  assert.deepEqual(round(hitsOf(scan, 0)), [[0, -1], [2, 0]]);
  assert.deepEqual(round(hitsOf(scan, 1)), [[0, -3], [3, 0], [0, 4]]);
});
