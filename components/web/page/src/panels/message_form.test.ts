import assert from 'node:assert/strict';
import test from 'node:test';
import { ScalarType } from '@bufbuild/protobuf';
import { numberOf } from './message_form.ts';

test('numbers are what their field takes', () => {
  const field = (scalar: ScalarType): { name: string; scalar: ScalarType } => ({ name: 'f', scalar });
  assert.equal(numberOf(field(ScalarType.DOUBLE), '1.5'), 1.5);
  assert.equal(numberOf(field(ScalarType.INT32), '-3'), -3);
  assert.equal(numberOf(field(ScalarType.UINT64), '12345678901234567890'), 12345678901234567890n);
  assert.equal(numberOf(field(ScalarType.DOUBLE), ' '), undefined);
  assert.throws(() => numberOf(field(ScalarType.INT32), '1.5'), /f: '1.5' is not a whole number/);
  assert.throws(() => numberOf(field(ScalarType.DOUBLE), 'x'), /f: 'x' is not a number/);
});
