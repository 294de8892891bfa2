import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Color, InstancedMesh, SRGBColorSpace, Vector3 } from 'three';

import { GeometryType } from '../messages.ts';
import { Stage } from './stage.ts';
import { plainStyle, stageOf } from './stage_for_tests.ts';

const box = { type: GeometryType.box, box: { size: { x: 2, y: 2, z: 2 } } };
const lost = { type: GeometryType.mesh, mesh: { filename: '/lost.stl' } };
// an STL file with a triangle of 1 m
const triangle = `solid t
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid t
`;

const turned = {
  model: [
    {
      id: 1,
      pose: { position: { x: 10 }, orientation: { z: Math.SQRT1_2, w: Math.SQRT1_2 } },
      link: [
        { id: 2, visual: [{ id: 3, geometry: box }] },
        { id: 4, pose: { position: { x: 4 } }, visual: [{ id: 5, geometry: box }] },
      ],
    },
  ],
};

function meshesOf(stage: Stage): InstancedMesh[] {
  return stage.batches.group.children as InstancedMesh[];
}

test('bounds are in the world, or in another frame, around all that is in an entity', () => {
  const stage = stageOf(turned);
  const inWorld = stage.boundsOf(1);
  assert.ok(inWorld.min.distanceTo(new Vector3(9, -1, -1)) < 1e-9);
  assert.ok(inWorld.max.distanceTo(new Vector3(11, 5, 1)) < 1e-9);
  const inModel = stage.boundsOf(1, stage.places.shown(1)!);
  assert.ok(inModel.min.distanceTo(new Vector3(-1, -1, -1)) < 1e-9);
  assert.ok(inModel.max.distanceTo(new Vector3(5, 1, 1)) < 1e-9);
});

test('bounds of what is not seen are small and where it is', () => {
  const stage = stageOf({ light: [{ id: 9, pose: { position: { z: 7 } } }] });
  assert.ok(stage.boundsOf(9).getCenter(new Vector3()).distanceTo(new Vector3(0, 0, 7)) < 1e-9);
  assert.ok(stage.boundsOf(99).isEmpty());
});

test('a scene takes the place of the one before', () => {
  const stage = stageOf(turned);
  assert.deepEqual(meshesOf(stage).map(({ count }) => count), [2]);
  stage.setScene({ model: [{ id: 7, link: [{ id: 8, visual: [{ id: 9, geometry: box }] }] }] });
  assert.deepEqual(meshesOf(stage).map(({ count }) => count), [1]);
  assert.ok(stage.boundsOf(1).isEmpty());
});

test('the background is the colour that the screen shows, and there is a sky where the scene has one', () => {
  const stage = stageOf({ background: { r: 0.5, g: 0.25, b: 1 } });
  const shown = (stage.root.background as Color).getRGB({ r: 0, g: 0, b: 0 }, SRGBColorSpace);
  assert.ok(Math.abs(shown.r - 0.5) < 1e-4 && Math.abs(shown.g - 0.25) < 1e-4);
  const before = stage.root.children.length;
  stage.setScene({ sky: {} });
  assert.equal(stage.root.children.length, before + 1);
  // without a background of its own it has that of the theme, which cameras do not see
  stage.setScene({ background: { r: 0.7, g: 0.7, b: 0.7 } });
  assert.equal(stage.root.children.length, before + 1);
  stage.setLook('dark', true);
  assert.equal(stage.root.children.length, before);
});

test('a file is fetched once for all who show it, and what has come is shown with the next scene at once', async () => {
  const fetched: string[] = [];
  const stage = new Stage({
    asset: (address) => {
      fetched.push(address);
      return Promise.resolve(new TextEncoder().encode(triangle).buffer as ArrayBuffer);
    },
    changed: () => {},
    problem: assert.fail,
    styleOf: () => plainStyle,
  });
  const visual = [{ id: 3, geometry: { type: GeometryType.mesh, mesh: { filename: '/t.stl', scale: { x: 2, y: 2, z: 2 } } } }];
  const scene = { model: [{ id: 1, link: [{ id: 2, visual }, { id: 4, visual }] }] };
  stage.setScene(scene);
  assert.equal(meshesOf(stage).length, 0);
  while (meshesOf(stage)[0]?.count !== 2) await Promise.resolve();
  assert.deepEqual(stage.boundsOf(1).max.toArray(), [2, 2, 0]);
  stage.setScene(scene);
  assert.equal(meshesOf(stage)[0]?.count, 2);
  assert.deepEqual(fetched, ['/t.stl']);
});

test('what comes for a scene that has gone is not shown', async () => {
  let come: (bytes: ArrayBuffer) => void = () => {};
  const bytes = new Promise<ArrayBuffer>((resolve) => (come = resolve));
  const stage = new Stage({ asset: () => bytes, changed: () => {}, problem: assert.fail, styleOf: () => plainStyle });
  stage.setScene({ model: [{ id: 1, link: [{ id: 2, visual: [{ id: 3, geometry: lost }] }] }] });
  stage.setScene({});
  come(new TextEncoder().encode(triangle).buffer as ArrayBuffer);
  await new Promise((resolve) => setImmediate(resolve));
  assert.equal(meshesOf(stage).length, 0);
});

test('a file that is not there is told of once', async () => {
  const problems: string[] = [];
  const stage = new Stage({
    asset: () => Promise.reject(new Error('it is gone')), changed: () => {}, problem: (text) => problems.push(text),
    styleOf: () => plainStyle,
  });
  const scene = { model: [{ id: 1, link: [{ id: 2, visual: [{ id: 3, name: 'v', geometry: lost }] }] }] };
  stage.setScene(scene);
  stage.setScene(scene);
  await new Promise((resolve) => setImmediate(resolve));
  assert.deepEqual(problems, ["'/lost.stl' of visual 'v' can't be shown: it is gone"]);
});

test('the floor is as high as the largest horizontal plane', () => {
  const plane = (id: number, size: number, normal: object, z = 0) => ({
    id, pose: { position: { z } }, link: [{
      id: id + 1, visual: [{ id: id + 2, geometry: { type: GeometryType.plane, plane: { normal, size: { x: size, y: size } } } }],
    }],
  });
  const up = { z: 1 };
  assert.equal(stageOf({ model: [plane(1, 50, { x: 1 }), plane(4, 50, { z: -1 })] }).floorHeight(), null);
  assert.equal(stageOf({ model: [plane(1, 50, { x: 1 }), plane(4, 4, up), plane(7, 10, up, 2)] }).floorHeight(), 2);
});
