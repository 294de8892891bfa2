import assert from 'node:assert/strict';
import test from 'node:test';
import { FrameGatherer, readFrame } from './frames.ts';

function frame(poses: Record<number, number>, { flags = 0, revision = 1, magic = 0x31465750 } = {}): Uint8Array {
  const ids = Object.keys(poses).map(Number);
  const view = new DataView(new ArrayBuffer(48 + 32 * ids.length));
  view.setUint32(0, magic, true);
  view.setUint32(4, flags, true);
  view.setBigUint64(8, 5_000_000n, true);
  view.setFloat64(24, 0.5, true);
  view.setUint32(32, 1, true);
  view.setUint32(40, revision, true);
  view.setUint32(44, ids.length, true);
  ids.forEach((id, i) => {
    view.setUint32(48 + 32 * i, id, true);
    view.setFloat32(52 + 32 * i, poses[id]!, true);
    view.setFloat32(76 + 32 * i, 1, true);
  });
  return new Uint8Array(view.buffer);
}

test('a frame is read', () => {
  const read = readFrame(frame({ 7: 2.5 }, { flags: 1, revision: 3 }));
  assert.equal(read.timeNs, 5_000_000n);
  assert.deepEqual([read.realTimeFactor, read.isPaused, read.hasAll, read.revision], [0.5, true, true, 3]);
  assert.deepEqual([...read.ids], [7]);
  assert.deepEqual([...read.poses], [2.5, 0, 0, 0, 0, 0, 1]);
});

test('what is no frame or cut off is refused', () => {
  assert.throws(() => readFrame(frame({}, { magic: 1 })), /not a frame/);
  assert.throws(() => readFrame(frame({ 1: 0 }).subarray(0, 79)), /truncated/);
  assert.throws(() => readFrame(new Uint8Array()), /not a frame/);
});

test('what moved in any frame is in the picture, with its latest pose', () => {
  const gatherer = new FrameGatherer();
  gatherer.add(readFrame(frame({ 1: 1, 2: 1 }, { flags: 1 })));
  gatherer.add(readFrame(frame({ 1: 2 })));
  gatherer.add(readFrame(frame({ 3: 3 })));
  const taken = gatherer.take()!;
  assert.deepEqual([...taken.ids].map((id, i) => [id, taken.poses[7 * i]]), [[1, 2], [2, 1], [3, 3]]);
  assert.equal(gatherer.take(), null);
  gatherer.add(readFrame(frame({ 2: 9 })));
  assert.deepEqual([...gatherer.take()!.ids], [2]);
  assert.deepEqual([...gatherer.all(4).ids], [1, 2, 3]);
});

test('what has gone is forgotten with a frame of all', () => {
  const gatherer = new FrameGatherer();
  gatherer.add(readFrame(frame({ 1: 1, 2: 1 }, { flags: 1 })));
  gatherer.add(readFrame(frame({ 2: 4 }, { flags: 1, revision: 2 })));
  assert.deepEqual([...gatherer.take()!.ids], [2]);
  assert.equal(gatherer.poses.has(1), false);
});
