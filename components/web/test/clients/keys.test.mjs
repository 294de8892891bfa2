// A world that asks for Gazebo's server by its name lets in who has the key, and no more than it wants.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { after, before, test } from 'node:test';

import './browser.mjs';
import { Transport } from './gzweb_bundle.mjs';
import { runWorld, until } from './server.mjs';

let server;

before(async () => (server = await runWorld('locked.sdf', [])));
after(() => server?.end());

/// Connects as gzweb does.
/// @return The status that it came to at last, and the socket's end.
function connect(key) {
  const transport = new Transport();
  const seen = [];
  transport.getConnectionStatus().subscribe((value) => seen.push(value));
  transport.connect(server.address, key);
  return { transport, seen };
}

test('gzweb gets in with the key', async () => {
  const { transport, seen } = connect('open sesame');
  await until(() => seen.at(-1) === 'ready', 'the scene');
  assert.equal(transport.getWorld(), 'locked');
  transport.disconnect();
  await until(() => seen.at(-1) === 'disconnected', 'the end');
});

test('it does not with another, or with none', async () => {
  const socket = new WebSocket(server.address);
  socket.binaryType = 'arraybuffer';
  const heard = [];
  socket.on('message', (data) => heard.push(Buffer.from(data).toString()));
  await once(socket, 'open');
  socket.send('protos,,,');
  socket.send('auth,,,sesame');
  await until(() => heard.length === 2, 'two refusals');
  assert.match(heard[0], /^error,.*auth,,,KEY/s);
  assert.equal(heard[1], 'invalid');
  socket.close();
  await once(socket, 'close');
});

test('a third client is sent away', async () => {
  const sockets = [new WebSocket(server.address), new WebSocket(server.address)];
  await Promise.all(sockets.map((socket) => once(socket, 'open')));
  const third = new WebSocket(server.address);
  const [code, reason] = await once(third, 'close');
  assert.equal(code, 1008);
  assert.equal(reason.toString(), 'max_connections');
  sockets.forEach((socket) => socket.close());
});
