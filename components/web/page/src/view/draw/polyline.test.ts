import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BufferGeometry, Mesh, MeshBasicMaterial, Raycaster, Vector3 } from 'three';

import { polylineGeometry } from './polyline.ts';

function square(half: number, height: number) {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]];
  return { height, point: corners.map(([x, y]) => ({ x: x! * half, y: y! * half })) };
}

/// Height at which a vertical ray from above enters the geometry.
function top(geometry: BufferGeometry, x: number, y: number): number | undefined {
  const ray = new Raycaster(new Vector3(x, y, 10), new Vector3(0, 0, -1));
  return ray.intersectObject(new Mesh(geometry, new MeshBasicMaterial()))[0]?.point.z;
}

test('a line is the foot of what stands on it', () => {
  const geometry = polylineGeometry([square(1, 2)]);
  geometry.computeBoundingBox();
  assert.deepEqual(geometry.boundingBox!.min.toArray(), [-1, -1, 0]);
  assert.deepEqual(geometry.boundingBox!.max.toArray(), [1, 1, 2]);
  assert.equal(top(geometry, 0.1, 0.2), 2);
});

test('a line in another one is a hole, and one in a hole stands again', () => {
  const geometry = polylineGeometry([square(3, 2), square(2, 2), square(1, 2)]);
  assert.equal(top(geometry, 2.5, 0.1), 2);
  assert.equal(top(geometry, 1.5, 0.1), undefined);
  assert.equal(top(geometry, 0.5, 0.1), 2);
});

test('two points are no line', () => {
  const geometry = polylineGeometry([{ height: 1, point: [{ x: 0 }, { x: 1 }] }]);
  assert.equal(geometry.getAttribute('position')?.count ?? 0, 0);
});
