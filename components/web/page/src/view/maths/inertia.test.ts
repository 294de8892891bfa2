import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { fromRollPitchYaw } from './placement.ts';
import { inertiaBox, leadRadius, principal } from './inertia.ts';

/// Moments of a box of mass 12 about its axes: m / 12 (b^2 + c^2), ...
function momentsOf(x: number, y: number, z: number): Vector3 {
  return new Vector3(y * y + z * z, x * x + z * z, x * x + y * y);
}

test('the box of a box is that box', () => {
  const i = momentsOf(1, 2, 3);
  const { size } = inertiaBox({ mass: 12, ixx: i.x, iyy: i.y, izz: i.z })!;
  assert.ok(size.distanceTo(new Vector3(1, 2, 3)) < 1e-9);
});

test('a turned box is found with its rotation', () => {
  const i = momentsOf(1, 2, 3);
  const rotation = fromRollPitchYaw(0.3, -0.4, 1.1);
  const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].map((axis) =>
    axis.applyQuaternion(rotation),
  );
  // the matrix R diag(moments) R^T
  const at = (a: 'x' | 'y' | 'z', b: 'x' | 'y' | 'z') =>
    [i.x, i.y, i.z].reduce((sum, moment, k) => sum + moment * axes[k]![a] * axes[k]![b], 0);
  const inertial = {
    mass: 12, ixx: at('x', 'x'), iyy: at('y', 'y'), izz: at('z', 'z'),
    ixy: at('x', 'y'), ixz: at('x', 'z'), iyz: at('y', 'z'),
  };
  const box = inertiaBox(inertial)!;
  const lengths = box.size.toArray().sort();
  assert.ok(lengths.every((length, k) => Math.abs(length - [1, 2, 3][k]!) < 1e-6), lengths.join(' '));
  // the longest side of the box is along z of the frame
  const longest = box.size.toArray().indexOf(Math.max(...box.size.toArray()));
  const side = new Vector3().setComponent(longest, 1).applyQuaternion(box.rotation);
  assert.ok(Math.abs(side.dot(axes[2]!)) > 1 - 1e-9);
});

test('principal moments keep their sum', () => {
  const { values } = principal(2, 3, 4, 0.5, -0.2, 0.1);
  assert.ok(Math.abs(values.x + values.y + values.z - 9) < 1e-9);
});

test('moments that no body can have give no box', () => {
  assert.equal(inertiaBox({ mass: 1, ixx: 1, iyy: 1, izz: 5 }), null);
  assert.equal(inertiaBox({ mass: 0, ixx: 1, iyy: 1, izz: 1 }), null);
  assert.equal(inertiaBox({ mass: 1, ixx: NaN, iyy: 1, izz: 1 }), null);
});

test('a litre of lead has 11.34 kg', () => {
  assert.ok(Math.abs((4 / 3) * Math.PI * leadRadius(11.34) ** 3 - 0.001) < 1e-9);
});
