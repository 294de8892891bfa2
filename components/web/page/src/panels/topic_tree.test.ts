import assert from 'node:assert/strict';
import test from 'node:test';
import { panelOfType, topicTree, type TopicNode } from './topic_tree.ts';

const topics = [
  { topic: '/world/w/stats', type: 'ignition.msgs.WorldStatistics' },
  { topic: '/camera', type: 'ignition.msgs.Image' },
  { topic: '/world/w/clock', type: 'ignition.msgs.Clock' },
  { topic: '/camera/info', type: 'ignition.msgs.CameraInfo' },
  { topic: '/model/a/cmd_vel', type: 'ignition.msgs.Twist' },
];

const text = ({ name, topic, children }: TopicNode): string => `${name}${topic ? '!' : ''}${children.length > 0 ? `(${children.map(text).join(' ')})` : ''}`;
const tree = (words: string): string => topicTree(topics, words).map(text).join(' ');

test('topics are sorted by the parts of their names, and what branches not is one node', () => {
  assert.equal(tree(''), 'camera!(info!) model/a/cmd_vel! world/w(clock! stats!)');
  assert.deepEqual(topicTree([], ''), []);
});

test('names and types are found by all words', () => {
  assert.equal(tree('CLOCK'), 'world/w/clock!');
  assert.equal(tree('camera image'), 'camera!');
  assert.equal(tree('w stat'), 'world/w/stats!');
  assert.equal(tree('nothing'), '');
});

test('images and scans open in their own panels', () => {
  assert.equal(panelOfType('ignition.msgs.Image'), 'ImageDisplay');
  assert.equal(panelOfType('ignition.msgs.Twist'), 'TopicEcho');
});
