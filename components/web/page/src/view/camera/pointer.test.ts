import assert from 'node:assert/strict';
import { test } from 'node:test';

import { gestureOf, wheelFactor } from './pointer.ts';

test("buttons are those of Fortress's window", () => {
  const gesture = (button: number, shiftKey = false) => gestureOf({ button, shiftKey, pointerType: 'mouse' });
  assert.equal(gesture(0), 'pan');
  assert.equal(gesture(0, true), 'turn');
  assert.equal(gesture(1), 'turn');
  assert.equal(gesture(2), 'zoom');
});

test('a finger turns', () => {
  assert.equal(gestureOf({ button: 0, shiftKey: false, pointerType: 'touch' }), 'turn');
});

test('the wheel goes nearer forwards, and as far back', () => {
  assert.ok(wheelFactor({ deltaY: -100, deltaMode: 0 }) < 1);
  const back = wheelFactor({ deltaY: 100, deltaMode: 0 }) * wheelFactor({ deltaY: -100, deltaMode: 0 });
  assert.ok(Math.abs(back - 1) < 1e-9);
});

test('lines and pages of the wheel are about as much as pixels', () => {
  assert.ok(Math.abs(wheelFactor({ deltaY: 3, deltaMode: 1 }) - wheelFactor({ deltaY: 48, deltaMode: 0 })) < 1e-9);
  assert.ok(wheelFactor({ deltaY: 1e9, deltaMode: 2 }) < 2);
});
