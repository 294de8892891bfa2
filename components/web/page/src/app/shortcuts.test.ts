import assert from 'node:assert/strict';
import test from 'node:test';
import { keysOf, kShortcuts } from './shortcuts.ts';

test('key presses are written as in the list, each of which is there once', () => {
  const press = (key: string, more = {}): string => keysOf({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...more });
  assert.equal(press(' '), 'space');
  assert.equal(press('Delete'), 'delete');
  assert.equal(press('C', { metaKey: true }), 'ctrl+c');
  assert.equal(press('Z', { ctrlKey: true, shiftKey: true }), 'ctrl+shift+z');
  assert.equal(press('?', { shiftKey: true }), '?');
  assert.equal(press('x', { altKey: true }), 'alt+x');
  assert.equal(new Set(kShortcuts.map(({ keys }) => keys)).size, kShortcuts.length);
});
