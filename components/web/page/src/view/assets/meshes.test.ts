import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Meshes } from './meshes.ts';

const files: Record<string, string> = {
  '/m/two.obj': 'mtllib two.mtl\no left\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\no right\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 4 5 6\n',
  '/m/two.mtl': 'newmtl red\nKd 1 0 0\nmap_Kd pictures\\red.png\n',
  '/m/bare.obj': 'mtllib lost.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n',
  '/m/empty.obj': '# nothing\n',
  '/m/rubbish.gltf': '{"asset": {"version": "2.0"}, "buffers": 7',
};

function meshes(): { meshes: Meshes; asked: string[] } {
  const asked: string[] = [];
  const asset = (address: string) => {
    asked.push(address);
    const text = files[address];
    if (text === undefined) return Promise.reject(new Error(`there is no ${address}`));
    return Promise.resolve(new TextEncoder().encode(text).buffer as ArrayBuffer);
  };
  return { meshes: new Meshes(asset, () => {}), asked };
}

function request(filename: string, submesh = '', isCentered = false) {
  return { filename, submesh, isCentered };
}

test('the parts of a file have its materials, with their pictures where these may be', async () => {
  const parts = await meshes().meshes.get(request('/m/two.obj'));
  assert.equal(parts.length, 2);
  assert.deepEqual(parts[0]!.paint!.diffuse.map(Math.round), [1, 0, 0]);
  assert.equal(parts[0]!.paint!.colorMap, '/m/pictures/red.png\n/materials/textures/pictures/red.png');
});

test('a submesh is one part, from the same file', async () => {
  const all = meshes();
  assert.equal((await all.meshes.get(request('/m/two.obj', 'right', true))).length, 1);
  await all.meshes.get(request('/m/two.obj', 'left'));
  assert.deepEqual(all.asked, ['/m/two.obj', '/m/two.mtl']);
  await assert.rejects(all.meshes.get(request('/m/two.obj', 'middle')), /no submesh 'middle'/);
});

test('without its library of materials a file has its shape, and no paint', async () => {
  const [part] = await meshes().meshes.get(request('/m/bare.obj'));
  assert.equal(part!.paint, null);
});

test('what is known is there at once', async () => {
  const all = meshes().meshes;
  assert.equal(all.known(request('/m/bare.obj')), undefined);
  const parts = await all.get(request('/m/bare.obj'));
  assert.equal(all.known(request('/m/bare.obj')), parts);
});

test('files that are no meshes are refused in words', async () => {
  const all = meshes().meshes;
  await assert.rejects(all.get(request('/m/two.mtl')), /\.dae, \.stl, \.obj/);
  await assert.rejects(all.get(request('/m/empty.obj')), /no triangles/);
  await assert.rejects(all.get(request('/m/lost.stl')), /there is no/);
  await assert.rejects(all.get(request('/m/rubbish.gltf')));
});

test('what failed is tried again when somebody says so', async () => {
  const { meshes: all, asked } = meshes();
  await assert.rejects(all.get(request('/m/lost.stl')));
  await assert.rejects(all.get(request('/m/lost.stl')));
  assert.deepEqual(asked, ['/m/lost.stl']);
  all.retry();
  await assert.rejects(all.get(request('/m/lost.stl')));
  assert.deepEqual(asked, ['/m/lost.stl', '/m/lost.stl']);
});
