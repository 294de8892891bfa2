import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, Vector3 } from 'three';

import { matrixOf } from '../maths/placement.ts';
import { type GeometryMessage, GeometryType } from '../messages.ts';
import { formOf } from './shapes.ts';

function boundsOf(geometry: GeometryMessage): Box3 {
  const form = formOf(geometry)!;
  const made = form.make().applyMatrix4(matrixOf(form.X_ShapeForm, form.scale));
  made.computeBoundingBox();
  return made.boundingBox!;
}

function sizeOf(geometry: GeometryMessage): number[] {
  return boundsOf(geometry).getSize(new Vector3()).toArray().map((value) => Math.round(value * 1000) / 1000);
}

test('shapes are as large as they say, with z along their length', () => {
  assert.deepEqual(sizeOf({ type: GeometryType.box, box: { size: { x: 1, y: 2, z: 3 } } }), [1, 2, 3]);
  assert.deepEqual(sizeOf({ type: GeometryType.sphere, sphere: { radius: 2 } }), [4, 4, 4]);
  assert.deepEqual(sizeOf({ type: GeometryType.cylinder, cylinder: { radius: 1, length: 5 } }), [2, 2, 5]);
  assert.deepEqual(sizeOf({ type: GeometryType.cone, cone: { radius: 1, length: 5 } }), [2, 2, 5]);
  assert.deepEqual(sizeOf({ type: GeometryType.capsule, capsule: { radius: 1, length: 5 } }), [2, 2, 7]);
  assert.deepEqual(sizeOf({ type: GeometryType.ellipsoid, ellipsoid: { radii: { x: 1, y: 2, z: 3 } } }), [2, 4, 6]);
});

test('a box without a type is one, for its number is 0', () => {
  assert.deepEqual(sizeOf({ box: { size: { x: 1, y: 1, z: 1 } } }), [1, 1, 1]);
});

test('the tip of a cone is up', () => {
  const form = formOf({ type: GeometryType.cone, cone: { radius: 1, length: 2 } })!;
  const points = form.make().getAttribute('position');
  for (let i = 0; i < points.count; ++i) {
    if (points.getZ(i) > 0.49) assert.ok(Math.hypot(points.getX(i), points.getY(i)) < 1e-6);
  }
});

test('a plane stands across its normal', () => {
  assert.deepEqual(sizeOf({ type: GeometryType.plane, plane: { normal: { z: 1 }, size: { x: 4, y: 2 } } }), [4, 2, 0]);
  const wall = sizeOf({ type: GeometryType.plane, plane: { normal: { x: 1 }, size: { x: 4, y: 4 } } });
  assert.deepEqual(wall, [0, 4, 4]);
});

test('equal shapes of other sizes share a geometry', () => {
  const key = (radius: number) => formOf({ type: GeometryType.sphere, sphere: { radius } })!.key;
  assert.equal(key(1), key(2));
});

test('what is no shape has no form', () => {
  for (const type of [GeometryType.mesh, GeometryType.empty, GeometryType.image, 99]) {
    assert.equal(formOf({ type }), null);
  }
});
