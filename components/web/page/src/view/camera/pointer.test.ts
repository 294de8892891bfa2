import assert from 'node:assert/strict';
import { test } from 'node:test';

import { turns } from './pointer.ts';

test("the buttons that turn are those of Fortress's window", () => {
  const at = (button: number, shiftKey = false) => turns({ button, shiftKey, ctrlKey: false, metaKey: false, pointerType: 'mouse' });
  assert.equal(at(0), false);
  assert.equal(at(0, true), true);
  assert.equal(at(1), true);
  assert.equal(at(2), false);
});

test('a finger turns', () => {
  assert.ok(turns({ button: 0, shiftKey: false, ctrlKey: false, metaKey: false, pointerType: 'touch' }));
});
