import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { fromRollPitchYaw, inverse, matrixOf, placementOf, placementOfPose, poseOf, times } from './placement.ts';

function near(a: Vector3, b: Vector3): void {
  assert.ok(a.distanceTo(b) < 1e-12, `${a.toArray()} is not ${b.toArray()}`);
}

test('a pose that is not set is the origin', () => {
  const none = placementOf(undefined);
  assert.deepEqual(none.position.toArray(), [0, 0, 0]);
  assert.deepEqual(none.rotation.toArray(), [0, 0, 0, 1]);
});

test('zeros are no rotation, and what is not a number is nothing', () => {
  assert.deepEqual(placementOf({ orientation: {} }).rotation.toArray(), [0, 0, 0, 1]);
  assert.deepEqual(placementOf({ position: { x: Infinity, y: NaN, z: 1 } }).position.toArray(), [0, 0, 1]);
  assert.deepEqual(placementOf({ orientation: { w: NaN } }).rotation.toArray(), [0, 0, 0, 1]);
});

test('frames are chained from the outside to the inside', () => {
  const X_AB = { position: new Vector3(1, 0, 0), rotation: fromRollPitchYaw(0, 0, Math.PI / 2) };
  const X_BC = { position: new Vector3(2, 0, 0), rotation: fromRollPitchYaw(0, 0, 0) };
  near(times(X_AB, X_BC).position, new Vector3(1, 2, 0));
});

test('a frame and its inverse are nothing', () => {
  const X = { position: new Vector3(1, 2, 3), rotation: fromRollPitchYaw(0.1, 0.2, 0.3) };
  const none = times(X, inverse(X));
  near(none.position, new Vector3());
  assert.ok(none.rotation.w > 1 - 1e-12);
});

test('scaling comes before turning', () => {
  const X = { position: new Vector3(), rotation: fromRollPitchYaw(0, 0, Math.PI / 2) };
  near(new Vector3(1, 1, 1).applyMatrix4(matrixOf(X, new Vector3(3, 1, 1))), new Vector3(-1, 3, 1));
});

test('roll, pitch and yaw are about the axes of the outer frame', () => {
  const q = fromRollPitchYaw(Math.PI / 2, 0, Math.PI / 2);
  near(new Vector3(0, 1, 0).applyQuaternion(q), new Vector3(0, 0, 1));
  near(new Vector3(1, 0, 0).applyQuaternion(q), new Vector3(0, 1, 0));
});

test('poses go through unchanged', () => {
  const pose = poseOf(placementOfPose({ position: [1, 2, 3], orientation: [0, 0, 0, 2] }));
  assert.deepEqual(pose, { position: [1, 2, 3], orientation: [0, 0, 0, 1] });
});
