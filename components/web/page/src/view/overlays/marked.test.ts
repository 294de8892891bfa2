import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, Vector3 } from 'three';

import { GeometryType } from '../messages.ts';
import { type Overlay, Shown } from '../scene/shown.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { Marked } from './marked.ts';

const box = { type: GeometryType.box, box: { size: { x: 1, y: 1, z: 1 } } };
const link = (id: number) => ({
  id, name: `l${id}`, collision: [{ id: id + 50, geometry: box }],
  inertial: { mass: 6, ixx: 1, iyy: 1, izz: 1, pose: { position: { z: 1 } } },
});
const scene = {
  model: [
    {
      id: 1, pose: { position: { x: 5 } }, link: [link(2), link(3)],
      joint: [{ id: 9, type: 0, child: 'l3', axis1: { xyz: { z: 1 } } }],
    },
    { id: 10, link: [link(11)] },
  ],
};

function made(): { marked: Marked; shown: Shown; stage: ReturnType<typeof stageOf>; count: () => number } {
  const stage = stageOf(scene);
  const shown = new Shown();
  const marked = new Marked(stage, shown, () => {});
  const count = () => marked.group.children.reduce((sum, anchor) => sum + anchor.children.length, 0);
  return { marked, shown, stage, count };
}

for (const [overlay, ofModel] of [['frames', 3], ['joints', 1], ['centres', 2], ['inertia', 2], ['collisions', 2]] as const) {
  test(`${overlay} are those of the entity that they are asked for`, () => {
    const { marked, shown, count } = made();
    shown.set(overlay as Overlay, true, 1);
    marked.rebuild();
    assert.equal(count(), ofModel);
    shown.set(overlay as Overlay, false);
    marked.rebuild();
    assert.equal(count(), 0);
  });
}

test('marks go with their links', () => {
  const { marked, shown, stage } = made();
  shown.set('inertia', true, 11);
  marked.rebuild();
  const middle = () => new Box3().setFromObject(marked.group).getCenter(new Vector3()).toArray();
  assert.deepEqual(middle(), [0, 0, 1]);
  stage.places.apply({
    timeNs: 0n, revision: 0, ids: new Uint32Array([11]), poses: new Float32Array([0, 4, 0, 0, 0, 0, 1]),
  });
  marked.move(11);
  assert.deepEqual(middle(), [0, 4, 1]);
});
