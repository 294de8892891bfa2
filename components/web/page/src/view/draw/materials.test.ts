import assert from 'node:assert/strict';
import { test } from 'node:test';
import { DoubleSide, MeshBasicMaterial, MeshPhysicalMaterial, ShaderChunk } from 'three';

import { plainStyle } from '../scene/stage_for_tests.ts';
import { Materials, withAttenuation } from './materials.ts';
import { greyPaint } from './paint.ts';
import { Textures } from './textures.ts';

function materials(): Materials {
  return new Materials(new Textures(() => Promise.reject(new Error('no files')), () => {}, () => {}), '');
}

test('paints that differ in their colour alone share a material', () => {
  const all = materials();
  const red = all.get({ ...greyPaint, diffuse: [1, 0, 0] }, plainStyle);
  assert.equal(all.get({ ...greyPaint, diffuse: [0, 1, 0] }, plainStyle), red);
  assert.notEqual(all.get({ ...greyPaint, roughness: 0.1 }, plainStyle), red);
});

test('what is not lit needs no light', () => {
  assert.ok(materials().get({ ...greyPaint, isLit: false }, plainStyle) instanceof MeshBasicMaterial);
});

test('a style changes how a paint is shown', () => {
  const all = materials();
  assert.equal(all.get(greyPaint, plainStyle).transparent, false);
  const through = all.get(greyPaint, { wireframe: false, transparent: true });
  assert.ok(through.transparent && through.opacity < 1 && !through.depthWrite);
  const wires = all.get(greyPaint, { wireframe: true, transparent: false }) as MeshPhysicalMaterial;
  assert.ok(wires.wireframe);
  assert.equal(wires.side, DoubleSide);
});

test("three's shader has the attenuation of SDF and keeps the rest", () => {
  const text = withAttenuation(ShaderChunk.lights_pars_begin);
  assert.ok(text.includes('uniform vec4 attenuations[16]'));
  assert.ok(!text.includes('decayExponent'));
  assert.ok(text.includes('angleCos, spotLight.decay )'));
  assert.ok(!text.includes('smoothstep( coneCosine'));
  assert.ok(text.includes('void getSpotLightInfo('));
  assert.throws(() => withAttenuation('another shader'), /three\.js/);
});
