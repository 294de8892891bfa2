import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, Raycaster, Vector3 } from 'three';

import { GeometryType } from '../messages.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { Ghost, groundUnder, heightAbove } from './ghost.ts';

const down = new Raycaster(new Vector3(1, 2, 10), new Vector3(0, 0, -1));

test('a thing stands on what is under the pointer, or on the ground', () => {
  assert.deepEqual(groundUnder(down, null)!.toArray(), [1, 2, 0]);
  assert.deepEqual(groundUnder(down, new Vector3(1, 2, 3))!.toArray(), [1, 2, 3]);
});

test('nobody places anything in the sky', () => {
  assert.equal(groundUnder(new Raycaster(new Vector3(0, 0, 1), new Vector3(1, 0, 0)), null), null);
  assert.equal(groundUnder(new Raycaster(new Vector3(0, 0, 1), new Vector3(1, 0, -1e-5).normalize()), null), null);
});

test('the frame of a thing is as high as the thing reaches below it', () => {
  assert.equal(heightAbove(new Box3(new Vector3(0, 0, -0.5), new Vector3(1, 1, 2))), 0.5);
  assert.equal(heightAbove(new Box3(new Vector3(0, 0, 1), new Vector3(1, 1, 2))), 0);
  assert.equal(heightAbove(new Box3()), 0);
});

test('a light is placed as a ball', () => {
  const stage = stageOf({});
  const ghost = new Ghost(stage, { name: 'lamp' }, () => {});
  ghost.put(new Vector3(1, 2, 3));
  assert.deepEqual(ghost.placement!.position.toArray(), [1, 2, 3]);
  const size = new Box3().setFromObject(ghost.object).getSize(new Vector3());
  assert.ok(size.z > 0.15 && size.z < 0.25);
});

test('a model without ids stands on its lowest point', () => {
  const stage = stageOf({});
  const geometry = { type: GeometryType.box, box: { size: { x: 1, y: 1, z: 1 } } };
  const link = (z: number) => ({ pose: { position: { z } }, visual: [{ geometry }] });
  const ghost = new Ghost(stage, { pose: { position: { x: 7 } }, link: [link(0), link(-1)] }, () => {});
  assert.equal(ghost.placement, null);
  ghost.put(new Vector3(3, 4, 0));
  assert.deepEqual(ghost.placement!.position.toArray(), [3, 4, 1.5]);
  ghost.put(null);
  assert.equal(ghost.placement, null);
});
