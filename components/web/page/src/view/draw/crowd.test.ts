import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BoxGeometry, Color, Group, InstancedMesh, Matrix4, MeshBasicMaterial, PerspectiveCamera, SphereGeometry, type BufferGeometry } from 'three';

import { coarserOf, Crowd, crowdSize, levelFor, sightOf } from './crowd.ts';
import { formOf } from './shapes.ts';
import { GeometryType } from '../messages.ts';

const trianglesOf = (geometry: BufferGeometry): number => (geometry.index?.count ?? geometry.attributes['position']!.count) / 3;

/// Spheres in a row away from the viewpoint, which looks along -z, and as many behind it.
function row(): { all: InstancedMesh; group: Group; crowd: Crowd } {
  const form = formOf({ type: GeometryType.sphere, sphere: { radius: 1 } })!;
  const geometry = form.make();
  coarserOf.set(geometry, form.makeCoarse!.map((make) => make()));
  const all = new InstancedMesh(geometry, new MeshBasicMaterial(), 2 * crowdSize);
  all.castShadow = true;
  for (let i = 0; i < crowdSize; ++i) {
    all.setMatrixAt(i, new Matrix4().makeTranslation(0, 0, -3 - 10 * i));
    all.setMatrixAt(crowdSize + i, new Matrix4().makeTranslation(0, 0, 3 + 10 * i));
    all.setColorAt(i, new Color(i / crowdSize, 0, 0));
  }
  const group = new Group();
  return { all, group, crowd: new Crowd(all, group) };
}

const sight = sightOf(new PerspectiveCamera(90, 1, 0.1, 10_000), 800);
const shownOf = (group: Group): InstancedMesh[] => group.children.filter(({ visible }) => visible) as InstancedMesh[];

test('what is behind the viewpoint is not drawn, and what is far has few triangles', () => {
  const { all, group, crowd } = row();
  crowd.arrange(all, sight);
  const shown = shownOf(group);
  assert.equal(shown.reduce((sum, { count }) => sum + count, 0), crowdSize);
  const drawn = shown.reduce((sum, { geometry, count }) => sum + count * trianglesOf(geometry), 0);
  assert.ok(drawn < (2 * crowdSize * trianglesOf(all.geometry)) / 8, `${drawn} triangles`);
  // the nearest one is whole, and has its colour
  assert.ok(shown[0]!.geometry === all.geometry && shown[0]!.count >= 1);
  const color = new Color();
  shown.at(-1)!.getColorAt(shown.at(-1)!.count - 1, color);
  assert.ok(Math.abs(color.r - (crowdSize - 1) / crowdSize) < 1e-6);
});

test('all of it casts shadows, in or out of view, in a rendering of its own', () => {
  const { all, group, crowd } = row();
  crowd.showCasters(true, all);
  assert.deepEqual(shownOf(group).map(({ count, castShadow }) => [count, castShadow]), [[2 * crowdSize, true]]);
  crowd.showCasters(false, all);
  crowd.arrange(all, sight);
  assert.ok(shownOf(group).every(({ castShadow }) => !castShadow));
  assert.equal(all.visible, false);
});

test('shapes without coarser ones are only left out where they are not in view', () => {
  const all = new InstancedMesh(new BoxGeometry(), new MeshBasicMaterial(), crowdSize);
  for (let i = 0; i < crowdSize; ++i) all.setMatrixAt(i, new Matrix4().makeTranslation(0, 0, i % 2 ? -50 : 50));
  const group = new Group();
  new Crowd(all, group).arrange(all, sight);
  assert.deepEqual(shownOf(group).map(({ count }) => count), [crowdSize / 2]);
});

test('the deviation from the shape is below half a pixel', () => {
  for (const radius of [0.5, 3.9, 4.1, 9.9, 39.9]) {
    const level = levelFor(radius);
    const sectors = [48, 24, 12, 8][level]!;
    assert.ok(radius * (1 - Math.cos(Math.PI / sectors)) < 0.5, `${radius} pixels, level ${level}`);
  }
  assert.equal(levelFor(1000), 0);
  assert.ok(trianglesOf(new SphereGeometry(1, 8, 4)) < 60);
});
