// roslibjs lists topics, listens in JSON and CBOR, publishes and calls, with types of ROS.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import ROSLIB from 'roslib';
import { runWorld, until } from './server.mjs';

let server;
let ros;
const statuses = [];

before(async () => {
  server = await runWorld();
  ros = new ROSLIB.Ros({ url: server.address });
  ros.on('error', (fault) => statuses.push(String(fault)));
  // roslibjs emits them under the ids of requests, too
  const emit = ros.emit.bind(ros);
  ros.emit = (name, ...more) => {
    if (String(name).startsWith('status')) statuses.push(more[0]);
    return emit(name, ...more);
  };
  await until(() => ros.isConnected, 'a connection');
});

after(async () => {
  ros?.close();
  await server?.end();
});

const topic = (name, messageType, more = {}) => new ROSLIB.Topic({ ros, name, messageType, ...more });

/// Listens until a message is as wanted.
async function heard(listened, holds, what) {
  let last;
  listened.subscribe((message) => (last = message));
  const found = await until(() => last && holds(last) && last, what);
  listened.unsubscribe();
  return found;
}

const poses = () => topic('/world/clients/pose/info', 'tf2_msgs/TFMessage');
const carOf = ({ transforms }) => transforms.find(({ child_frame_id }) => child_frame_id === 'car');

test('it lists topics with types of ROS', async () => {
  const list = await new Promise((resolve, reject) => ros.getTopics(resolve, reject));
  const types = new Map(list.topics.map((name, i) => [name, list.types[i]]));
  assert.equal(types.get('/camera'), 'sensor_msgs/msg/Image');
  assert.equal(types.get('/world/clients/pose/info'), 'tf2_msgs/msg/TFMessage');
  assert.equal(types.get('/clock'), 'rosgraph_msgs/msg/Clock');
  const raw = await new Promise((resolve, reject) => ros.getTopicsAndRawTypes(resolve, reject));
  assert.match(raw.typedefs_full_text[raw.topics.indexOf('/clock')], /^builtin_interfaces\/Time clock/);
});

test('it listens, in JSON and in CBOR', async () => {
  const { transform } = carOf(await heard(poses(), carOf, 'poses'));
  assert.deepEqual(transform.rotation, { x: 0, y: 0, z: 0, w: 1 });
  const image = await heard(topic('/camera', 'sensor_msgs/Image'), () => true, 'an image');
  assert.deepEqual([image.width, image.height, image.encoding], [32, 24, 'rgb8']);
  assert.equal(Buffer.from(image.data, 'base64').length, 32 * 24 * 3);
  const packed = await heard(topic('/camera', 'sensor_msgs/Image', { compression: 'cbor' }), () => true, 'an image in CBOR');
  assert.ok(packed.data instanceof Uint8Array);
  assert.equal(packed.data.length, 32 * 24 * 3);
});

test('it gets as few messages as it asks for', async () => {
  const times = [];
  const slow = topic('/clock', 'rosgraph_msgs/Clock', { throttle_rate: 250 });
  slow.subscribe(() => times.push(Date.now()));
  await until(() => times.length >= 5, 'five messages');
  slow.unsubscribe();
  // messages that are on their way may be late, but without the limit there are a thousand per second
  assert.ok(times[4] - times[0] > 400, `five in ${times[4] - times[0]} ms`);
});

test('it publishes', async () => {
  const command = topic('/model/car/cmd_vel', 'geometry_msgs/Twist');
  command.advertise();
  command.publish(new ROSLIB.Message({ linear: { x: 2 } }));
  await heard(poses(), (tf) => carOf(tf).transform.translation.x > 0.1, 'the car to go');
  command.unadvertise();
});

test('it is told what is wrong', async () => {
  statuses.length = 0;
  const wrong = topic('/model/car/cmd_vel', 'geometry_msgs/Twist');
  wrong.publish(new ROSLIB.Message({ linear: { x: 'fast' } }));
  await until(() => statuses.some(({ msg }) => /linear\.x is not a number/.test(msg)), 'what is wrong');
  topic('/other', 'geometry_msgs/Twits').publish(new ROSLIB.Message({}));
  await until(() => statuses.some(({ msg }) => /'geometry_msgs\/msg\/Twits' is no type of ROS/.test(msg)), 'the type');
  topic('/camera', 'std_msgs/String').subscribe(() => {});
  await until(() => statuses.some(({ msg }) => /messages of type sensor_msgs\/msg\/Image, not std_msgs\/msg\/String/.test(msg)), 'the other type');
  statuses.length = 0;
});

test('it calls services', async () => {
  const call = (name, fields) => new Promise((resolve, reject) =>
    new ROSLIB.Service({ ros, name, serviceType: '' }).callService(new ROSLIB.ServiceRequest(fields), resolve, reject));
  assert.deepEqual({ ...(await call('/world/clients/control', { pause: true })) }, { data: true });
  const scene = await call('/world/clients/scene/info', {});
  assert.deepEqual(scene.model.map(({ name }) => name), ['car', 'wedge']);
  await assert.rejects(call('/none', {}), (why) => /there is no service '\/none'/.test(why));
});

test('nothing else was reported', () => assert.deepEqual(statuses, []));
