import assert from 'node:assert/strict';
import test from 'node:test';
import { History, kMostChanges, type Change } from './history.ts';

/// A change of a number to another one.
function change(place: { value: number }, value: number): Change {
  const before = place.value;
  return {
    what: `to ${value}`,
    redo: async () => void (place.value = value),
    undo: async () => void (place.value = before),
  };
}

test('changes are undone and redone in their order, until another one is made', async () => {
  const history = new History();
  const place = { value: 0 };
  await history.perform(change(place, 1));
  await history.perform(change(place, 2));
  assert.equal(await history.undo(), 'to 2');
  assert.equal(place.value, 1);
  assert.equal(history.nextRedo, 'to 2');
  assert.equal(await history.redo(), 'to 2');
  assert.equal(place.value, 2);
  await history.undo();
  await history.undo();
  assert.equal(place.value, 0);
  assert.equal(await history.undo(), undefined);
  await history.perform(change(place, 3));
  assert.equal(history.nextRedo, undefined);
});

test('what is refused is no part of it, and what can no longer be undone is forgotten', async () => {
  const history = new History();
  const refuse = async (): Promise<void> => Promise.reject(new Error('it has gone'));
  await assert.rejects(history.perform({ what: 'a', redo: refuse, undo: async () => {} }), /it has gone/);
  assert.equal(history.nextUndo, undefined);
  const place = { value: 0 };
  await history.perform(change(place, 1));
  await history.perform({ what: 'b', redo: async () => {}, undo: refuse });
  await assert.rejects(history.undo(), /it has gone/);
  assert.equal(await history.undo(), 'to 1');
});

test('a change that is asked for during another waits for it', async () => {
  const history = new History();
  const order: string[] = [];
  const slow = history.perform({
    what: 'slow',
    redo: async () => {
      await new Promise((resolve) => setImmediate(resolve));
      order.push('slow');
    },
    undo: async () => void order.push('undone'),
  });
  await Promise.all([slow, history.undo()]);
  assert.deepEqual(order, ['slow', 'undone']);
});

test('it has a limit, and ends with a reset', async () => {
  const history = new History();
  const place = { value: 0 };
  for (let i = 1; i <= kMostChanges + 5; ++i) await history.perform(change(place, i));
  let count = 0;
  while (await history.undo()) ++count;
  assert.equal(count, kMostChanges);
  assert.equal(place.value, 5);
  history.replace(1, 2);
  history.clear();
  assert.equal(history.nextRedo, undefined);
  assert.equal(history.current(1), 1);
});

test('entities that come back have other ids', () => {
  const history = new History();
  history.replace(7, 20);
  history.replace(20, 31);
  assert.equal(history.current(7), 31);
  assert.equal(history.current(8), 8);
});
