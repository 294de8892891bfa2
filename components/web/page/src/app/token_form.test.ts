import assert from 'node:assert/strict';
import test from 'node:test';
import { tokenIn } from './token_form.ts';

test('the token is found in an address, and taken as it is otherwise', () => {
  assert.equal(tokenIn('http://10.0.0.7:9002/?token=0123abcd'), '0123abcd');
  assert.equal(tokenIn('http://10.0.0.7:9002/?a=b&token=0123#x'), '0123');
  assert.equal(tokenIn(' 0123abcd '), '0123abcd');
});
