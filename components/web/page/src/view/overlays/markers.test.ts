import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, type LineSegments, type Mesh, type MeshBasicMaterial, type Object3D, Vector3 } from 'three';

import type { Message } from '../messages.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { cornersOf, Markers } from './markers.ts';

const visual = { id: 3, name: 'v', geometry: { type: 2, sphere: { radius: 1 } }, pose: { position: { z: 1 } } };
const link = [{ id: 2, name: 'l', visual: [visual] }];
const scene = { model: [{ id: 1, name: 'm', pose: { position: { x: 5 } }, link }] };

function shown(marker: Message): { markers: Markers; object: Object3D; stage: ReturnType<typeof stageOf> } {
  const stage = stageOf(scene);
  const markers = new Markers(stage);
  markers.set(new Map([['a', marker]]));
  return { markers, object: markers.group.children[0]!, stage };
}

function boundsOf(object: Object3D): number[] {
  const box = new Box3().setFromObject(object);
  return [...box.min.toArray(), ...box.max.toArray()].map((each) => Math.round(each * 1000) / 1000);
}

test('corners are those of lists, strips and fans', () => {
  assert.deepEqual(cornersOf(4, 5), [0, 1, 2, 3]);
  assert.deepEqual(cornersOf(3, 3), [0, 1, 1, 2]);
  assert.deepEqual(cornersOf(9, 7), [0, 1, 2, 3, 4, 5]);
  assert.deepEqual(cornersOf(10, 4), [0, 1, 2, 1, 2, 3]);
  assert.deepEqual(cornersOf(8, 4), [0, 1, 2, 0, 2, 3]);
  assert.deepEqual(cornersOf(9, 0), []);
});

test('simple shapes are 1 m large, times their scale', () => {
  assert.deepEqual(boundsOf(shown({ type: 1 }).object), [-0.5, -0.5, -0.5, 0.5, 0.5, 0.5]);
  const { object } = shown({ type: 6, scale: { x: 2, y: 4, z: 6 }, pose: { position: { x: 1 } } });
  assert.deepEqual(boundsOf(object), [0, -2, -3, 2, 2, 3]);
  assert.deepEqual(boundsOf(shown({ type: 12 }).object).slice(2), [0, 0.05, 0.05, 0.75]);
  assert.deepEqual(boundsOf(shown({ type: 13 }).object).slice(3), [0.75, 0.75, 0.75]);
});

test('colours and opacity are those of the material, and lines have their points', () => {
  const point = [{ x: 1 }, { x: 2, y: 1 }];
  const { object } = shown({ type: 3, point, material: { diffuse: { g: 1, a: 0.5 } } });
  const line = object.children[0] as LineSegments;
  assert.deepEqual([...line.geometry.getAttribute('position').array], [1, 0, 0, 2, 1, 0]);
  const material = line.material as unknown as MeshBasicMaterial;
  assert.deepEqual(material.color.toArray(), [0, 1, 0]);
  assert.equal(material.opacity, 0.5);
});

test('markers move with their parents, and are not seen without them', () => {
  const { markers, object, stage } = shown({ type: 1, parent: 'm::l::v' });
  const position = () => new Vector3().setFromMatrixPosition(object.matrix).toArray();
  assert.deepEqual(position(), [5, 0, 1]);
  stage.places.apply({
    timeNs: 0n, revision: 0, ids: new Uint32Array([2]), poses: new Float32Array([5, 7, 0, 0, 0, 0, 1]),
  });
  markers.update();
  assert.deepEqual(position(), [5, 7, 1]);
  assert.equal(shown({ type: 1, parent: 'nobody' }).object.visible, false);
  assert.equal(shown({ type: 1, parent: 'm' }).object.matrix.elements[12], 5);
});

test('those that stay are kept, and those that are gone are disposed of', () => {
  const box = { type: 1 };
  const { markers, object } = shown(box);
  const mesh = object.children[0] as Mesh;
  let isDisposed = false;
  mesh.geometry.addEventListener('dispose', () => (isDisposed = true));
  markers.set(new Map([['a', box], ['b', { type: 6 }]]));
  assert.equal(markers.group.children[0], object);
  markers.set(new Map([['a', { type: 2 }]]));
  assert.equal(isDisposed, true);
  assert.equal(markers.group.children.length, 1);
  markers.dispose();
  assert.equal(markers.group.children.length, 0);
});

test('parents are looked up by names that are made once per scene', () => {
  const { markers, object, stage } = shown({ type: 1, parent: 'm::l' });
  stage.setScene({ model: [{ id: 7, name: 'm', pose: { position: { x: 6 } }, link: [{ id: 8, name: 'l' }] }] });
  const { places } = stage.content as { places: Map<number, unknown> };
  const keys = places.keys.bind(places);
  let times = 0;
  places.keys = () => {
    ++times;
    return keys();
  };
  markers.update();
  assert.equal(object.matrix.elements[12], 6);
  markers.set(new Map(['a', 'b', 'c'].map((key) => [key, { type: 1, parent: 'm' }])));
  markers.update();
  assert.equal(times, 1);
  stage.setScene({});
  markers.update();
  assert.deepEqual(markers.group.children.map(({ visible }) => visible), [false, false, false]);
});

test('only markers with parents are moved', () => {
  const { markers, object } = shown({ type: 1, pose: { position: { x: 1 } } });
  assert.equal(object.matrix.elements[12], 1);
  object.updateMatrixWorld = () => assert.fail('it is moved');
  markers.update();
});
