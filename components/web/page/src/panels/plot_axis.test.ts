import assert from 'node:assert/strict';
import test from 'node:test';
import { tickTexts } from './plot_axis.ts';

test('labels have as many decimals as tell them apart', () => {
  assert.deepEqual(tickTexts([0, 2.5, 5]), ['0', '2.5', '5.0']);
  assert.deepEqual(tickTexts([-1, -0.5, 0, 0.5]), ['-1.0', '-0.5', '0', '0.5']);
  assert.deepEqual(tickTexts([999_990, 999_995]), ['999990', '999995']);
  assert.deepEqual(tickTexts([3]), ['3']);
});

test('large and tiny ones have an exponent', () => {
  assert.deepEqual(tickTexts([0, 500_000_000, 1_000_000_000]), ['0', '5e8', '1e9']);
  assert.deepEqual(tickTexts([1_000_000_000, 1_000_000_000.5]), ['1e9', '1.0000000005e9']);
  assert.deepEqual(tickTexts([-2e-7, 0, 2e-7]), ['-2e-7', '0', '2e-7']);
  assert.deepEqual(tickTexts([0, 2.5e-6, 5e-6]), ['0', '2.5e-6', '5e-6']);
});

test('what rounding leaves of 0 is 0', () => {
  assert.deepEqual(tickTexts([-0.1, -1.4e-17, 0.1]), ['-0.1', '0', '0.1']);
  assert.deepEqual(tickTexts([-0]), ['0']);
});
