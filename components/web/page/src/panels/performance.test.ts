import assert from 'node:assert/strict';
import test from 'node:test';
import { sizeText } from './performance.ts';

test('sizes have the unit that suits them', () => {
  assert.deepEqual([0, 999, 1000, 12_345, 2_500_000, 7e12].map(sizeText), ['0 B', '999 B', '1.0 kB', '12.3 kB', '2.5 MB', '7000.0 GB']);
});
