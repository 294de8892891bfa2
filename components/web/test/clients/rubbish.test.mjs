// Clients that speak rubbish are told so, and nobody else notices.
import assert from 'node:assert/strict';
import { once } from 'node:events';
import { after, before, test } from 'node:test';

import WebSocket from 'ws';

import { runWorld, until } from './server.mjs';

const protocols = ['', 'foxglove.websocket.v1', 'pongsim.web.v1'];
let server;

before(async () => (server = await runWorld()));
after(() => server?.end());

/// Opens a socket that notes down what it hears.
async function open(protocol) {
  const socket = new WebSocket(server.address, protocol === '' ? [] : [protocol]);
  const heard = [];
  socket.on('message', (data) => heard.push(data));
  socket.on('error', () => {});
  await once(socket, 'open');
  return { socket, heard, close: () => socket.terminate() };
}

/// Steps that the world has made, as a polite client is told.
async function iterations() {
  const { socket, heard, close } = await open('');
  socket.send('sub,/world/clients/stats,,');
  const first = await until(() => heard.find((data) => data.toString('latin1').startsWith('pub,')), 'statistics');
  const last = await until(() => !first.equals(heard.at(-1)) && heard.at(-1), 'more statistics');
  close();
  return last;
}

/// Bytes that look like nothing, the same in each run.
function noise(size, seed) {
  const bytes = Buffer.alloc(size);
  let state = seed;
  for (let i = 0; i < size; ++i) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    bytes[i] = state >>> 24;
  }
  return bytes;
}

for (const protocol of protocols) {
  const name = protocol === '' ? "ign-launch's protocol" : protocol;

  test(`noise in ${name} is answered with words`, async () => {
    const { socket, heard, close } = await open(protocol);
    const before = heard.length;
    for (let i = 0; i < 200; ++i) socket.send(noise(1 + i * 7, i));
    for (const text of ['', '{', '[]', 'null', '{"op":[]}', ',,,', 'sub', 'dance,,,', '['.repeat(100_000)]) socket.send(text);
    await until(() => heard.length > before + 100 || socket.readyState === WebSocket.CLOSED, 'words');
    close();
    await iterations();
  });
}

test('ten thousand subscriptions leave the world as it is', async () => {
  const gz = await open('');
  for (let i = 0; i < 10_000; ++i) gz.socket.send(`sub,/nothing${i},,`);
  await until(() => gz.heard.some((data) => data.toString().includes('/nothing1000')), 'a refusal');
  const foxglove = await open('foxglove.websocket.v1');
  const subscriptions = Array.from({ length: 10_000 }, (_, id) => ({ id, channelId: (id % 50) + 1 }));
  foxglove.socket.send(JSON.stringify({ op: 'subscribe', subscriptions }));
  await until(() => foxglove.heard.some((data) => data.toString().includes('more like these')), 'a refusal');
  await iterations();
  gz.close();
  foxglove.close();
  await iterations();
});

test('clients that vanish in the middle are forgotten', async () => {
  for (let i = 0; i < 20; ++i) {
    const { socket, close } = await open(protocols[i % protocols.length]);
    socket.send('sub,/camera,,');
    close();
  }
  assert.ok(await iterations());
});
