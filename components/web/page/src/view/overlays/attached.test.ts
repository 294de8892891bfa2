import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Matrix4, Object3D, Vector3 } from 'three';

import { Attached } from './attached.ts';

test('what is attached goes with its place', () => {
  const attached = new Attached();
  const object = new Object3D();
  object.position.set(0, 0, 1);
  attached.add(7, object, new Matrix4().makeTranslation(1, 0, 0));
  assert.deepEqual(object.getWorldPosition(new Vector3()).toArray(), [1, 0, 1]);
  attached.move(7, new Matrix4().makeTranslation(0, 5, 0));
  attached.move(8, new Matrix4().makeTranslation(9, 9, 9));
  assert.deepEqual(object.getWorldPosition(new Vector3()).toArray(), [0, 5, 1]);
  assert.ok(attached.has(7) && !attached.has(8));
  attached.clear();
  assert.equal(attached.group.children.length, 0);
});
