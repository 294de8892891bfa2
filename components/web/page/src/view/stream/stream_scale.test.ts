import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pictureSize, StreamScale } from './stream_scale.ts';

test('slow pictures become smaller while the viewpoint moves, and quick ones larger again', () => {
  const scale = new StreamScale();
  assert.equal(scale.now(true), 1);
  for (let i = 0; i < 20; ++i) scale.arrived(2000);
  assert.equal(scale.now(true), 0.3);
  assert.equal(scale.now(false), 1);
  for (let i = 0; i < 20; ++i) scale.arrived(50);
  assert.equal(scale.now(true), 1);
});

test('a picture has the shape of its place, and a size that the server draws', () => {
  assert.deepEqual(pictureSize(400, 300, 1), [400, 300]);
  const [width, height] = pictureSize(3000, 1500, 1);
  assert.ok(width * height <= 501_000 && Math.abs(width / height - 2) < 0.01, `${width} ${height}`);
  assert.deepEqual(pictureSize(400, 300, 0.5), [200, 150]);
  assert.equal(pictureSize(5000, 20, 1)[0], 1280);
  assert.equal(pictureSize(40, 3, 0.3)[1], 16);
});
