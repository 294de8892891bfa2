// gzweb's own Transport class lists, sees the scene, listens, publishes, calls and fetches.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import './browser.mjs';
import { Topic, Transport } from './gzweb_bundle.mjs';
import { runWorld, until } from './server.mjs';

let server;
let transport;
let status;

before(async () => {
  server = await runWorld();
  transport = new Transport();
  transport.getConnectionStatus().subscribe((value) => (status = value));
  transport.connect(server.address);
  await until(() => status === 'ready', 'the scene');
});

after(async () => {
  transport?.disconnect();
  await server?.end();
});

/// Listens until a message is as wanted.
async function heard(name, holds, what) {
  let last;
  transport.subscribe(new Topic(name, (message) => (last = message)));
  const found = await until(() => last && holds(last) && last, what);
  transport.unsubscribe(name);
  return found;
}

const carOf = (poses) => poses.pose.find((pose) => pose.name === 'car');

test('it lists worlds and topics, and sees the scene', async () => {
  assert.equal(transport.getWorld(), 'clients');
  await until(() => transport.getAvailableTopics().length > 0, 'topics');
  const types = new Map(transport.getAvailableTopics().map(({ topic, msg_type }) => [topic, msg_type]));
  assert.equal(types.get('/world/clients/pose/info'), 'ignition.msgs.Pose_V');
  assert.equal(types.get('/camera'), 'ignition.msgs.Image');
  const scene = transport.sceneInfo$.getValue();
  assert.deepEqual(scene.model.map(({ name }) => name), ['car', 'wedge']);
  assert.equal(scene.model[0].link[0].visual[0].geometry.box.size.x, 2);
});

test('it listens, and gets images as PNG', async () => {
  assert.equal(carOf(await heard('/world/clients/pose/info', carOf, 'poses')).name, 'car');
  const image = await heard('/camera', () => true, 'an image');
  assert.deepEqual([...image.slice(1, 4)], [...Buffer.from('PNG')]);
  assert.deepEqual([image[19], image[23]], [32, 24]);
});

test('it publishes', async () => {
  const car = transport.advertise('/model/car/cmd_vel', 'ignition.msgs.Twist');
  // it sends text, in which not all numbers can be
  car.publish(car.createMessage({ linear: { x: 2 } }));
  await heard('/world/clients/pose/info', (poses) => carOf(poses).position.x > 0.1, 'the car to go');
});

test('it calls services', async () => {
  transport.requestService('/world/clients/control', 'ignition.msgs.WorldControl', { pause: true });
  await heard('/world/clients/stats', (stats) => stats.paused, 'the pause');
});

test('it fetches assets of the world, and no others', async () => {
  const { filename } = transport.sceneInfo$.getValue().model[1].link[0].visual[0].geometry.mesh;
  const fetched = (address) => new Promise((resolve) => transport.getAsset(address, (data, error) => resolve({ data, error })));
  const mesh = await fetched(filename);
  assert.equal(mesh.error, undefined);
  assert.match(Buffer.from(mesh.data).toString(), /^solid wedge/);
  assert.equal((await fetched('/etc/passwd')).error, 'asset_not_found');
});
