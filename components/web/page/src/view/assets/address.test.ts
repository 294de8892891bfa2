import assert from 'node:assert/strict';
import { test } from 'node:test';

import { addressBeside, endingOf, pictureAddresses } from './address.ts';

test('names are relative to the file that has them', () => {
  assert.equal(addressBeside('/models/a/meshes/a.dae', 'a.png'), '/models/a/meshes/a.png');
  assert.equal(addressBeside('/models/a/meshes/a.dae', '../materials/./a.png'), '/models/a/materials/a.png');
  assert.equal(addressBeside('/models/a/meshes/a.dae', '..\\textures\\a.png'), '/models/a/textures/a.png');
  assert.equal(addressBeside('model://a/meshes/a.dae', '../a.png'), 'model://a/a.png');
});

test('nothing is above the root', () => {
  assert.equal(addressBeside('/a.dae', '../../../etc/passwd'), '/etc/passwd');
  assert.equal(addressBeside('model://a/a.dae', '../../../b.png'), 'model://a/b.png');
});

test('an ending is in lower case, without what follows the name', () => {
  assert.equal(endingOf('/a/B.DAE'), 'dae');
  assert.equal(endingOf('https://there/a.glb?token=1.2'), 'glb');
  assert.equal(endingOf('/a.b/c'), '');
});

test('pictures are looked for as Fortress looks', () => {
  assert.equal(pictureAddresses('/m/meshes/a.dae', 'a.png'), '/m/meshes/a.png\n/m/materials/textures/a.png');
});
