import assert from 'node:assert/strict';
import { test } from 'node:test';

import { contactMarks } from './contacts.ts';

test('each point has a line along its normal', () => {
  const { points, normals } = contactMarks({
    contact: [{ position: [{ x: 1 }, { y: 2 }], normal: [{ z: 1 }, { z: 1 }] }, { position: [{ z: 3 }] }],
  });
  assert.deepEqual(points, [1, 0, 0, 0, 2, 0, 0, 0, 3]);
  assert.deepEqual(normals.slice(0, 6), [1, 0, 0, 1, 0, 0.2]);
  assert.equal(normals.length, 18);
});

test('nothing touches in a message without contacts', () => {
  assert.deepEqual(contactMarks({}), { points: [], normals: [], forces: [] });
});

test('a force has a line of a centimetre per newton, up to two metres', () => {
  const at = (x: number, force: Record<string, number>): unknown => ({ position: [{ x }], normal: [{ z: 1 }], wrench: [{ body1Wrench: { force } }] });
  const { forces } = contactMarks({ contact: [at(1, { z: 20 }), at(2, { x: -1e6 }), at(3, {})] });
  assert.deepEqual(forces, [1, 0, 0, 1, 0, 0.2, 2, 0, 0, 0, 0, 0]);
});
