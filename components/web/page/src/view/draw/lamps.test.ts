import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Box3, DirectionalLight, PointLight, SpotLight, Vector3 } from 'three';

import { fromRollPitchYaw, noPlacement } from '../maths/placement.ts';
import { Lamps, colorOfLight, shadowRegion } from './lamps.ts';
import { attenuations } from './materials.ts';

function lampsOf(...messages: object[]): Lamps {
  const lamps = new Lamps();
  lamps.set(new Map(messages.map((message, i) => [i + 1, message])), noPlacement);
  return lamps;
}

function lightsOf(lamps: Lamps) {
  return lamps.group.children.filter((child) => 'isLight' in child && !('isAmbientLight' in child));
}

test('a white lamp of intensity one gives what white shows that faces it', () => {
  assert.ok(Math.abs(colorOfLight({ diffuse: { r: 1, g: 1, b: 1 }, intensity: 1 }).r - Math.PI) < 1e-6);
});

test('lights are of the kind that they say', () => {
  const lights = lightsOf(lampsOf({ type: 0 }, { type: 1, spotInnerAngle: 0.5, spotOuterAngle: 1 }, { type: 2 }));
  assert.ok(lights[0] instanceof PointLight);
  assert.ok(lights[2] instanceof DirectionalLight);
  const spot = lights[1] as SpotLight;
  assert.equal(spot.angle, 0.5);
  assert.equal(spot.penumbra, 0.5);
});

test('each lamp weakens as it says', () => {
  const lights = lightsOf(lampsOf({ type: 2 }, { type: 1, attenuationConstant: 0.5, attenuationQuadratic: 0.1, spotFalloff: 2 }));
  const { decay } = lights[1] as SpotLight;
  assert.deepEqual(attenuations.value[decay]!.toArray(), [0.5, 0, 0.1, 2]);
});

test('a light that turns with its link shines elsewhere', () => {
  const lamps = lampsOf({ type: 2, direction: { z: -1 } });
  lamps.move(1, { position: new Vector3(), rotation: fromRollPitchYaw(0, Math.PI / 2, 0) });
  lamps.aimShadows(shadowRegion(new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)), new Vector3()));
  const light = lightsOf(lamps)[0] as DirectionalLight;
  assert.ok(light.position.x > 1, 'it comes from where it does not shine to');
  assert.ok(Math.abs(light.position.z) < 1e-6);
});

test('four lamps throw shadows, and sixteen shine', () => {
  const lights = lightsOf(lampsOf(...Array.from({ length: 20 }, () => ({ type: 2, castShadows: true }))));
  assert.equal(lights.length, 16);
  assert.equal(lights.filter((light) => light.castShadow).length, 4);
});

test('shadows are switched off and on, those of lamps that come meanwhile too', () => {
  const lamps = new Lamps();
  lamps.setShadows(false);
  lamps.set(new Map([[1, { type: 2, castShadows: true }], [2, { type: 2 }]]), noPlacement);
  assert.deepEqual(lightsOf(lamps).map((light) => light.castShadow), [false, false]);
  lamps.setShadows(true);
  assert.deepEqual(lightsOf(lamps).map((light) => light.castShadow), [true, false]);
});

test('shadows of a wide scene are those around what is looked at', () => {
  const wide = new Box3(new Vector3(-500, -500, 0), new Vector3(500, 500, 1));
  const region = shadowRegion(wide, new Vector3(100, 0, 0))!;
  assert.deepEqual(region.center.toArray(), [100, 0, 0]);
  assert.equal(region.radius, 25);
  assert.equal(shadowRegion(new Box3(), new Vector3()), null);
});

test('lights of a scene before are gone', () => {
  const lamps = lampsOf({ type: 2 }, { type: 1 });
  lamps.set(new Map(), noPlacement);
  assert.equal(lamps.group.children.length, 1);
});
