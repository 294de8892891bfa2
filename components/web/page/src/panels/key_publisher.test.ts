import assert from 'node:assert/strict';
import test from 'node:test';
import { keyNumber } from './key_publisher.ts';

test('keys have the numbers that Qt gives them', () => {
  // the codes in Fortress's moving robot tutorial
  assert.equal(keyNumber('ArrowUp'), 16777235);
  assert.equal(keyNumber('ArrowLeft'), 16777234);
  assert.equal(keyNumber('ArrowRight'), 16777236);
  assert.equal(keyNumber('ArrowDown'), 16777237);
  assert.equal(keyNumber('w'), 87);
  assert.equal(keyNumber('W'), 87);
  assert.equal(keyNumber('5'), 53);
  assert.equal(keyNumber(' '), 32);
  assert.equal(keyNumber('F12'), 16777275);
  assert.equal(keyNumber('Dead'), undefined);
});
