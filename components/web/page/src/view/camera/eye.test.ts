import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { fromRollPitchYaw } from '../maths/placement.ts';
import { Eye } from './eye.ts';

function eyeAt(x: number, y: number, z: number, pitch: number): Eye {
  const eye = new Eye();
  eye.resize(200, 100);
  eye.placement = { position: new Vector3(x, y, z), rotation: fromRollPitchYaw(0, pitch, 0) };
  return eye;
}

test('the ray through the middle goes where the eye looks', () => {
  const { ray } = eyeAt(-5, 1, 2, 0).rayThrough(0.5, 0.5);
  assert.ok(ray.direction.distanceTo(new Vector3(1, 0, 0)) < 1e-9);
  assert.ok(ray.origin.distanceTo(new Vector3(-5, 1, 2)) < 1e-9);
});

test('to the right in the picture is -y, to its top is z', () => {
  const eye = eyeAt(-5, 0, 2, 0);
  assert.ok(eye.rayThrough(0.9, 0.5).ray.direction.y < -0.1);
  assert.ok(eye.rayThrough(0.5, 0.1).ray.direction.z > 0.1);
});

test('looking at a ball has it in the middle and inside the picture', () => {
  const eye = eyeAt(-5, 0, 2, 0.3);
  eye.lookAt(new Vector3(10, 10, 0), 2);
  const middle = new Vector3(10, 10, 0).project(eye.camera);
  assert.ok(Math.abs(middle.x) < 1e-6 && Math.abs(middle.y) < 1e-6);
  assert.ok(Math.abs(new Vector3(10, 10, 2).project(eye.camera).y) < 1);
});

test('turning around something at another distance keeps the eye where it is', () => {
  const eye = eyeAt(-5, 0, 2, 0.3);
  const before = eye.placement.position;
  eye.turnAround(1);
  assert.ok(eye.placement.position.distanceTo(before) < 1e-9);
});

test('the eye goes along', () => {
  const eye = eyeAt(-5, 0, 2, 0);
  eye.shift(new Vector3(0, 3, 0));
  assert.ok(eye.placement.position.distanceTo(new Vector3(-5, 3, 2)) < 1e-9);
});
