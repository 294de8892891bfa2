import assert from 'node:assert/strict';
import test from 'node:test';
import { readContacts } from './contacts.ts';

test('contact points have positions, normals, forces and depths', () => {
  const bytes = new Uint8Array(4 + 40);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, 1, true);
  [1, 2, 3, 0, 0, 1, 0, 5, 20, 0.25].forEach((value, i) => view.setFloat32(4 + 4 * i, value, true));
  assert.deepEqual(readContacts(bytes), {
    contact: [{
      position: [{ x: 1, y: 2, z: 3 }], normal: [{ x: 0, y: 0, z: 1 }], wrench: [{ body1Wrench: { force: { x: 0, y: 5, z: 20 } } }], depth: [0.25],
    }],
  });
  assert.deepEqual(readContacts(new Uint8Array(4)), { contact: [] });
});

test('cut off ones are refused', () => {
  for (const length of [0, 3, 10, 45]) assert.throws(() => readContacts(new Uint8Array(length).fill(1)), /cut off/);
});
