import assert from 'node:assert/strict';
import test from 'node:test';
import { fixedNumber } from './pose_table.ts';

test('numbers have as many digits whatever they are, and there is one zero', () => {
  assert.equal(fixedNumber(1.23456), '1.235');
  assert.equal(fixedNumber(-20), '-20.000');
  assert.equal(fixedNumber(-1e-9), '0.000');
});
