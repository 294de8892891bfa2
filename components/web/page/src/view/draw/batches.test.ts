import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BoxGeometry, InstancedMesh, Matrix4, Raycaster, Vector3 } from 'three';

import { noPlacement } from '../maths/placement.ts';
import { plainStyle } from '../scene/stage_for_tests.ts';
import { Batches, type Item } from './batches.ts';
import { Materials } from './materials.ts';
import { greyPaint, type Rgb } from './paint.ts';
import { Textures } from './textures.ts';

const box = new BoxGeometry();

function batches(): Batches {
  const textures = new Textures(() => Promise.reject(new Error('no files')), () => {}, () => {});
  return new Batches(new Materials(textures, ''));
}

function boxAt(place: number, diffuse: Rgb = [1, 0, 0]): Item {
  return {
    visual: {
      id: place + 1000, name: '', place, X_PlaceShape: noPlacement(), geometry: {}, material: undefined,
      castsShadows: true, transparency: 0,
    },
    geometry: box,
    geometryKey: 'box',
    paint: { ...greyPaint, diffuse },
    M_PlaceForm: new Matrix4().makeScale(2, 2, 2),
    isGround: false,
    castsShadows: true,
  };
}

function at(x: number): Matrix4 {
  return new Matrix4().makeTranslation(x, 0, 0);
}

function fromAbove(x: number): Raycaster {
  return new Raycaster(new Vector3(x, 0.3, 10), new Vector3(0, 0, -1));
}

test('a thousand boxes of all colours are one mesh', () => {
  const all = batches();
  for (let i = 1; i <= 1000; ++i) all.add(boxAt(i, [i / 1000, 0, 0]), plainStyle, at(i * 3));
  assert.equal(all.group.children.length, 1);
  const mesh = all.group.children[0] as InstancedMesh;
  assert.equal(mesh.count, 1000);
  const matrix = new Matrix4();
  mesh.getMatrixAt(999, matrix);
  assert.deepEqual(new Vector3().setFromMatrixPosition(matrix).toArray(), [3000, 0, 0]);
  assert.ok(Math.abs(mesh.instanceColor!.getX(499) - 0.5) < 1e-6);
});

test('only what stands in the place moves', () => {
  const all = batches();
  all.add(boxAt(1), plainStyle, at(0));
  all.add(boxAt(2), plainStyle, at(10));
  all.move(2, at(20));
  assert.deepEqual(all.meet(fromAbove(0.1)).map(({ item }) => item.visual.place), [1]);
  assert.deepEqual(all.meet(fromAbove(20.1)).map(({ item }) => item.visual.place), [2]);
  assert.equal(all.meet(fromAbove(10.1)).length, 0);
});

test('a ray meets the nearest first, with the size of the item', () => {
  const all = batches();
  all.add(boxAt(1), plainStyle, at(0));
  all.add(boxAt(2), plainStyle, new Matrix4().makeTranslation(0, 0, 5));
  const met = all.meet(fromAbove(0.9));
  assert.equal(met[0]!.item.visual.place, 2);
  assert.equal(met[0]!.hit.point.z, 6);
});

test('bounds are those of all in a place', () => {
  const all = batches();
  all.add(boxAt(1), plainStyle, at(50));
  assert.deepEqual(all.boundsInPlace(1).max.toArray(), [1, 1, 1]);
  assert.ok(all.boundsInPlace(7).isEmpty());
});

test('ground and what casts no shadow are no casters', () => {
  const all = batches();
  all.add({ ...boxAt(1), isGround: true }, plainStyle, at(0));
  all.add({ ...boxAt(1), castsShadows: false }, plainStyle, at(0));
  assert.ok(all.castersInPlace(1).isEmpty());
  all.add(boxAt(1), plainStyle, at(0));
  assert.deepEqual(all.castersInPlace(1).max.toArray(), [1, 1, 1]);
});

test('what is not to be seen is not drawn', () => {
  const all = batches();
  all.add({ ...boxAt(1), paint: { ...greyPaint, opacity: 0 } }, plainStyle, at(0));
  assert.equal(all.group.children.length, 0);
});
