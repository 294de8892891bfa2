import assert from 'node:assert/strict';
import test from 'node:test';
import { knobAt } from './joystick.ts';

test('the knob is under the pointer, and stays on the pad', () => {
  assert.deepEqual(knobAt(0.5, -0.25), [0.5, 0.25]);
  assert.deepEqual(knobAt(0, -3), [0, 1]);
  const [right, up] = knobAt(4, 3);
  assert.ok(Math.abs(right - 0.8) < 1e-12 && Math.abs(up + 0.6) < 1e-12);
});
