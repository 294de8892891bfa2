import assert from 'node:assert/strict';
import { test } from 'node:test';

import { keyMove } from './keys.ts';

function press(key: string, more = {}) {
  return keyMove({ key, shiftKey: false, ctrlKey: false, altKey: false, ...more });
}

test('plus goes nearer and minus as far away', () => {
  const [near, far] = [press('+') as { zoom: number }, press('-') as { zoom: number }];
  assert.ok(near.zoom < 1);
  assert.ok(Math.abs(near.zoom * far.zoom - 1) < 1e-9);
});

test('arrows turn with Shift only', () => {
  assert.deepEqual(press('ArrowLeft'), null);
  assert.ok((press('ArrowLeft', { shiftKey: true }) as { turn: number[] }).turn[0]! < 0);
  assert.ok((press('ArrowDown', { shiftKey: true }) as { turn: number[] }).turn[1]! > 0);
});

test("the browser's own keys are left alone", () => {
  assert.equal(press('-', { ctrlKey: true }), null);
  assert.equal(press('ArrowLeft', { shiftKey: true, altKey: true }), null);
  assert.equal(press('a', { shiftKey: true }), null);
});
