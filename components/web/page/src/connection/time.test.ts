import assert from 'node:assert/strict';
import test from 'node:test';
import { secondsOf, timeMessage } from './time.ts';

test('times are read and written', () => {
  assert.equal(secondsOf({ sec: 3n, nsec: 250_000_000 }), 3.25);
  assert.equal(secondsOf(undefined), 0);
  assert.deepEqual(timeMessage(3.25), { sec: 3n, nsec: 250_000_000 });
  // no second of 1,000,000,000 ns
  assert.deepEqual(timeMessage(2.9999999), { sec: 3n, nsec: 0 });
});
