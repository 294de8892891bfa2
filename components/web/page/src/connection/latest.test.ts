import assert from 'node:assert/strict';
import test from 'node:test';
import { Latest } from './latest.ts';

test('only the latest of each key is delivered, once', () => {
  const asked: (() => void)[] = [];
  const latest = new Latest((callback) => asked.push(callback));
  const heard: string[] = [];
  for (const value of ['1', '2', '3']) latest.put('a', () => heard.push('a' + value));
  latest.put('b', () => heard.push('b'));
  latest.put('c', () => heard.push('c'));
  latest.drop('c');
  assert.equal(asked.length, 1);
  asked[0]!();
  assert.deepEqual(heard, ['a3', 'b']);
  latest.put('a', () => heard.push('later'));
  assert.equal(asked.length, 2);
});
