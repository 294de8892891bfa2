import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type Camera, PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';

import { GeometryType } from '../messages.ts';
import { stageOf } from '../scene/stage_for_tests.ts';
import { contactShadow } from './contact_shadow.ts';
import { Shadows } from './shadows.ts';

/// A renderer that only counts pictures from below, and is told whether those of lights are due.
function counter(): { renderer: WebGLRenderer; count: { below: number; lights: boolean } } {
  const count = { below: 0, lights: false };
  const renderer = {
    setClearColor() {},
    setRenderTarget() {},
    clear() {},
    render(_: unknown, camera: Camera) {
      if (camera.layers.mask !== 1) ++count.below;
    },
    shadowMap: { set needsUpdate(on: boolean) { count.lights = on; } },
  } as unknown as WebGLRenderer;
  return { renderer, count };
}

test('the shadow where bodies stand is rendered when it is wanted and something has changed', () => {
  const visual = (id: number, geometry: object) => ({ id, link: [{ id: id + 1, visual: [{ id: id + 2, geometry, castShadows: true }] }] });
  const plane = { type: GeometryType.plane, plane: { normal: { z: 1 }, size: { x: 9, y: 9 } } };
  const stage = stageOf({ model: [visual(1, plane), visual(4, { type: GeometryType.box, box: { size: { x: 1, y: 1, z: 1 } } })] });
  const { renderer, count } = counter();
  const shadows = new Shadows(renderer, stage, new PerspectiveCamera());
  const isShown = () => contactShadow.contactPlace.value.z > 0;
  const target = new Vector3();
  // as long as the browser can't keep up
  shadows.renew(target, true, false);
  assert.deepEqual([count, isShown()], [{ below: 0, lights: true }, false]);
  // at rest, though nothing has moved since
  count.lights = false;
  shadows.renew(target, false, true);
  assert.deepEqual([count, isShown()], [{ below: 1, lights: false }, true]);
  // only the viewpoint moves
  shadows.renew(target, false, true);
  assert.deepEqual(count, { below: 1, lights: false });
  shadows.renew(target, true, true);
  assert.deepEqual(count, { below: 2, lights: true });
  shadows.dispose();
});
