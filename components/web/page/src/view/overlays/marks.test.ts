import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, Mesh, TorusGeometry, Vector3 } from 'three';

import { noPlacement } from '../maths/placement.ts';
import { JointType } from '../messages.ts';
import { centreMark, frameMark, inertiaMark, jointMark } from './marks.ts';

function joint(type: JointType) {
  return {
    id: 1, name: 'j', type, place: 2, axes: [{ xyz: { x: 0, y: 0, z: 2 } }],
    X_PlaceJoint: { ...noPlacement(), position: new Vector3(1, 0, 0) },
  };
}

function count(mark: ReturnType<typeof jointMark>, kind: typeof TorusGeometry): number {
  let rings = 0;
  mark.traverse((part) => (rings += part instanceof Mesh && part.geometry instanceof kind ? 1 : 0));
  return rings;
}

test('the arrow of a joint goes along its axis from where the joint is', () => {
  const mark = jointMark(joint(JointType.revolute), 1);
  mark.updateMatrixWorld(true);
  const box = new Box3().setFromObject(mark);
  assert.ok(box.max.z > 1 && box.max.z < 1.2);
  assert.ok(box.min.z > -0.1);
  assert.ok(Math.abs(box.getCenter(new Vector3()).x - 1) < 0.3);
});

test('only what turns has a ring', () => {
  assert.equal(count(jointMark(joint(JointType.revolute), 1), TorusGeometry), 1);
  assert.equal(count(jointMark(joint(JointType.prismatic), 1), TorusGeometry), 0);
});

test('a heavier link has a larger ball, where its centre of mass is', () => {
  const size = (mass: number) => new Box3().setFromObject(centreMark({ mass })).getSize(new Vector3()).x;
  assert.ok(Math.abs(size(80) / size(10) - 2) < 0.01);
  assert.deepEqual(centreMark({ mass: 1, pose: { position: { z: 3 } } }).position.toArray(), [0, 0, 3]);
});

test('the box of inertia is as large as a box of that mass', () => {
  const mark = inertiaMark({ mass: 6, ixx: 1, iyy: 1, izz: 1 })!;
  assert.ok(mark.scale.distanceTo(new Vector3(1, 1, 1)) < 1e-9);
  assert.equal(inertiaMark({ mass: 1, ixx: 9 }), null);
});

test('a frame has its axes in their lengths', () => {
  const { min, max } = new Box3().setFromObject(frameMark(2));
  assert.deepEqual(max.toArray(), [2, 2, 2]);
  assert.ok(min.x > -0.1 && min.x < 0);
});
