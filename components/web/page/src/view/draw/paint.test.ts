import assert from 'node:assert/strict';
import { test } from 'node:test';

import { paintOf } from './paint.ts';

test('a material without PBR has its colours', () => {
  const paint = paintOf({ diffuse: { r: 1, g: 0.5, a: 0.5 }, specular: { b: 1 }, lighting: true }, 0.5);
  assert.deepEqual(paint.diffuse, [1, 0.5, 0]);
  assert.deepEqual(paint.specular, [0, 0, 1]);
  assert.equal(paint.opacity, 0.25);
  assert.equal(paint.roughness, 0.6);
  assert.ok(paint.isLit);
});

test('of metal roughness and metalness count, of gloss the reverse of roughness', () => {
  const metal = paintOf({ pbr: { type: 1, metalness: 0.9, roughness: 0.2, metalnessMap: 'm', roughnessMap: 'r' } });
  assert.deepEqual([metal.metalness, metal.roughness, metal.metalnessMap, metal.roughnessMap], [0.9, 0.2, 'm', 'r']);
  const gloss = paintOf({ pbr: { type: 2, glossiness: 0.75, metalness: 1, roughnessMap: 'r' } });
  assert.deepEqual([gloss.metalness, gloss.roughness, gloss.roughnessMap], [0, 0.25, '']);
});

test('a map of what a surface emits says all where there is no colour', () => {
  assert.deepEqual(paintOf({ pbr: { type: 1, emissiveMap: 'e' } }).emissive, [1, 1, 1]);
  assert.deepEqual(paintOf({ emissive: { r: 0.5 }, pbr: { type: 1, emissiveMap: 'e' } }).emissive, [0.5, 0, 0]);
});

test('shares are from 0 to 1 whatever the message says', () => {
  assert.equal(paintOf({ diffuse: { a: 7 } }, -3).opacity, 1);
  assert.equal(paintOf({ pbr: { type: 1, roughness: NaN } }).roughness, 0);
});
