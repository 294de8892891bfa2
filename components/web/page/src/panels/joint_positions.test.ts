import assert from 'node:assert/strict';
import test from 'node:test';
import { controllerTopic, rangeOf } from './joint_positions.ts';

test('a slider goes from limit to limit, or as far as makes sense', () => {
  assert.deepEqual(rangeOf('revolute', { limitLower: -0.5, limitUpper: 2 }), [-0.5, 2]);
  assert.deepEqual(rangeOf('revolute', { limitLower: -1e16, limitUpper: 1e16 }), [-Math.PI, Math.PI]);
  assert.deepEqual(rangeOf('continuous', { limitLower: -Infinity, limitUpper: Infinity }), [-Math.PI, Math.PI]);
  assert.deepEqual(rangeOf('prismatic', undefined), [-1, 1]);
});

test('a joint is moved on the topic of its controller', () => {
  const usual = '/model/arm/joint/elbow/0/cmd_pos';
  assert.equal(controllerTopic('arm', 'elbow', ['/elbow', usual]), usual);
  assert.equal(controllerTopic('arm', 'elbow', ['/model/other/joint/elbow/0/cmd_pos', '/topic_elbow']), '/topic_elbow');
  assert.equal(controllerTopic('arm', 'elbow', ['/speed']), '');
});
