import assert from 'node:assert/strict';
import test from 'node:test';

import { withDuration } from './webm.ts';

// EBML header (empty), Segment of unknown size, Info with TimecodeScale 1,000,000 and a name, a cluster
const header = [0x1a, 0x45, 0xdf, 0xa3, 0x80];
const segment = [0x18, 0x53, 0x80, 0x67, 0x01, 255, 255, 255, 255, 255, 255, 255];
const scale = [0x2a, 0xd7, 0xb1, 0x83, 0x0f, 0x42, 0x40];
const name = [0x4d, 0x80, 0x82, 0x61, 0x62];
const cluster = [0x1f, 0x43, 0xb6, 0x75, 0x81, 0x07];
const file = (...info: number[]): Uint8Array<ArrayBuffer> =>
  Uint8Array.from([...header, ...segment, 0x15, 0x49, 0xa9, 0x66, 0x80 + info.length, ...info, ...cluster]);

test('the length is added to a recorded file, and the rest stays', () => {
  const before = file(...scale, ...name);
  const after = withDuration(before, 2500);
  const number = new DataView(new ArrayBuffer(8));
  number.setFloat64(0, 2500);
  const added = [0x44, 0x89, 0x88, ...new Uint8Array(number.buffer)];
  const size = [0x10, 0, 0, scale.length + name.length + 11];
  assert.deepEqual([...after], [...header, ...segment, 0x15, 0x49, 0xa9, 0x66, ...size, ...scale, ...name, ...added, ...cluster]);
  // once is enough
  assert.equal(withDuration(after, 7), after);
});

test('other files stay as they are', () => {
  for (const bytes of [[], [1, 2, 3], [0, 0], [...header], [...header, ...segment, 0x15, 0x49]]) {
    const given = Uint8Array.from(bytes);
    assert.equal(withDuration(given, 1), given);
  }
});
