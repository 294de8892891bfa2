import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Object3D, Vector3 } from 'three';

import type { Stage } from '../scene/stage.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { Sensed, frameNameOf } from './sensed.ts';

function stage(): Stage {
  const sensor = [{ id: 3, name: 'lidar', pose: { position: { z: 1 } } }];
  return stageOf({ model: [{ id: 1, name: 'm', pose: { position: { x: 5 } }, link: [{ id: 2, name: 'l', sensor }] }] });
}

function shape() {
  return { object: new Object3D(), set: () => {}, dispose: () => {} };
}

function placeOf(sensed: Sensed): number[] {
  return new Vector3().setFromMatrixPosition(sensed.group.children[0]!.matrix).toArray();
}

test('frames are named by the header, or as scans do it', () => {
  assert.equal(frameNameOf({ header: { data: [{ key: 'frame_id', value: ['a::b'] }] }, frame: 'c' }), 'a::b');
  assert.equal(frameNameOf({ frame: 'c' }), 'c');
  assert.equal(frameNameOf({}), '');
});

test('what a sensor measures is where the sensor is, and goes with its link', () => {
  const scene = stage();
  const sensed = new Sensed(scene, shape);
  sensed.set('/lidar', { frame: 'm::l::lidar' });
  assert.deepEqual(placeOf(sensed), [5, 0, 1]);
  scene.places.apply({
    timeNs: 0n, revision: 0, ids: new Uint32Array([2]), poses: new Float32Array([5, 7, 0, 0, 0, 0, 1]),
  });
  sensed.update();
  assert.deepEqual(placeOf(sensed), [5, 7, 1]);
});

test('without a frame that is known the message says where it is', () => {
  const sensed = new Sensed(stage(), shape);
  sensed.set('/lidar', { frame: 'nobody', worldPose: { position: { y: 2 } } });
  assert.deepEqual(placeOf(sensed), [0, 2, 0]);
});

test('what is no longer shown is gone', () => {
  const sensed = new Sensed(stage(), shape);
  sensed.set('/lidar', {});
  sensed.set('/lidar', null);
  sensed.set('/other', null);
  assert.equal(sensed.group.children.length, 0);
});
