import assert from 'node:assert/strict';
import test from 'node:test';
import { Asked } from './asked.ts';

/// Requests that settle when the test says so, the oldest first.
function later(): { made: [number[], number[]][]; request: (a: number[], b: number[]) => Promise<void>; done: () => void; fail: () => void } {
  const made: [number[], number[]][] = [];
  const waiting: { resolve: () => void; reject: (fault: Error) => void }[] = [];
  const request = (before: number[], after: number[]): Promise<void> => {
    made.push([before, after]);
    return new Promise((resolve, reject) => waiting.push({ resolve, reject }));
  };
  return { made, request, done: () => waiting.shift()!.resolve(), fail: () => waiting.shift()!.reject(new Error('refused')) };
}

const set = (i: number, value: number) => (now: number[]): number[] => now.map((old, k) => (k === i ? value : old));
const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

test('a second number entered at once does not take the first back', async () => {
  const asked = new Asked();
  const { made, request, done } = later();
  void asked.change('g', [0, 0, -9.8], set(0, 1), request);
  // the world still tells the old state
  const second = asked.change('g', [0, 0, -9.8], set(2, -2), request);
  assert.deepEqual(made, [[[0, 0, -9.8], [1, 0, -9.8]], [[1, 0, -9.8], [1, 0, -2]]]);
  done();
  await settled();
  assert.deepEqual(asked.now('g', [0, 0, -9.8]), [1, 0, -2], 'one is still on its way');
  done();
  await second;
  await settled();
  assert.deepEqual(asked.now('g', [5]), [5], 'what the world tells counts again');
});

test('what the world tells later counts only then', async () => {
  const asked = new Asked();
  let tell = (): void => {};
  await asked.change('p', 1, () => 2, async () => {}, () => new Promise((resolve) => (tell = resolve)));
  assert.equal(asked.now('p', 1), 2);
  tell();
  await settled();
  assert.equal(asked.now('p', 7), 7);
});

test('nothing is built on what was refused, nor on what was asked of others', async () => {
  const asked = new Asked();
  const { made, request, fail } = later();
  const refused = asked.change('g', [1, 1], set(0, 2), request);
  assert.deepEqual(asked.now('other', [3]), [3]);
  fail();
  await assert.rejects(refused, /refused/);
  void asked.change('g', [1, 1], set(1, 5), request);
  assert.deepEqual(made[1], [[1, 1], [1, 5]]);
});
