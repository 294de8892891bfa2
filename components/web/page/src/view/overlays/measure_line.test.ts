import assert from 'node:assert/strict';
import { test } from 'node:test';

import { MeasureLine, measureLines } from './measure_line.ts';

test('a measurement is a line and its parts along the axes', () => {
  const lines = measureLines([0, 0, 0], [1, 2, 3]);
  const pairs = Array.from({ length: 4 }, (_, i) => lines.slice(6 * i, 6 * i + 6));
  assert.deepEqual(pairs, [[0, 0, 0, 1, 2, 3], [0, 0, 0, 1, 0, 0], [1, 0, 0, 1, 2, 0], [1, 2, 0, 1, 2, 3]]);
});

test('it is shown while there is one', () => {
  const line = new MeasureLine();
  assert.ok(!line.group.visible);
  line.show([[0, 0, 0], [1, 0, 0]]);
  assert.ok(line.group.visible);
  line.show(null);
  assert.ok(!line.group.visible);
});
