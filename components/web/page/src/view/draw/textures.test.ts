import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MeshBasicMaterial, SRGBColorSpace, type Texture } from 'three';

import { Textures } from './textures.ts';

// a substitute for the browser's decoder
Object.assign(globalThis, { createImageBitmap: () => Promise.resolve({ width: 1, height: 1, close: () => {} }) });

function made(there: string[]): { textures: Textures; asked: string[]; problems: string[]; changes: number[] } {
  const [asked, problems, changes]: [string[], string[], number[]] = [[], [], []];
  const asset = (address: string) => {
    asked.push(address);
    return there.includes(address) ? Promise.resolve(new ArrayBuffer(4)) : Promise.reject(new Error('it is gone'));
  };
  const textures = new Textures(asset, () => changes.push(1), (text) => problems.push(text));
  return { textures, asked, problems, changes };
}

const settled = () => new Promise((resolve) => setImmediate(resolve));

test('a picture is laid over the material when it has come', async () => {
  const { textures, changes } = made(['/a.png']);
  const material = new MeshBasicMaterial();
  textures.put(material, 'map', '/a.png', SRGBColorSpace);
  const map = () => material.map as Texture | null;
  assert.equal(map(), null);
  await settled();
  assert.equal(map()?.flipY, false);
  assert.equal(changes.length, 1);
});

test('of several places the first that has the picture counts, and nobody asks twice', async () => {
  const { textures, asked, problems } = made(['/b/a.png']);
  const materials = [new MeshBasicMaterial(), new MeshBasicMaterial()];
  for (const material of materials) textures.put(material, 'map', '/a.png\n/b/a.png', SRGBColorSpace);
  await settled();
  assert.equal(materials[0]!.map, materials[1]!.map);
  assert.deepEqual(asked, ['/a.png', '/b/a.png']);
  assert.deepEqual(problems, []);
});

test('a picture that is nowhere is told of once, by its first place', async () => {
  const { textures, problems } = made([]);
  for (let i = 0; i < 3; ++i) textures.put(new MeshBasicMaterial(), 'map', '/a.png\n/b/a.png', SRGBColorSpace);
  await settled();
  assert.deepEqual(problems, ["texture '/a.png' can't be shown: it is gone"]);
});

test('pictures within other files are not asked for', async () => {
  const { textures, asked } = made([]);
  const material = new MeshBasicMaterial();
  textures.embed('/mesh.glb#0', new ArrayBuffer(4));
  textures.put(material, 'map', '/mesh.glb#0', SRGBColorSpace);
  await settled();
  assert.ok(material.map);
  assert.deepEqual(asked, []);
});
