// Foxglove's own client lists, sees the scene, listens, publishes, calls and fetches.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import wsProtocol from '@foxglove/ws-protocol';
import protobuf from 'protobufjs';
import descriptor from 'protobufjs/ext/descriptor/index.js';
import WebSocket from 'ws';

import { runWorld, until } from './server.mjs';

const { FoxgloveClient } = wsProtocol;
let server;
let client;
let info;
let graph;
const channels = new Map();
const services = new Map();
const assets = new Map();
const answers = new Map();
const failures = [];
const complaints = [];
const values = [];
let messages = [];
let time = 0n;

before(async () => {
  server = await runWorld();
  const socket = new WebSocket(server.address, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
  client = new FoxgloveClient({ ws: socket });
  client.on('serverInfo', (event) => (info = event));
  client.on('advertise', (list) => list.forEach((channel) => channels.set(channel.topic, channel)));
  client.on('advertiseServices', (list) => list.forEach((service) => services.set(service.name, service)));
  client.on('message', (event) => messages.push(event));
  client.on('time', (event) => (time = event.timestamp));
  client.on('status', (event) => complaints.push(event.message));
  client.on('connectionGraphUpdate', (event) => (graph ??= event));
  client.on('parameterValues', (event) => values.push(event));
  client.on('fetchAssetResponse', (event) => assets.set(event.requestId, event));
  client.on('serviceCallResponse', (event) => answers.set(event.callId, event));
  client.on('serviceCallFailure', (event) => failures.push(event.message));
  const topics = ['/camera', '/foxglove/camera', '/foxglove/log', '/foxglove/world/clients/tf', '/model/car/cmd_vel',
    '/world/clients/pose/info'];
  await until(() => services.has('/world/clients/control') && topics.every((topic) => channels.has(topic)), 'the world');
});

after(async () => {
  client?.close();
  await server?.end();
});

function typeOf({ schema, schemaName }) {
  const set = descriptor.FileDescriptorSet.decode(Buffer.from(schema, 'base64'));
  return protobuf.Root.fromDescriptor(set).lookupType(schemaName);
}

/// Listens until a message is as wanted.
async function heard(topic, holds, what) {
  const channel = await until(() => channels.get(topic), topic);
  const type = typeOf(channel);
  messages = [];
  const id = client.subscribe(channel.id);
  const found = await until(() => {
    const of = messages.filter(({ subscriptionId }) => subscriptionId === id);
    messages = [];
    return of
      .map(({ data }) => type.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength)))
      .find(holds);
  }, what);
  client.unsubscribe(id);
  return found;
}

const carOf = (poses) => poses.pose.find(({ name }) => name === 'car');

test('it is told what the server can, and the time', async () => {
  assert.equal(info.name, 'pongsim');
  assert.deepEqual([...info.capabilities].sort(), [
    'assets', 'clientPublish', 'connectionGraph', 'parameters', 'parametersSubscribe', 'services', 'time',
  ]);
  await until(() => time > 0n, 'the time');
});

test('it lists channels with schemas', () => {
  assert.equal(channels.get('/camera').schemaName, 'ignition.msgs.Image');
  assert.equal(channels.get('/foxglove/camera').schemaName, 'foxglove.RawImage');
  assert.equal(typeOf(channels.get('/world/clients/pose/info')).name, 'Pose_V');
});

test("it lists services with schemas, whose names are not those of the channels' types", () => {
  // Foxglove and Lichtblick report a name with two definitions as an error
  const known = new Map([...channels.values()].map(({ schemaName, schema }) => [schemaName, schema]));
  for (const { name, request, response } of services.values()) {
    for (const { schemaName, schema, schemaEncoding } of [request, response]) {
      assert.equal(schemaEncoding, 'jsonschema');
      assert.equal(known.get(schemaName) ?? schema, schema, `${name}: ${schemaName} has two definitions`);
      known.set(schemaName, schema);
      assertReadable(JSON.parse(schema), name);
    }
  }
  const { request, response } = services.get('/world/clients/control');
  assert.equal(JSON.parse(request.schema).properties.reset.properties.model_only.type, 'boolean');
  assert.equal(JSON.parse(response.schema).properties.data.type, 'boolean');
});

/// Asserts that a JSON schema has only what Lichtblick's reader of JSON schemas accepts.
function assertReadable(schema, where) {
  assert.equal(schema.type, 'object', where);
  for (const [name, field] of Object.entries(schema.properties)) {
    const inner = field.type === 'array' ? field.items : field;
    assert.ok(['boolean', 'string', 'number', 'integer', 'object'].includes(inner.type), `${where}.${name}: ${inner.type}`);
    assert.ok([undefined, 'base64'].includes(inner.contentEncoding), `${where}.${name}`);
    if (inner.type === 'object') assertReadable(inner, `${where}.${name}`);
  }
}

test('it sees the scene, its frames and pictures in its own types', async () => {
  const update = await heard('/foxglove/world/clients/scene', () => true, 'the scene');
  assert.deepEqual(update.entities.map(({ id }) => id), ['car::chassis', 'wedge::link']);
  assert.equal(update.entities[0].cubes[0].size.x, 2);
  assert.match(update.entities[1].models[0].url, /^package:\/\/pongsim\/.*wedge\.stl$/);
  assert.equal(update.entities[1].models[0].media_type, 'model/stl');
  const { transforms } = await heard('/foxglove/world/clients/tf', () => true, 'frames');
  const parents = new Map(transforms.map((each) => [each.child_frame_id, each.parent_frame_id]));
  assert.equal(parents.get('car::chassis'), 'car');
  assert.equal(parents.get('car'), 'world');
  const image = await heard('/foxglove/camera', () => true, 'an image');
  assert.deepEqual([image.width, image.height, image.encoding, image.data.length], [32, 24, 'rgb8', 32 * 24 * 3]);
  // the picture stands in a frame that there is
  assert.ok(parents.has(image.frame_id), `${image.frame_id} is none of ${[...parents.keys()]}`);
});

test('it listens and publishes, in JSON and protobuf', async () => {
  const topic = '/model/car/cmd_vel';
  const json = client.advertise({ topic, encoding: 'json', schemaName: 'ignition.msgs.Twist' });
  client.sendMessage(json, Buffer.from(JSON.stringify({ linear: { x: 1.7 } })));
  const poses = '/world/clients/pose/info';
  const there = carOf(await heard(poses, (message) => carOf(message).position.x > 0.1, 'the car to go')).position.x;
  const binary = client.advertise({ topic, encoding: 'protobuf', schemaName: 'ignition.msgs.Twist' });
  const type = typeOf(channels.get(topic));
  client.sendMessage(binary, type.encode({ linear: { x: -1.7 } }).finish());
  await heard(poses, (message) => carOf(message).position.x < there, 'the car to come back');
  client.unadvertise(json);
  client.unadvertise(binary);
});

test('it calls services, in JSON and protobuf', async () => {
  const { id } = services.get('/world/clients/control');
  const call = (callId, encoding, data) => client.sendServiceCallRequest({ serviceId: id, callId, encoding, data });
  call(1, 'json', Buffer.from('{"pause": true}'));
  const answer = await until(() => answers.get(1), 'an answer');
  assert.deepEqual([answer.encoding, Buffer.from(answer.data).toString()], ['json', '{"data":true}']);
  await heard('/world/clients/stats', ({ paused }) => paused, 'the pause');
  // pause: false
  call(2, 'protobuf', new Uint8Array());
  assert.equal((await until(() => answers.get(2), 'an answer')).encoding, 'protobuf');
  await heard('/world/clients/stats', ({ paused }) => !paused, 'the world to run');
  call(3, 'json', Buffer.from('{"pawse": true}'));
  assert.match(await until(() => failures[0], 'a failure'), /pawse/);
});

test('it gets, sets and follows parameters', async () => {
  const valueOf = (list, name) => list.find((each) => each.name === `/world/clients/${name}`)?.value;
  const answer = (id) => until(() => values.find((each) => each.id === id)?.parameters, `the answer to ${id}`);
  client.getParameters([], 'all');
  const all = await answer('all');
  assert.deepEqual(valueOf(all, 'gravity'), [0, 0, 0]);
  assert.equal(valueOf(all, 'real_time_factor'), 1);
  client.subscribeParameterUpdates(['/world/clients/gravity']);
  client.setParameters([{ name: '/world/clients/gravity', value: [0, 0, -1], type: 'float64_array' }], 'set');
  assert.deepEqual(valueOf(await answer('set'), 'gravity'), [0, 0, -1]);
  const followed = () => values.find((each) => each.id === undefined)?.parameters;
  assert.deepEqual(valueOf(await until(followed, 'the change'), 'gravity'), [0, 0, -1]);
  client.unsubscribeParameterUpdates(['/world/clients/gravity']);
  client.setParameters([{ name: '/world/clients/gravity', value: [0, 0, 0] }], 'back');
  await answer('back');
  client.setParameters([{ name: '/world/clients/paused', value: 'yes' }], 'wrong');
  assert.deepEqual(await answer('wrong'), []);
  assert.match(await until(() => complaints.splice(0)[0], 'a complaint'), /clients\/paused' must be true or false/);
});

test('it is told who publishes and listens', async () => {
  client.subscribeConnectionGraph();
  await until(() => graph, 'the graph');
  assert.ok(graph.publishedTopics.some(({ name }) => name === '/camera'));
  assert.ok(graph.subscribedTopics.some(({ name }) => name === '/model/car/cmd_vel'));
  assert.ok(graph.advertisedServices.some(({ name }) => name === '/world/clients/control'));
  client.unsubscribeConnectionGraph();
});

test('it fetches assets of the world, and no others', async () => {
  const update = await heard('/foxglove/world/clients/scene', () => true, 'the scene');
  client.fetchAsset(update.entities[1].models[0].url, 5);
  const mesh = await until(() => assets.get(5), 'the mesh');
  assert.equal(mesh.status, 0, mesh.error);
  assert.match(Buffer.from(mesh.data.buffer, mesh.data.byteOffset, mesh.data.byteLength).toString(), /^solid wedge/);
  client.fetchAsset('package://pongsim/file/etc/passwd', 6);
  assert.equal((await until(() => assets.get(6), 'an answer')).status, 1);
});

test('it is told what pongsim warns of', async () => {
  assert.equal(channels.get('/foxglove/log').schemaName, 'foxglove.Log');
  // a message that can't be a command is refused with a warning
  const twist = client.advertise({ topic: '/model/car/cmd_vel', encoding: 'json', schemaName: 'ignition.msgs.Twist' });
  const hear = heard('/foxglove/log', ({ level, name }) => level === 3 && name !== '', 'a warning');
  client.sendMessage(twist, Buffer.from(JSON.stringify({ linear: { x: 1e300 } })));
  assert.match((await hear).message, /cmd_vel/);
  client.unadvertise(twist);
});

test('it is told what it does wrong', async () => {
  client.subscribe(123456);
  client.advertise({ topic: '/t', encoding: 'cdr', schemaName: 'ignition.msgs.Twist' });
  await until(() => complaints.length === 2, 'complaints');
  assert.match(complaints[0], /no channel 123456/);
  assert.match(complaints[1], /cdr/);
});
