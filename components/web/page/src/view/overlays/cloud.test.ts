import assert from 'node:assert/strict';
import { test } from 'node:test';

import { pointsOf } from './cloud.ts';

const xyz = ['x', 'y', 'z'].map((name, i) => ({ name, offset: i * 4, datatype: 6 }));

function cloud(points: number[][], field: object[] = xyz, pointStep = 12) {
  const data = new DataView(new ArrayBuffer(points.length * pointStep));
  points.forEach((point, i) => point.forEach((value, k) => data.setFloat32(i * pointStep + k * 4, value, true)));
  return { field, pointStep, width: points.length, height: 1, data: new Uint8Array(data.buffer) };
}

test('points are read where the fields say', () => {
  assert.deepEqual([...pointsOf(cloud([[1, 2, 3], [4, 5, 6]])).places], [1, 2, 3, 4, 5, 6]);
  const turned = [{ ...xyz[0], offset: 8 }, xyz[1]!, { ...xyz[2], offset: 0 }];
  assert.deepEqual([...pointsOf(cloud([[1, 2, 3]], turned)).places], [3, 2, 1]);
});

test('what is not finite is left out', () => {
  assert.deepEqual([...pointsOf(cloud([[Infinity, 0, 0], [1, 2, 3], [0, NaN, 0]])).places], [1, 2, 3]);
});

test('colours are those of the cloud', () => {
  const message = cloud([[1, 2, 3, 0]], [...xyz, { name: 'rgb', offset: 12, datatype: 6 }], 16);
  new DataView(message.data.buffer).setUint32(12, 0xff8000, true);
  const { colors } = pointsOf(message);
  assert.equal(colors[0], 1);
  assert.ok(Math.abs(colors[1]! - 128 / 255) < 1e-6);
  assert.equal(colors[2], 0);
});

test('a cloud that says more than it has, or has no places, is no more than it is', () => {
  assert.equal(pointsOf({ ...cloud([[1, 2, 3]]), width: 1000 }).places.length, 3);
  assert.equal(pointsOf(cloud([[1, 2, 3]], xyz.slice(1))).places.length, 0);
  assert.equal(pointsOf({}).places.length, 0);
  assert.equal(pointsOf({ ...cloud([[1, 2, 3]]), field: xyz.map((each) => ({ ...each, offset: 99 })) }).places.length, 0);
});

test('of a large cloud every n-th point is shown', () => {
  const count = 700_000;
  const data = new Uint8Array(count * 12);
  const { places } = pointsOf({ field: xyz, pointStep: 12, width: count, height: 1, data });
  assert.ok(places.length / 3 <= 300_000 && places.length / 3 > 200_000);
});
