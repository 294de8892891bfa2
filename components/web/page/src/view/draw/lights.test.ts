import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type AmbientLight, Box3, DirectionalLight, type Group, PointLight, SpotLight, Vector3 } from 'three';

import { fromRollPitchYaw, noPlacement } from '../maths/placement.ts';
import { Lights, colorOfLight, shadowRegion } from './lights.ts';
import { attenuations } from './materials.ts';

function lightsFrom(...messages: object[]): Lights {
  const sceneLights = new Lights();
  sceneLights.set(new Map(messages.map((message, i) => [i + 1, message])), noPlacement);
  return sceneLights;
}

function threeLightsOf(sceneLights: Lights) {
  return sceneLights.group.children.filter((child) => 'isLight' in child && !('isAmbientLight' in child));
}

test('a white light of intensity one has the colour pi, because three divides by pi', () => {
  assert.ok(Math.abs(colorOfLight({ diffuse: { r: 1, g: 1, b: 1 }, intensity: 1 }).r - Math.PI) < 1e-6);
});

test('the type of a message chooses the kind of light', () => {
  const lights = threeLightsOf(lightsFrom({ type: 0 }, { type: 1, spotInnerAngle: 0.5, spotOuterAngle: 1 }, { type: 2 }));
  assert.ok(lights[0] instanceof PointLight);
  assert.ok(lights[2] instanceof DirectionalLight);
  const spot = lights[1] as SpotLight;
  assert.equal(spot.angle, 0.5);
  assert.equal(spot.penumbra, 0.5);
});

test('each light has its own attenuation', () => {
  const lights = threeLightsOf(lightsFrom({ type: 2 }, { type: 1, attenuationConstant: 0.5, attenuationQuadratic: 0.1, spotFalloff: 2 }));
  const { decay } = lights[1] as SpotLight;
  assert.deepEqual(attenuations.value[decay]!.toArray(), [0.5, 0, 0.1, 2]);
});

test('the direction of a light turns with its link', () => {
  const sceneLights = lightsFrom({ type: 2, direction: { z: -1 } });
  sceneLights.move(1, { position: new Vector3(), rotation: fromRollPitchYaw(0, Math.PI / 2, 0) });
  sceneLights.aimShadows(shadowRegion(new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)), new Vector3()));
  const light = threeLightsOf(sceneLights)[0] as DirectionalLight;
  assert.ok(light.position.x > 1, 'it comes from where it does not shine to');
  assert.ok(Math.abs(light.position.z) < 1e-6);
});

test('of twenty lights sixteen are drawn, and four cast shadows', () => {
  const lights = threeLightsOf(lightsFrom(...Array.from({ length: 20 }, () => ({ type: 2, castShadows: true }))));
  assert.equal(lights.length, 16);
  assert.equal(lights.filter((light) => light.castShadow).length, 4);
});

test('shadows are switched off and on, also those of lights added meanwhile', () => {
  const sceneLights = new Lights();
  sceneLights.setShadows(false);
  sceneLights.set(new Map([[1, { type: 2, castShadows: true }], [2, { type: 2 }]]), noPlacement);
  assert.deepEqual(threeLightsOf(sceneLights).map((light) => light.castShadow), [false, false]);
  sceneLights.setShadows(true);
  assert.deepEqual(threeLightsOf(sceneLights).map((light) => light.castShadow), [true, false]);
});

test('in a wide scene the region with shadows is around the target of the camera', () => {
  const wide = new Box3(new Vector3(-500, -500, 0), new Vector3(500, 500, 1));
  const region = shadowRegion(wide, new Vector3(100, 0, 0))!;
  assert.deepEqual(region.center.toArray(), [100, 0, 0]);
  assert.equal(region.radius, 25);
  assert.equal(shadowRegion(new Box3(), new Vector3()), null);
});

test('setting lights removes those set before', () => {
  const sceneLights = lightsFrom({ type: 2 }, { type: 1 });
  sceneLights.set(new Map(), noPlacement);
  // the ambient light, and the group of the fill light
  assert.equal(sceneLights.group.children.length, 2);
});

test('as the cameras see it, there is the ambient light of the world and nothing else', () => {
  const sceneLights = lightsFrom({ type: 2, castShadows: true });
  sceneLights.setAmbient({ r: 1, g: 1, b: 1, a: 1 });
  const [ambient, fill] = sceneLights.group.children as [AmbientLight, Group];
  const [sun] = threeLightsOf(sceneLights) as [DirectionalLight];
  assert.ok(fill.visible && ambient.color.r < 0.7 && sun.shadow.radius > 1);
  sceneLights.setAsCameras(true);
  assert.ok(!fill.visible && ambient.color.r === 1 && sun.shadow.radius === 1);
});
