import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { fromRollPitchYaw } from '../maths/placement.ts';
import {
  type Orbit, eyeOf, fitted, from, homeOrbit, orbitFrom, panned, placementOfEye, rotationOfCamera, turned, zoomed,
} from './orbit.ts';

function near(a: Vector3, b: Vector3, tolerance = 1e-9): void {
  assert.ok(a.distanceTo(b) < tolerance, `${a.toArray()} is not ${b.toArray()}`);
}

const along: Orbit = { target: new Vector3(10, 0, 0), distance: 10, yaw: 0, pitch: 0 };

test("home is Fortress's first view", () => {
  near(eyeOf(homeOrbit()), new Vector3(-6, 0, 6));
  assert.ok(Math.abs(homeOrbit().pitch - 0.5) < 1e-9);
  assert.ok(Math.abs(homeOrbit().target.z) < 1e-9, 'it looks at the ground');
});

test('a pose goes through', () => {
  const X = { position: new Vector3(1, 2, 3), rotation: fromRollPitchYaw(0, 0.3, -2) };
  const { position, rotation } = placementOfEye(orbitFrom(X));
  near(position, X.position);
  assert.ok(Math.abs(rotation.dot(X.rotation)) > 1 - 1e-9);
});

test('an eye that looks straight down does not flip', () => {
  const orbit = orbitFrom({ position: new Vector3(0, 0, 5), rotation: fromRollPitchYaw(0, Math.PI / 2, 0) });
  near(eyeOf(orbit), new Vector3(0, 0, 5), 0.01);
});

test("three's camera looks ahead with z up", () => {
  const rotation = rotationOfCamera(along);
  near(new Vector3(0, 0, -1).applyQuaternion(rotation), new Vector3(1, 0, 0));
  near(new Vector3(0, 1, 0).applyQuaternion(rotation), new Vector3(0, 0, 1));
});

test('turning keeps the target and stops at the poles', () => {
  const orbit = turned(along, 0.25, 10);
  near(orbit.target, along.target);
  assert.ok(orbit.pitch < Math.PI / 2);
  assert.ok(eyeOf(orbit).z > 9.9);
});

test('panning takes the world along', () => {
  // the whole height of the picture is 20 m at the target with a field of view of 90 degrees
  const orbit = panned(along, 0.5, 0, Math.PI / 2);
  near(orbit.target, new Vector3(10, 10, 0));
  near(panned(along, 0, 0.5, Math.PI / 2).target, new Vector3(10, 0, 10));
});

test('zooming keeps what is under the pointer', () => {
  const direction = new Vector3(1, 0.5, 0.2).normalize();
  const before = eyeOf(along);
  const orbit = zoomed(along, 0.5, direction);
  const way = eyeOf(orbit).sub(before);
  near(way.clone().normalize(), direction);
  assert.ok(Math.abs(way.x - 5) < 1e-9);
});

test('zooming ends before the target and before the end of the world', () => {
  assert.ok(zoomed(along, 0, null).distance > 0);
  assert.ok(zoomed(along, 1e9, null).distance < 1e4);
});

test('a ball fits into a narrow picture too', () => {
  const wide = fitted(along, new Vector3(1, 2, 3), 2, Math.PI / 3, 2);
  const narrow = fitted(along, new Vector3(1, 2, 3), 2, Math.PI / 3, 0.5);
  near(wide.target, new Vector3(1, 2, 3));
  assert.ok(wide.distance > 4);
  assert.ok(narrow.distance > wide.distance * 1.5);
});

test('sides are those of the axes', () => {
  near(eyeOf(from(along, 'front')), new Vector3(20, 0, 0));
  near(eyeOf(from(along, 'back')), new Vector3(0, 0, 0));
  near(eyeOf(from(along, 'left')), new Vector3(10, 10, 0));
  near(eyeOf(from(along, 'right')), new Vector3(10, -10, 0));
  assert.ok(eyeOf(from(along, 'top')).z > 9.9);
  assert.ok(eyeOf(from(along, 'bottom')).z < -9.9);
  near(eyeOf(from(along, 'home')), new Vector3(-6, 0, 6));
});
