import assert from 'node:assert/strict';
import test from 'node:test';
import { fullTopic } from './topic_name.ts';

test('a topic without a slash begins with one', () => {
  assert.equal(fullTopic('depth_camera'), '/depth_camera');
  assert.equal(fullTopic('model/car/cmd_vel'), '/model/car/cmd_vel');
  assert.equal(fullTopic('/camera'), '/camera');
  // none
  assert.equal(fullTopic(''), '');
});
