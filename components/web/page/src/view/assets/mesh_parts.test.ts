import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BoxGeometry, Group, Mesh, MeshPhongMaterial, MeshStandardMaterial, Raycaster, Vector3 } from 'three';

import { type MeshPart, mirrored, namedPicture, partsOf } from './mesh_parts.ts';

const plain = { submesh: '', isCentered: false, hasScreenColors: false, hasTexelsFromTop: false };

function twoBoxes(): Group {
  const group = new Group();
  const left = new Mesh(new BoxGeometry(2, 2, 2), new MeshPhongMaterial({ color: 0xff0000 }));
  left.name = 'left';
  left.position.set(-5, 0, 0);
  const right = new Mesh(new BoxGeometry(2, 2, 2), new MeshPhongMaterial({ map: namedPicture('/a.png') }));
  right.name = 'right_one';
  right.position.set(5, 0, 0);
  group.add(left, right);
  group.scale.setScalar(0.5);
  return group;
}

function middle(part: MeshPart): number[] {
  part.geometry.computeBoundingBox();
  return part.geometry.boundingBox!.getCenter(new Vector3()).toArray();
}

test('parts are where their nodes place them', () => {
  const parts = partsOf(twoBoxes(), plain);
  assert.deepEqual(parts.map(middle), [[-2.5, 0, 0], [2.5, 0, 0]]);
  assert.deepEqual(parts[0]!.paint!.diffuse, [1, 0, 0]);
  assert.equal(parts[1]!.paint!.colorMap, '/a.png');
});

test('a submesh is found by its name, as the file has it or as the loader writes it', () => {
  assert.deepEqual(partsOf(twoBoxes(), { ...plain, submesh: 'right one' }).map(middle), [[2.5, 0, 0]]);
  assert.equal(partsOf(twoBoxes(), { ...plain, submesh: 'nothing' }).length, 0);
});

test('a centred submesh has its middle at the origin', () => {
  assert.deepEqual(partsOf(twoBoxes(), { ...plain, submesh: 'left', isCentered: true }).map(middle), [[0, 0, 0]]);
});

test('a mesh of several materials is as many parts', () => {
  const material = (color: number) => new MeshStandardMaterial({ color });
  // BoxGeometry has a group for each of its sides
  const parts = partsOf(new Mesh(new BoxGeometry(), [material(0xff0000), material(0x0000ff)]), plain);
  assert.deepEqual(parts.map(({ geometry }) => geometry.index!.count), [6, 6]);
  assert.deepEqual(parts.map(({ paint }) => paint!.diffuse[2]), [0, 1]);
});

test('colours of a screen are taken as shares of light', () => {
  const mesh = new Mesh(new BoxGeometry(), new MeshPhongMaterial({ color: 0x808080 }));
  const [part] = partsOf(mesh, { ...plain, hasScreenColors: true });
  assert.ok(Math.abs(part!.paint!.diffuse[0] - 0x80 / 255) < 1e-4);
});

test('what is mirrored is seen from outside', () => {
  const mesh = new Mesh(new BoxGeometry(2, 2, 2), new MeshPhongMaterial());
  mesh.scale.set(-1, 1, 1);
  const [part] = partsOf(mesh, plain);
  const ray = new Raycaster(new Vector3(0.1, 0.3, 10), new Vector3(0, 0, -1));
  // a ray only intersects front faces
  const heights = (geometry: Mesh['geometry']) =>
    ray.intersectObject(new Mesh(geometry, new MeshPhongMaterial())).map(({ point }) => Math.round(point.z));
  assert.deepEqual(heights(part!.geometry), [1]);
  assert.deepEqual(heights(mirrored(part!.geometry)), [-1]);
});

test('texture coordinates from the top are turned', () => {
  const mesh = new Mesh(new BoxGeometry(), new MeshPhongMaterial());
  const before = mesh.geometry.getAttribute('uv').getY(0);
  const [part] = partsOf(mesh, { ...plain, hasTexelsFromTop: true });
  assert.equal(part!.geometry.getAttribute('uv').getY(0), 1 - before);
});
