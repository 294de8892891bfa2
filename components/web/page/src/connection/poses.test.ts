import assert from 'node:assert/strict';
import test from 'node:test';
import { parseSixfold, poseMessage, quaternionOf, rollPitchYawOf, sixfoldOf } from './poses.ts';

test('angles survive the way to a quaternion and back', () => {
  for (const angles of [[0, 0, 0], [0.1, -0.2, 0.3], [3, 1.5, -3], [-0.5, 0, 2]] as [number, number, number][]) {
    rollPitchYawOf(quaternionOf(...angles)).forEach((angle, i) => assert.ok(Math.abs(angle - angles[i]!) < 1e-9));
  }
});

test('a quarter turn about z leads x to y', () => {
  const [x, y, z, w] = quaternionOf(0, 0, Math.PI / 2);
  assert.ok(Math.abs(x) + Math.abs(y) < 1e-12);
  assert.ok(Math.abs(z - Math.SQRT1_2) + Math.abs(w - Math.SQRT1_2) < 1e-12);
});

test('a message that says nothing is no movement', () => {
  assert.deepEqual(sixfoldOf(undefined), [0, 0, 0, 0, 0, 0]);
  assert.deepEqual(sixfoldOf(poseMessage([1, 2, 3, 0, 0, 0])), [1, 2, 3, 0, 0, 0]);
});

test('only six numbers are a pose', () => {
  assert.deepEqual(parseSixfold(' 1 2 3\t0 0 -1 '), [1, 2, 3, 0, 0, -1]);
  assert.equal(parseSixfold('1 2 3'), null);
  assert.equal(parseSixfold('1 2 3 0 0 x'), null);
  assert.equal(parseSixfold(''), null);
});
