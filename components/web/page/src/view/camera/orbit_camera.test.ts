import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MOUSE, TOUCH, Vector3 } from 'three';

import { fromRollPitchYaw } from '../maths/placement.ts';
import { OrbitCamera } from './orbit_camera.ts';
import { wheelSpeed } from './pointer.ts';

function near(a: Vector3, b: Vector3, tolerance = 1e-9): void {
  assert.ok(a.distanceTo(b) < tolerance, `${a.toArray()} is not ${b.toArray()}`);
}

function cameraAt(x: number, y: number, z: number, pitch: number): OrbitCamera {
  const orbit = new OrbitCamera();
  orbit.resize(200, 100);
  orbit.placement = { position: new Vector3(x, y, z), rotation: fromRollPitchYaw(0, pitch, 0) };
  return orbit;
}

/// A camera that looks along x, at a target at (10, 0, 0), from a distance of 10 m.
function cameraAlongX(): OrbitCamera {
  const orbit = cameraAt(0, 0, 0, 0);
  near(orbit.target, new Vector3(10, 0, 0));
  return orbit;
}

/// A fake element of 200 x 100 pixels that dispatches events.
function elementFor(orbit: OrbitCamera) {
  const element = Object.assign(new EventTarget(), {
    clientWidth: 200, clientHeight: 100, style: {}, ownerDocument: new EventTarget(), getRootNode: () => element,
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 200, height: 100 }),
    setPointerCapture: () => {}, releasePointerCapture: () => {},
  });
  orbit.controls.connect(element as unknown as HTMLElement);
  return element;
}

function wheel(orbit: OrbitCamera, deltaY: number, deltaMode = 0, clientX = 100, clientY = 50): void {
  orbit.controls.zoomSpeed = wheelSpeed({ deltaY, deltaMode });
  const element = orbit.controls.domElement ?? elementFor(orbit);
  element.dispatchEvent(Object.assign(new Event('wheel'), { deltaY, deltaMode, clientX, clientY }));
}

test('the ray through the middle goes where the camera looks', () => {
  const { ray } = cameraAt(-5, 1, 2, 0).rayThrough(0.5, 0.5);
  assert.ok(ray.direction.distanceTo(new Vector3(1, 0, 0)) < 1e-9);
  assert.ok(ray.origin.distanceTo(new Vector3(-5, 1, 2)) < 1e-9);
});

test('to the right in the picture is -y, to its top is z', () => {
  const orbit = cameraAt(-5, 0, 2, 0);
  assert.ok(orbit.rayThrough(0.9, 0.5).ray.direction.y < -0.1);
  assert.ok(orbit.rayThrough(0.5, 0.1).ray.direction.z > 0.1);
});

test('looking at a ball has it in the middle and inside the picture', () => {
  const orbit = cameraAt(-5, 0, 2, 0.3);
  orbit.lookAt(new Vector3(10, 10, 0), 2);
  const middle = new Vector3(10, 10, 0).project(orbit.camera);
  assert.ok(Math.abs(middle.x) < 1e-6 && Math.abs(middle.y) < 1e-6);
  assert.ok(Math.abs(new Vector3(10, 10, 2).project(orbit.camera).y) < 1);
});

test('a ball fits into a narrow picture too', () => {
  const orbit = cameraAlongX();
  orbit.lookAt(new Vector3(1, 2, 3), 2);
  const wide = orbit.controls.getDistance();
  near(orbit.target, new Vector3(1, 2, 3));
  orbit.resize(50, 100);
  orbit.lookAt(new Vector3(1, 2, 3), 2);
  assert.ok(wide > 4);
  assert.ok(orbit.controls.getDistance() > wide * 1.5);
});

test('turning around something at another distance keeps the camera where it is', () => {
  const orbit = cameraAt(-5, 0, 2, 0.3);
  const before = orbit.placement.position;
  orbit.turnAround(1);
  assert.ok(orbit.placement.position.distanceTo(before) < 1e-9);
  assert.ok(Math.abs(orbit.controls.getDistance() - 1) < 1e-9);
});

test('a shift moves the camera and its target', () => {
  const orbit = cameraAt(-5, 0, 2, 0);
  orbit.shift(new Vector3(0, 3, 0));
  assert.ok(orbit.placement.position.distanceTo(new Vector3(-5, 3, 2)) < 1e-9);
});

test("home is Fortress's first view", () => {
  const orbit = new OrbitCamera();
  near(orbit.placement.position, new Vector3(-6, 0, 6));
  assert.ok(Math.abs(orbit.placement.rotation.dot(fromRollPitchYaw(0, 0.5, 0))) > 1 - 1e-9);
  assert.ok(Math.abs(orbit.target.z) < 1e-9, 'it looks at the ground');
});

test('a pose goes through', () => {
  const X = { position: new Vector3(1, 2, 3), rotation: fromRollPitchYaw(0, 0.3, -2) };
  const orbit = new OrbitCamera();
  orbit.placement = X;
  const { position, rotation } = orbit.placement;
  near(position, X.position);
  assert.ok(Math.abs(rotation.dot(X.rotation)) > 1 - 1e-9);
});

test('a camera that looks straight down does not flip', () => {
  const orbit = cameraAt(0, 0, 5, Math.PI / 2);
  near(orbit.placement.position, new Vector3(0, 0, 5), 0.01);
  near(new Vector3(0, 1, 0).applyQuaternion(orbit.camera.quaternion), new Vector3(1, 0, 0), 0.01);
});

test("three's camera looks ahead with z up", () => {
  const rotation = cameraAlongX().camera.quaternion;
  near(new Vector3(0, 0, -1).applyQuaternion(rotation), new Vector3(1, 0, 0));
  near(new Vector3(0, 1, 0).applyQuaternion(rotation), new Vector3(0, 0, 1));
});

test('turning keeps the target and stops at the poles', () => {
  const orbit = cameraAlongX();
  orbit.turn(0.25, 10);
  near(orbit.target, new Vector3(10, 0, 0));
  assert.ok(Math.abs(orbit.camera.up.dot(orbit.rayThrough(0.5, 0.5).ray.direction)) < 1);
  assert.ok(orbit.camera.position.z > 9.9);
});

test('panning takes the world along', () => {
  const orbit = cameraAlongX();
  elementFor(orbit);
  // height of the view at the target [m], for 100 pixels
  const height = 2 * 10 * Math.tan(1.05 / 2);
  orbit.controls.pan(50, 0);
  near(orbit.target, new Vector3(10, height / 2, 0));
  orbit.controls.pan(-50, 50);
  near(orbit.target, new Vector3(10, 0, height / 2));
});

test('zooming keeps what is under the pointer', () => {
  const orbit = cameraAlongX();
  const { ray } = orbit.rayThrough(0.7, 0.4);
  wheel(orbit, -200, 0, 140, 40);
  const path = orbit.camera.position.clone().sub(ray.origin);
  assert.ok(path.length() > 1);
  near(path.normalize(), ray.direction, 1e-6);
});

test('zooming ends before the target and before the end of the world', () => {
  const orbit = cameraAlongX();
  orbit.zoom(0);
  assert.ok(orbit.controls.getDistance() > 0);
  orbit.zoom(1e9);
  assert.ok(orbit.controls.getDistance() < 1e4);
});

test('the wheel goes nearer forwards, and as far back', () => {
  const orbit = cameraAlongX();
  wheel(orbit, -100);
  assert.ok(Math.abs(orbit.controls.getDistance() / 10 - Math.exp(-0.2)) < 1e-9);
  wheel(orbit, 100);
  assert.ok(Math.abs(orbit.controls.getDistance() - 10) < 1e-9);
});

test('lines and pages of the wheel are about as much as pixels', () => {
  const [lines, pixels, pages] = [cameraAlongX(), cameraAlongX(), cameraAlongX()];
  wheel(lines, 3, 1);
  wheel(pixels, 48, 0);
  assert.ok(Math.abs(lines.controls.getDistance() - pixels.controls.getDistance()) < 1e-9);
  wheel(pages, 1e9, 2);
  assert.ok(pages.controls.getDistance() > 10 && pages.controls.getDistance() < 20);
});

test("buttons are those of Fortress's window, and a finger turns", () => {
  const { mouseButtons, touches } = new OrbitCamera().controls;
  assert.deepEqual(mouseButtons, { LEFT: MOUSE.PAN, MIDDLE: MOUSE.ROTATE, RIGHT: MOUSE.DOLLY });
  assert.deepEqual(touches, { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN });
});

test('sides are those of the axes', () => {
  const orbit = cameraAlongX();
  const from = (direction: Parameters<OrbitCamera['lookFrom']>[0]) => {
    orbit.lookFrom(direction);
    return orbit.camera.position;
  };
  near(from('front'), new Vector3(20, 0, 0));
  near(from('back'), new Vector3(0, 0, 0));
  near(from('left'), new Vector3(10, 10, 0));
  near(from('right'), new Vector3(10, -10, 0));
  assert.ok(from('top').z > 9.9);
  assert.ok(from('bottom').z < -9.9);
  near(from('home'), new Vector3(-6, 0, 6));
});

test('in parallel projection size does not depend on distance, and that at the target stays', () => {
  const eye = new OrbitCamera();
  eye.resize(400, 400);
  eye.placement = { position: new Vector3(-10, 0, 0), rotation: fromRollPitchYaw(0, 0, 0) };
  const heightOf = (x: number): number => new Vector3(x, 0, 1).project(eye.camera).y - new Vector3(x, 0, 0).project(eye.camera).y;
  const before = heightOf(0);
  eye.isParallel = true;
  assert.ok(Math.abs(heightOf(0) - before) < 1e-9);
  assert.ok(Math.abs(heightOf(30) - before) < 1e-9);
  // a click off the middle goes straight ahead
  const { ray } = eye.rayThrough(0.75, 0.5);
  assert.ok(Math.abs(ray.direction.x - 1) < 1e-9 && ray.origin.y < -1 && Math.abs(ray.origin.z) < 1e-9);
  eye.zoom(2);
  assert.ok(Math.abs(heightOf(30) - before / 2) < 1e-6);
  eye.isParallel = false;
  assert.ok(heightOf(30) < heightOf(0));
});
