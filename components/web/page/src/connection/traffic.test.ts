import assert from 'node:assert/strict';
import test from 'node:test';
import { Traffic } from './traffic.ts';

test('rates are those since the last time, the largest first', () => {
  const traffic = new Traffic(1000);
  traffic.add('/a', 100);
  traffic.add('/b', 300);
  traffic.add('/a', 100);
  assert.deepEqual(traffic.take(3000), [
    { topic: '/b', messages: 0.5, bytes: 150 },
    { topic: '/a', messages: 1, bytes: 100 },
  ]);
  traffic.add('/a', 50);
  assert.deepEqual(traffic.take(3500), [{ topic: '/a', messages: 2, bytes: 100 }]);
  assert.deepEqual(traffic.take(4000), []);
});
