import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';

import { contentOf } from './content.ts';
import { type Frame, Places } from './places.ts';

const scene = {
  model: [
    { id: 1, pose: { position: { x: 1 } }, link: [{ id: 2, pose: { position: { z: 1 } } }] },
    { id: 3, link: [{ id: 4 }] },
  ],
};

function frame(...poses: [id: number, x: number, y: number, z: number][]): Frame {
  return {
    timeNs: 0n,
    revision: 1,
    ids: new Uint32Array(poses.map(([id]) => id)),
    poses: new Float32Array(poses.flatMap(([, x, y, z]) => [x, y, z, 0, 0, 0, 1])),
  };
}

function made(): Places {
  const places = new Places();
  places.set(contentOf(scene).places);
  return places;
}

test('of a new scene everything has moved, and then nothing', () => {
  const places = made();
  assert.deepEqual(places.takeMoved().sort(), [1, 2, 3, 4]);
  assert.deepEqual(places.takeMoved(), []);
});

test('frames move what they name and nothing else', () => {
  const places = made();
  places.takeMoved();
  assert.ok(places.apply(frame([4, 7, 8, 9])));
  assert.deepEqual(places.takeMoved(), [4]);
  assert.deepEqual(places.position(4)!.toArray(), [7, 8, 9]);
  assert.deepEqual(places.position(2)!.toArray(), [1, 0, 1]);
});

test('what nobody knows, and a frame that is cut short, do nothing', () => {
  const places = made();
  places.takeMoved();
  assert.equal(places.apply(frame([99, 0, 0, 0])), false);
  assert.equal(places.apply({ ...frame([4, 1, 1, 1]), poses: new Float32Array(6) }), false);
  assert.deepEqual(places.takeMoved(), []);
});

test('what has flown apart stays where it was last', () => {
  const places = made();
  places.takeMoved();
  places.apply(frame([2, 7, 8, NaN], [4, Infinity, 0, 0]));
  assert.deepEqual(places.takeMoved(), []);
  assert.deepEqual(places.position(2)!.toArray(), [1, 0, 1]);
});

test('what trembles in its place has not moved, what creeps has', () => {
  const places = made();
  places.takeMoved();
  assert.equal(places.apply(frame([4, 1e-6, 0, 0])), false);
  assert.equal(places.apply(frame([4, -1e-6, 0, 0])), false);
  assert.deepEqual(places.takeMoved(), []);
  let moves = 0;
  for (let i = 1; i <= 100; ++i) moves += places.apply(frame([4, i * 1e-6, 0, 0])) ? 1 : 0;
  assert.ok(moves > 30 && moves < 70);
  assert.ok(Math.abs(places.position(4)!.x - 1e-4) < 3e-6);
});

test('a held model is shown where it is held, with its links', () => {
  const places = made();
  places.takeMoved();
  places.hold(1, { position: new Vector3(10, 0, 0), rotation: new Quaternion() });
  assert.deepEqual(places.takeMoved().sort(), [1, 2]);
  assert.deepEqual(places.position(2)!.toArray(), [10, 0, 1]);
  // meanwhile the simulation moves it
  places.apply(frame([1, 1, 0, -5], [2, 1, 0, -4]));
  assert.deepEqual(places.position(1)!.toArray(), [10, 0, 0]);
  assert.deepEqual(places.position(2)!.toArray(), [10, 0, 1]);
  places.hold(1, null);
  assert.deepEqual(places.takeMoved().sort(), [1, 2]);
  assert.deepEqual(places.position(2)!.toArray(), [1, 0, -4]);
});

test('lights and sensors go with their link', () => {
  const places = new Places();
  const light = [{ id: 3, pose: { position: { z: 1 } } }];
  places.set(contentOf({ model: [{ id: 1, link: [{ id: 2, light }] }], light: [{ id: 4 }] }).places);
  places.takeMoved();
  places.apply(frame([2, 5, 0, 0], [4, 0, 0, 9]));
  assert.deepEqual(places.takeMoved().sort(), [2, 3, 4]);
  assert.deepEqual(places.position(3)!.toArray(), [5, 0, 1]);
  assert.deepEqual(places.position(4)!.toArray(), [0, 0, 9]);
});

test('what is held may be taken to be there', () => {
  const places = made();
  places.hold(1, { position: new Vector3(10, 0, 0), rotation: new Quaternion() });
  places.settle();
  assert.deepEqual(places.position(2)!.toArray(), [10, 0, 1]);
  places.apply(frame([1, 3, 0, 0], [2, 3, 0, 1]));
  assert.deepEqual(places.position(1)!.toArray(), [3, 0, 0]);
});

test('a model that goes is no longer held', () => {
  const places = made();
  places.hold(1, { position: new Vector3(10, 0, 0), rotation: new Quaternion() });
  places.set(contentOf({ model: [scene.model[1]!] }).places);
  places.set(contentOf(scene).places);
  assert.deepEqual(places.position(1)!.toArray(), [1, 0, 0]);
});
