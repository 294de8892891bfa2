import assert from 'node:assert/strict';
import test from 'node:test';
import { Connection } from './connection.ts';
import { exampleService, FakeServer } from './fake_server.ts';
import { MessageTypes } from './types.ts';
import { World, worldNames } from './world.ts';

test('worlds are those that can be controlled or seen', () => {
  const services = ['/world/b/control', '/world/b/scene/info', '/world/a/scene/info', '/world/c/state', '/gazebo/worlds', '/world/d/model/control'];
  assert.deepEqual(worldNames(services), ['a', 'b']);
  assert.deepEqual(worldNames([]), []);
});

test('what changes during a read is read, though that read fails', async () => {
  const connection = new Connection(new MessageTypes(), FakeServer.options);
  const server = FakeServer.last;
  server.onopen?.();
  server.say({ op: 'advertiseServices', services: [exampleService(1, '/world/w/scene/info')] });
  const world = new World(connection, 'w');
  const requests = (): number => server.sent.filter((each) => each instanceof Uint8Array).length;
  assert.equal(requests(), 1);
  const again = world.read();
  assert.equal(requests(), 1);
  const refuse = (callId: number): void => server.say({ op: 'serviceCallFailure', serviceId: 1, callId, message: 'too busy' });
  refuse(1);
  await new Promise((resolve) => setImmediate(resolve));
  assert.equal(requests(), 2);
  refuse(2);
  await again;
  assert.equal(requests(), 2);
  world.end();
});
