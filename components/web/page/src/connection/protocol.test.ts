import assert from 'node:assert/strict';
import test from 'node:test';
import { callFrame, publishFrame, readFrame, readText } from './protocol.ts';

const bytes = (...parts: (number | string | number[])[]): Uint8Array =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === 'string' ? [...new TextEncoder().encode(part)] : part)));

test('data has a subscription, a time and the rest of the bytes', () => {
  const frame = readFrame(bytes(1, [7, 0, 0, 0], [0, 0, 0, 0, 1, 0, 0, 0], 'abc'));
  assert.deepEqual(frame, { op: 'data', subscription: 7, timeNs: 1n << 32n, payload: bytes('abc') });
});

test('an answer has the encoding and the payload behind it', () => {
  const frame = readFrame(bytes(3, [1, 0, 0, 0], [2, 0, 0, 0], [8, 0, 0, 0], 'protobuf', 'xy'));
  assert.deepEqual(frame, { op: 'answer', service: 1, call: 2, encoding: 'protobuf', payload: bytes('xy') });
});

test('a file is there, or the reason why not', () => {
  assert.deepEqual(readFrame(bytes(4, [9, 0, 0, 0], 0, [0, 0, 0, 0], 'mesh')), {
    op: 'asset', request: 9, error: null, payload: bytes('mesh'),
  });
  const refused = readFrame(bytes(4, [9, 0, 0, 0], 1, [4, 0, 0, 0], 'gone'));
  assert.equal(refused.op === 'asset' && refused.error, 'gone');
});

test('what is cut off or unknown is refused', () => {
  assert.throws(() => readFrame(bytes(1, [7, 0, 0, 0], 1)), /truncated/);
  assert.throws(() => readFrame(bytes(3, [1, 0, 0, 0], [2, 0, 0, 0], [200, 0, 0, 0], 'protobuf')), /truncated/);
  assert.throws(() => readFrame(new Uint8Array()), /truncated/);
  assert.throws(() => readFrame(bytes(9)), /unknown/);
  assert.throws(() => readText('[1]'), /no "op"/);
  assert.throws(() => readText('torn {'), SyntaxError);
});

test('a message and a call are laid out as the protocol says', () => {
  assert.deepEqual(publishFrame(258, bytes('m')), bytes(1, [2, 1, 0, 0], 'm'));
  assert.deepEqual(callFrame(1, 2, 'json', bytes('{}')), bytes(2, [1, 0, 0, 0], [2, 0, 0, 0], [4, 0, 0, 0], 'json{}'));
});
