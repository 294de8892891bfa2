import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Color, type DirectionalLight, type HemisphereLight, Vector3 } from 'three';

import { FillLight } from './fill_light.ts';

test('the ground stays as bright, and faces away from the sun differ', () => {
  const light = new FillLight();
  const rest = light.set(new Color(0.4, 0.4, 0.4), new Vector3(1, 0, -1));
  const [hemisphere, fill] = light.group.children as [HemisphereLight, DirectionalLight];
  // what faces up
  assert.ok(Math.abs(rest.r + hemisphere.color.r - 0.4) < 1e-9);
  assert.equal(fill.position.z, 0);
  // the sun shines along x, so faces in the direction of x are without it: of two such, one gets more
  const of = (normal: Vector3): number => Math.max(0, normal.dot(fill.position));
  const [left, right] = [of(new Vector3(1, 1, 0).normalize()), of(new Vector3(1, -1, 0).normalize())];
  assert.ok(left - right > 0.3, `${left} ${right}`);
  assert.ok(of(new Vector3(-1, 0, 0)) === 0);
});

test('a world without sun has it, too', () => {
  const light = new FillLight();
  light.set(new Color(1, 1, 1), null);
  assert.ok(light.group.visible);
  light.switchOff();
  assert.ok(!light.group.visible);
});
