import assert from 'node:assert/strict';
import test from 'node:test';
import { Emitter } from './emitter.ts';

test('all receive, until they end it', () => {
  const emitter = new Emitter<number>();
  const heard: number[] = [];
  const end = emitter.on((value) => heard.push(value));
  emitter.on((value) => heard.push(-value));
  emitter.emit(1);
  end();
  emitter.emit(2);
  assert.deepEqual(heard, [1, -1, -2]);
});

test('one that throws keeps no other from hearing', (context) => {
  const errors = context.mock.method(console, 'error', () => {});
  const emitter = new Emitter<number>();
  let heard = 0;
  emitter.on(() => {
    throw new Error('mine');
  });
  emitter.on((value) => (heard = value));
  emitter.emit(3);
  assert.equal(heard, 3);
  assert.equal(errors.mock.callCount(), 1);
});
