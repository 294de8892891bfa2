// Foxglove's own player for rosbridge, its data source "Rosbridge": without an error or a warning it finds topics with types of
// ROS 2, reads their messages, publishes, and calls services.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { after, before, describe, test } from 'node:test';

import WebSocket from 'ws';
import { runWorld, until } from './server.mjs';

const bundle = 'foxglove_player_bundle.mjs';
const why = existsSync('why_no_player') ? readFileSync('why_no_player', 'utf8') : 'it has not been built';

describe("Foxglove's player for rosbridge", { skip: existsSync(bundle) ? false : `not run: ${why}` }, () => {
  let server;
  let player;
  let logged;
  const problems = [];
  const messages = [];
  let last;

  before(async () => {
    server = await runWorld();
    // as in a browser
    globalThis.WebSocket = WebSocket;
    const made = await import(`./${bundle}`);
    logged = made.logged;
    const metricsCollector = { playerConstructed() {}, recordTimeToFirstMsgs() {}, close() {} };
    player = new made.RosbridgePlayer({ url: server.address, metricsCollector, sourceId: 'rosbridge-websocket' });
    player.setListener(async (state) => {
      last = state;
      problems.push(...state.problems);
      messages.push(...(state.activeData?.messages ?? []));
    });
    await until(() => last?.activeData, 'topics');
  });

  after(async () => {
    player?.close();
    await server?.end();
  });

  const messagesOn = (topic) => messages.filter((each) => each.topic === topic);

  test('it finds topics with types of ROS 2', () => {
    assert.equal(last.profile, 'ros2');
    const types = new Map(last.activeData.topics.map(({ name, schemaName }) => [name, schemaName]));
    assert.equal(types.get('/rosout'), 'rcl_interfaces/msg/Log');
    assert.equal(types.get('/camera'), 'sensor_msgs/msg/Image');
    assert.equal(types.get('/clock'), 'rosgraph_msgs/msg/Clock');
    for (const type of types.values()) assert.ok(last.activeData.datatypes.has(type), type);
  });

  test('it reads messages of all topics that have some', async () => {
    player.setSubscriptions(last.activeData.topics.map(({ name }) => ({ topic: name })));
    const image = await until(() => messagesOn('/camera')[0], 'an image');
    assert.deepEqual([image.message.width, image.message.height, image.message.encoding], [32, 24, 'rgb8']);
    assert.equal(image.message.data.length, 32 * 24 * 3);
    const poses = await until(() => messagesOn('/world/clients/pose/info')[0], 'poses');
    assert.deepEqual({ ...poses.message.transforms.find(({ child_frame_id: name }) => name === 'car').transform.rotation }, { x: 0, y: 0, z: 0, w: 1 });
    // simulated time is the player's
    await until(() => messagesOn('/clock')[0] && last.activeData.currentTime.sec < 1e6, 'the clock');
  });

  test('it publishes', async () => {
    player.setPublishers([{ topic: '/model/car/cmd_vel', schemaName: 'geometry_msgs/msg/Twist', options: {} }]);
    player.publish({ topic: '/model/car/cmd_vel', msg: { linear: { x: 2, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } } });
    const isAhead = ({ message }) => message.transforms.find(({ child_frame_id: name }) => name === 'car')?.transform.translation.x > 0.1;
    await until(() => messagesOn('/world/clients/pose/info').some(isAhead), 'the car to go');
    player.setPublishers([]);
  });

  test('it calls services', async () => {
    assert.deepEqual({ ...(await player.callService('/world/clients/control', { pause: true })) }, { data: true });
    const scene = await player.callService('/world/clients/scene/info', {});
    assert.deepEqual(scene.model.map(({ name }) => name), ['car', 'wedge']);
    await assert.rejects(player.callService('/none', {}), (fault) => /there is no service '\/none'/.test(fault));
  });

  test('it knows who publishes, subscribes and serves', async () => {
    await until(() => last.activeData.services.size > 0, 'the graph');
    assert.deepEqual([...last.activeData.services.get('/world/clients/control')], ['/pongsim']);
    assert.deepEqual([...last.activeData.publishedTopics.get('/clock')], ['/pongsim']);
    assert.deepEqual([...last.activeData.subscribedTopics.get('/model/car/cmd_vel')], ['/pongsim']);
  });

  test('it has no problem, and has logged none', () => {
    assert.deepEqual(problems, []);
    assert.deepEqual(logged, []);
  });
});
