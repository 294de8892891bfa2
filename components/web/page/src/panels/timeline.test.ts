import assert from 'node:assert/strict';
import test from 'node:test';
import { isAtEnd, LatestOnly } from './timeline.ts';

test('of what is asked for meanwhile, the last is sent', async () => {
  const sent: number[] = [];
  const done: (() => void)[] = [];
  const requests = new LatestOnly<number>((value) => {
    sent.push(value);
    return new Promise<void>((resolve) => done.push(resolve));
  });
  for (const value of [1, 2, 3]) requests.ask(value);
  assert.deepEqual(sent, [1]);
  done[0]?.();
  await new Promise(setImmediate);
  assert.deepEqual(sent, [1, 3]);
  done[1]?.();
  await new Promise(setImmediate);
  requests.ask(4);
  assert.deepEqual(sent, [1, 3, 4]);
});

test('a loop begins again where the run stands at its end', () => {
  assert.ok(isAtEnd({ start: 0, end: 3, now: 3 }, true));
  assert.ok(!isAtEnd({ start: 0, end: 3, now: 3 }, false));
  assert.ok(!isAtEnd({ start: 0, end: 3, now: 2 }, true));
  assert.ok(!isAtEnd({ start: 0, end: 0, now: 0 }, true));
});
