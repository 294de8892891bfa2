import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quaternion, Vector3 } from 'three';

import { contentOf } from '../scene/content.ts';
import { Places } from '../scene/places.ts';
import { Drag } from './drag.ts';

function made(): { places: Places; drag: Drag; x: () => number } {
  const places = new Places();
  places.set(contentOf({ model: [{ id: 1 }, { id: 2 }] }).places);
  return { places, drag: new Drag(places, () => {}), x: () => places.position(1)!.x };
}

const there = { position: new Vector3(5, 0, 0), rotation: new Quaternion() };

function receive(places: Places, drag: Drag, id: number): void {
  const ids = new Uint32Array([id]);
  places.apply({ timeNs: 0n, revision: 0, ids, poses: new Float32Array([4, 0, 0, 0, 0, 0, 1]) });
  drag.received(ids);
}

test('a held model stays where it is held, whatever frames say', () => {
  const { places, drag, x } = made();
  drag.move(1, there, null);
  receive(places, drag, 1);
  assert.equal(x(), 5);
});

test('a model that was let go stays there until its pose comes', async () => {
  const { places, drag, x } = made();
  drag.move(1, there, null);
  const left = Promise.resolve();
  drag.move(1, there, left);
  await left;
  receive(places, drag, 2);
  assert.equal(x(), 5);
  receive(places, drag, 1);
  assert.equal(x(), 4);
});

test('a model that may not go there is back at once', async () => {
  const { drag, x } = made();
  const left = Promise.reject(new Error('no'));
  drag.move(1, there, left);
  await left.catch(() => {});
  await Promise.resolve();
  assert.equal(x(), 0);
});
