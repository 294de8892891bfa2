import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, PerspectiveCamera, Vector2, Vector3 } from 'three';

import { GeometryType } from '../messages.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { Silhouette, screenBox } from './silhouette.ts';

const box = { type: GeometryType.box, box: { size: { x: 2, y: 2, z: 2 } } };

test('it has the visible parts of the selected entity', () => {
  const stage = stageOf({ model: [{ id: 1, link: [{ id: 2, visual: [{ id: 3, geometry: box }] }, { id: 4 }] }] });
  const silhouette = new Silhouette();
  assert.ok(silhouette.update(stage, 1));
  assert.ok(silhouette.update(stage, 2));
  assert.ok(!silhouette.update(stage, 4));
  assert.ok(!silhouette.update(stage, null));
});

test('only the part of the image around it is drawn', () => {
  const camera = new PerspectiveCamera(90, 1, 0.1, 100);
  camera.updateMatrixWorld();
  const size = new Vector2(100, 100);
  const cube = (z: number) => new Box3(new Vector3(-1, -1, z - 1), new Vector3(1, 1, z + 1));
  const part = screenBox(cube(-11), camera, size)!;
  // at 10 m, half the image is 10 m: 5 pixels to each side, and the margin
  for (const [found, wanted] of [[part.x, 40], [part.y, 40], [part.width, 20], [part.height, 20]] as const) {
    assert.ok(Math.abs(found - wanted) <= 2, `${found} instead of ${wanted}`);
  }
  // around the camera: all
  assert.equal(screenBox(cube(0), camera, size), null);
});
