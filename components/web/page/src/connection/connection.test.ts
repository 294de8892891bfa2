import assert from 'node:assert/strict';
import test from 'node:test';
import { Connection } from './connection.ts';
import { exampleChannel, exampleService, FakeServer } from './fake_server.ts';
import { MessageTypes } from './types.ts';

function connected(): Connection {
  const connection = new Connection(new MessageTypes(), FakeServer.options);
  FakeServer.last.onopen?.();
  return connection;
}
const point = (connection: Connection, x: number): Uint8Array => connection.types.encode('test.Point', { x });

test('a subscription waits for its topic, and ends with its last listener', () => {
  const connection = connected();
  const server = FakeServer.last;
  const heard: number[] = [];
  const ends = [1, 2].map(() => connection.subscribe('/a', (message) => heard.push(message.x), true));
  assert.deepEqual(server.sent, []);
  server.say({ op: 'advertise', channels: [exampleChannel(9, '/a')] });
  assert.deepEqual(server.sent, [{ op: 'subscribe', subscriptions: [{ id: 1, channelId: 9 }] }]);
  server.sayData(1, point(connection, 4));
  assert.deepEqual(heard, [4, 4]);
  ends[0]!();
  ends[0]!();
  assert.equal(server.sent.length, 1);
  ends[1]!();
  assert.deepEqual(server.sent[1], { op: 'unsubscribe', subscriptionIds: [1] });
});

test('only the latest message before a picture is heard', () => {
  const connection = connected();
  const heard: number[] = [];
  FakeServer.last.say({ op: 'advertise', channels: [exampleChannel(1, '/a')] });
  connection.subscribe('/a', (message) => heard.push(message.x));
  for (const x of [1, 2, 3]) FakeServer.last.sayData(1, point(connection, x));
  assert.deepEqual(heard, []);
  FakeServer.draw();
  assert.deepEqual(heard, [3]);
});

test('a channel that goes and comes back is subscribed to again', () => {
  connected();
  const connection = connected();
  const server = FakeServer.last;
  connection.subscribe('/a', () => {});
  server.say({ op: 'advertise', channels: [exampleChannel(1, '/a')] });
  server.say({ op: 'unadvertise', channelIds: [1] });
  assert.equal(connection.channels.size, 0);
  server.say({ op: 'advertise', channels: [exampleChannel(2, '/a')] });
  assert.equal(server.sent.length, 2);
  assert.deepEqual(server.sent.at(-1), { op: 'subscribe', subscriptions: [{ id: 1, channelId: 2 }] });
});

test('a lost connection is made again, with its subscriptions', () => {
  const connection = connected();
  const states: string[] = [];
  connection.stateChanged.on((state) => states.push(state));
  FakeServer.last.say({ op: 'advertise', channels: [exampleChannel(1, '/a')] });
  connection.subscribe('/a', () => {});
  FakeServer.timers.length = 0;
  FakeServer.last.onclose?.({ code: 1006, reason: '' });
  assert.equal(connection.channels.size, 0);
  FakeServer.timers[0]!();
  FakeServer.last.onopen?.();
  FakeServer.last.say({ op: 'advertise', channels: [exampleChannel(5, '/a')] });
  assert.deepEqual(states, ['lost', 'connecting', 'open']);
  assert.deepEqual(FakeServer.last.sent, [{ op: 'subscribe', subscriptions: [{ id: 1, channelId: 5 }] }]);
});

test('a service answers, refuses, or is not there', async () => {
  const connection = connected();
  const server = FakeServer.last;
  server.say({ op: 'advertiseServices', services: [exampleService(3, '/s')] });
  const answer = connection.call('/s', { x: 1 });
  const bytes = point(connection, 8);
  const name = new TextEncoder().encode('protobuf');
  server.onmessage?.({ data: Uint8Array.from([3, 3, 0, 0, 0, 1, 0, 0, 0, 8, 0, 0, 0, ...name, ...bytes]).buffer });
  assert.equal((await answer).x, 8);
  const refused = connection.call('/s');
  server.say({ op: 'serviceCallFailure', serviceId: 3, callId: 2, message: 'not so' });
  await assert.rejects(refused, /not so/);
  await assert.rejects(connection.call('/t'), /no service \/t/);
  const cutOff = connection.call('/s');
  server.onclose?.({ code: 1006, reason: '' });
  await assert.rejects(cutOff, /connection is lost/);
  assert.throws(() => connection.publish('/a', 'no.Such', {}), /no\.Such/);
});

test('rubbish of a server is told and does no harm', () => {
  const connection = connected();
  const told: string[] = [];
  connection.statusReceived.on(({ message }) => told.push(message));
  FakeServer.last.onmessage?.({ data: 'torn {' });
  FakeServer.last.onmessage?.({ data: new ArrayBuffer(0) });
  FakeServer.last.sayData(99, new Uint8Array());
  assert.equal(told.length, 2);
  assert.equal(connection.state, 'open');
});
