import assert from 'node:assert/strict';
import test from 'node:test';
import { worldNames } from './world.ts';

test('worlds are those that can be controlled or seen', () => {
  const services = ['/world/b/control', '/world/b/scene/info', '/world/a/scene/info', '/world/c/state', '/gazebo/worlds', '/world/d/model/control'];
  assert.deepEqual(worldNames(services), ['a', 'b']);
  assert.deepEqual(worldNames([]), []);
});
