import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { groundGeometry } from './heightmap.ts';

const picture = { width: 2, height: 2, pixels: Uint8Array.from([0, 100, 50, 200]) };

function placesOf(geometry: ReturnType<typeof groundGeometry>): number[][] {
  const places = geometry.getAttribute('position');
  return Array.from({ length: places.count }, (_, i) => [places.getX(i), places.getY(i), places.getZ(i)]);
}

test('the brightest pixel is as high as the size, the top of the picture is towards y', () => {
  const ground = groundGeometry(picture, new Vector3(4, 2, 8), new Vector3(0, 0, 1));
  assert.deepEqual(placesOf(ground), [
    [-1, 0.5, 1],
    [1, 0.5, 5],
    [-1, -0.5, 3],
    [1, -0.5, 9],
  ]);
});

test('the ground is seen from above', () => {
  const ground = groundGeometry(picture, new Vector3(1, 1, 0.1), new Vector3());
  const normals = ground.getAttribute('normal');
  for (let i = 0; i < normals.count; ++i) assert.ok(normals.getZ(i) > 0.5);
  assert.equal(ground.index!.count, 6);
});

test('a black picture is flat, and one pixel is no ground', () => {
  const flat = groundGeometry({ width: 2, height: 2, pixels: new Uint8Array(4) }, new Vector3(1, 1, 5), new Vector3());
  assert.ok(placesOf(flat).every(([, , z]) => z === 0));
  const dot = groundGeometry({ width: 1, height: 1, pixels: new Uint8Array(1) }, new Vector3(1, 1, 1), new Vector3());
  assert.equal(dot.index!.count, 0);
});
