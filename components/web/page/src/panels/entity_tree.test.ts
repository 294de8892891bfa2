import assert from 'node:assert/strict';
import test from 'node:test';
import type { Entity } from '../connection/entities.ts';
import { matches } from './entity_tree.ts';

test('a search finds names and kinds, of what is below too', () => {
  const entity = (name: string, kind: string, children: Entity[] = []): Entity => ({ name, kind, children }) as unknown as Entity;
  const robot = entity('Robot', 'model', [entity('wheel', 'link')]);
  assert.ok(matches(robot, 'rob'));
  assert.ok(matches(robot, 'whe'));
  assert.ok(matches(robot, 'link'));
  assert.ok(!matches(robot, 'sensor'));
});
