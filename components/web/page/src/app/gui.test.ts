import assert from 'node:assert/strict';
import test from 'node:test';
import { placeFor, guiSettingsOf } from './gui.ts';
import { panelFor } from './registry.ts';

test('without gui the usual panels open', () => {
  const ids = guiSettingsOf(null).panels.map(({ kind }) => kind.id);
  assert.deepEqual(ids, ['WorldControl', 'WorldStats', 'EntityTree', 'ComponentInspector']);
});

test('panels float at the corner that the world says, or are docked', () => {
  assert.equal(placeFor('corner-left', 'floating', ['right', 'bottom']), 'corner-right');
  assert.equal(placeFor('corner-right', 'floating', ['left', 'bottom']), 'corner-left');
  assert.equal(placeFor('corner-left', 'docked', []), 'right');
  assert.equal(placeFor('right', 'floating', ['left']), 'right');
  assert.equal(placeFor('bottom', undefined, []), 'bottom');
});

test('plugins are known by their names and files', () => {
  assert.equal(panelFor('libKeyPublisher.so')?.id, 'KeyPublisher');
  assert.equal(panelFor('TopicViewer')?.id, 'TopicEcho');
  assert.equal(panelFor('NavSatMap'), undefined);
});
