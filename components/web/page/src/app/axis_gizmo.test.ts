import assert from 'node:assert/strict';
import test from 'node:test';
import { armsOf } from './axis_gizmo.ts';
import { quaternionOf } from '../connection/poses.ts';

const seen = (roll: number, pitch: number, yaw: number): string =>
  armsOf(quaternionOf(roll, pitch, yaw)).map(({ x, y, isNear }) => `${Math.round(x)} ${Math.round(y)} ${isNear}`).join(', ');

test('an eye that looks along x sees y to the left and z up', () => {
  assert.match(seen(0, 0, 0), /^-?0 -?0 false, -26 -?0 false, -?0 -26 false$/);
});

test('from above, north is up', () => {
  // looks down, with x up in the picture
  assert.match(seen(0, Math.PI / 2, 0), /^-?0 -26 (false|true), -26 -?0 (false|true), -?0 -?0 true$/);
});

test('an eye that looks along y sees x to the right', () => {
  assert.match(seen(0, 0, Math.PI / 2), /^26 -?0 (false|true), -?0 -?0 false, -?0 -26 (false|true)$/);
});
