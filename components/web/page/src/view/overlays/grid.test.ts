import assert from 'node:assert/strict';
import { test } from 'node:test';

import { gridLines, gridOf } from './grid.ts';

test('the grid has 20 cells of a metre each way', () => {
  const lines = gridLines();
  assert.equal(lines.length / 6, 2 * 21 * 20);
  assert.equal(Math.max(...lines), 10);
  assert.equal(Math.min(...lines), -10);
  for (let i = 0; i < lines.length; i += 6) {
    const length = Math.hypot(lines[i]! - lines[i + 3]!, lines[i + 1]! - lines[i + 4]!, lines[i + 2]! - lines[i + 5]!);
    assert.equal(length, 1);
  }
});

test('the grid of a dark page is darker', () => {
  assert.ok(gridOf('dark').material.color.r < gridOf('light').material.color.r);
});
