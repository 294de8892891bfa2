import assert from 'node:assert/strict';
import test from 'node:test';
import { hexOf, rgbOfHex } from './property_fields.ts';

test('a colour is one of the browser and one of a message', () => {
  assert.equal(hexOf([1, 0.5, 0]), '#ff8000');
  assert.deepEqual(rgbOfHex('#ff0033'), [1, 0, 0.2]);
  assert.equal(hexOf([2, -1, 0]), '#ff0000', 'brighter than white');
});
