import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Vector3 } from 'three';

import { GeometryType } from '../messages.ts';
import type { Stage } from '../scene/stage.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { Outline } from './outline.ts';

function stage(): Stage {
  const geometry = { type: GeometryType.box, box: { size: { x: 2, y: 2, z: 2 } } };
  return stageOf({
    model: [
      {
        id: 1,
        pose: { position: { x: 10 }, orientation: { z: Math.SQRT1_2, w: Math.SQRT1_2 } },
        link: [
          { id: 2, visual: [{ id: 3, geometry }] },
          { id: 4, pose: { position: { x: 4 } }, visual: [{ id: 5, geometry }] },
        ],
      },
    ],
  });
}

test('the outline turns with what it is around', () => {
  const outline = new Outline();
  outline.update(stage(), 1);
  assert.ok(outline.object.visible);
  const middle = new Vector3().setFromMatrixPosition(outline.object.matrix);
  assert.ok(middle.distanceTo(new Vector3(10, 2, 0)) < 1e-9);
  outline.update(stage(), null);
  assert.ok(!outline.object.visible);
});
