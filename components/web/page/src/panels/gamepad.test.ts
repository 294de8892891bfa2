import assert from 'node:assert/strict';
import test from 'node:test';
import { deflection, sticks } from './gamepad.ts';

const pad = (axes: number[], connected = true): Gamepad => ({ axes, connected }) as unknown as Gamepad;

test('a stick near its middle is in the middle, and still reaches the edge', () => {
  assert.equal(deflection(0.1), 0);
  assert.equal(deflection(-0.1), 0);
  assert.equal(deflection(1), 1);
  assert.equal(deflection(-1), -1);
  assert.ok(deflection(0.2) > 0 && deflection(0.2) < 0.2);
});

test('the left stick drives, either one turns', () => {
  assert.equal(sticks([null, pad([1, 1], false)]), null);
  assert.deepEqual(sticks([null, pad([0, -1, 0, 0])]), [0, 1]);
  assert.deepEqual(sticks([pad([0, 0, -1, 0])]), [-1, 0]);
  assert.deepEqual(sticks([pad([1, 0, 0, 1])]), [1, 0]);
});
