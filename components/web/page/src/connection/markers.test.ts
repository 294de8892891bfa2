import assert from 'node:assert/strict';
import test from 'node:test';
import type { Connection } from './connection.ts';
import { Emitter } from './emitter.ts';
import { MarkerFeed } from './markers.ts';
import type { Message } from './types.ts';

const header = (world: string): Message => ({ header: { data: [{ key: 'world', value: [world] }] } });

/// A connection to a server with these markers, and what is needed to change them.
function server(list: Message | null) {
  let receive: (message: Message) => void = () => {};
  const frames: (() => void)[] = [];
  const servicesChanged = new Emitter<void>();
  const stateChanged = new Emitter<string>();
  const connection = {
    services: new Map(list ? [['/marker/list', {}]] : []),
    servicesChanged,
    stateChanged,
    subscribe: (_: string, listener: (message: Message) => void) => {
      receive = listener;
      return () => (receive = () => {});
    },
    call: async () => list ?? {},
    nextAnimationFrame: (callback: () => void) => frames.push(callback),
  } as unknown as Connection;
  let last: Message[] = [];
  let times = 0;
  const feed = new MarkerFeed(connection, 'w', (markers) => {
    last = [...markers.values()];
    ++times;
  });
  /// Those shown after an animation frame.
  const markers = (): Message[] => {
    for (const each of frames.splice(0)) each();
    return last;
  };
  const shown = (): string[] => markers().map(({ ns, id }) => `${ns ?? ''}\n${id}`);
  return {
    feed, connection, servicesChanged, stateChanged, markers, shown,
    times: () => times,
    tell: (message: Message) => receive(message),
  };
}

const settled = (): Promise<void> => new Promise((resolve) => setImmediate(resolve));

test('markers are those of the list, and what becomes of them', async () => {
  const { tell, shown } = server({ ...header('w'), marker: [{ ns: 'a', id: 1n }] });
  await settled();
  assert.deepEqual(shown(), ['a\n1']);
  tell({ ...header('w'), ns: 'a', id: 2n });
  tell({ ...header('w'), ns: 'b', id: 1n });
  assert.deepEqual(shown(), ['a\n1', 'a\n2', 'b\n1']);
  tell({ ...header('w'), ns: 'a', id: 1n, action: 1 });
  assert.deepEqual(shown(), ['a\n2', 'b\n1']);
  tell({ ...header('w'), ns: 'a', action: 2 });
  assert.deepEqual(shown(), ['b\n1']);
  tell({ ...header('w'), action: 2 });
  assert.deepEqual(shown(), []);
});

test('markers of other worlds are not shown', async () => {
  const { tell, shown } = server({ ...header('other'), marker: [{ id: 1n }] });
  await settled();
  tell({ ...header('other'), id: 2n });
  tell({ id: 3n });
  assert.deepEqual(shown(), []);
});

test('markers are asked for where the service appears later, and anew after a lost connection', async () => {
  const { connection, servicesChanged, stateChanged, shown, feed } = server(null);
  (connection.services as Map<string, unknown>).set('/marker/list', {});
  Object.assign(connection, { call: async () => ({ ...header('w'), marker: [{ id: 5n }] }) });
  servicesChanged.emit();
  await settled();
  assert.deepEqual(shown(), ['\n5']);
  stateChanged.emit('lost');
  assert.deepEqual(shown(), []);
  servicesChanged.emit();
  await settled();
  assert.deepEqual(shown(), ['\n5']);
  feed.end();
});

test('markers are shown once per animation frame, and not after the end', () => {
  const { tell, shown, times, feed } = server(null);
  for (const id of [1n, 2n, 3n]) tell({ ...header('w'), id });
  assert.deepEqual(shown(), ['\n1', '\n2', '\n3']);
  assert.equal(times(), 1);
  tell({ ...header('w'), id: 4n });
  feed.end();
  shown();
  assert.equal(times(), 1);
});

test('changes that overtake the list are kept', async () => {
  const old = [1n, 2n, 3n].map((id) => ({ ns: 'a', id, text: 'old' }));
  const { tell, shown, markers } = server({ ...header('w'), marker: [...old, { ns: 'b', id: 1n }, { id: 1n }] });
  tell({ ...header('w'), ns: 'a', id: 1n, action: 1 });
  tell({ ...header('w'), ns: 'a', id: 2n, text: 'new' });
  tell({ ...header('w'), ns: 'b', action: 2 });
  await settled();
  assert.deepEqual(shown(), ['a\n2', 'a\n3', '\n1']);
  assert.deepEqual(markers().map(({ text }) => text), ['new', 'old', undefined]);
});

test('a list is not shown that was asked for before all were deleted', async () => {
  const { tell, shown } = server({ ...header('w'), marker: [{ ns: 'a', id: 1n }, { id: 1n }] });
  tell({ ...header('w'), action: 2 });
  await settled();
  assert.deepEqual(shown(), []);
});

test('markers are asked for again after a failure', async () => {
  const { connection, servicesChanged, shown } = server(null);
  (connection.services as Map<string, unknown>).set('/marker/list', {});
  Object.assign(connection, { call: async () => Promise.reject(new Error('too slow')) });
  servicesChanged.emit();
  await settled();
  Object.assign(connection, { call: async () => ({ ...header('w'), marker: [{ id: 5n }] }) });
  servicesChanged.emit();
  await settled();
  assert.deepEqual(shown(), ['\n5']);
});
