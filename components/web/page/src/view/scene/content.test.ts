import assert from 'node:assert/strict';
import { test } from 'node:test';

import { contentOf, fullName, isWithin } from './content.ts';

const scene = {
  model: [
    {
      id: 1,
      name: 'robot',
      pose: { position: { x: 1 }, orientation: { w: 1 } },
      link: [
        {
          id: 2,
          name: 'base',
          pose: { position: { z: 0.5 } },
          visual: [{ id: 3, name: 'look', geometry: { type: 2, sphere: { radius: 1 } }, castShadows: true }],
          collision: [{ id: 4, geometry: { type: 2, sphere: { radius: 1 } } }],
          inertial: { mass: 2 },
          sensor: [{ id: 9, name: 'lidar', pose: { position: { y: 3 } } }],
        },
      ],
      model: [{ id: 5, name: 'arm', pose: { position: { y: 2 } }, link: [{ id: 6, name: 'upper' }] }],
      joint: [
        { id: 7, name: 'shoulder', type: 0, child: 'arm::upper', axis1: { xyz: { z: 1 } } },
        { id: 8, name: 'lost', child: 'nobody' },
      ],
    },
  ],
  light: [
    { id: 10, name: 'sun', type: 2 },
    { id: 11, name: 'off', header: { data: [{ key: 'isLightOn', value: ['0'] }] } },
  ],
};

test('places are in the world', () => {
  const { places } = contentOf(scene);
  assert.deepEqual(places.get(2)!.X_WorldPlace.position.toArray(), [1, 0, 0.5]);
  assert.deepEqual(places.get(6)!.X_WorldPlace.position.toArray(), [1, 2, 0]);
  assert.deepEqual(places.get(9)!.X_WorldPlace.position.toArray(), [1, 3, 0.5]);
});

test('each place knows the model of the world that it is in', () => {
  const { places } = contentOf(scene);
  assert.equal(places.get(6)!.model, 1);
  assert.equal(places.get(1)!.model, 1);
  assert.equal(places.get(10)!.model, 0);
  assert.ok(isWithin(places, 6, 1));
  assert.ok(!isWithin(places, 1, 6));
});

test('names go from the model down', () => {
  assert.equal(fullName(contentOf(scene).places, 9), 'robot::base::lidar');
});

test('visuals, collisions, inertials and joints have their link', () => {
  const content = contentOf(scene);
  assert.deepEqual(content.visuals.map(({ id, place, castsShadows }) => [id, place, castsShadows]), [[3, 2, true]]);
  assert.deepEqual(content.collisions.map(({ id, place }) => [id, place]), [[4, 2]]);
  assert.deepEqual(content.inertials.map(({ place }) => place), [2]);
  assert.deepEqual(content.joints.map(({ name, place }) => [name, place]), [['shoulder', 6]]);
});

test('a light that is off has a place and gives no light', () => {
  const content = contentOf(scene);
  assert.deepEqual([...content.lights.keys()], [10]);
  assert.ok(content.places.has(11));
});

test('visuals may stand in a model without links', () => {
  const { visuals } = contentOf({ model: [{ id: 1, visual: [{ id: 2, geometry: {}, transparency: 0.5 }] }] });
  assert.deepEqual(visuals.map(({ id, place, transparency }) => [id, place, transparency]), [[2, 1, 0.5]]);
});

test('an id that is there twice counts once, and nothing stands in itself', () => {
  const { places } = contentOf({ model: [{ id: 1, name: 'first', link: [{ id: 1, name: 'second' }] }] });
  assert.deepEqual([...places.values()].map(({ name }) => name), ['first']);
  assert.ok(!isWithin(places, 1, 2));
});
