import assert from 'node:assert/strict';
import test from 'node:test';
import { parseLayout, readAddress, writeAddress, type PageState } from './page_state.ts';

const state: PageState = {
  world: 'my world',
  view: [-6, 0.5, 6, 0, 0.5, 0],
  layout: {
    panels: [
      { id: 'EntityTree', title: 'Entity tree', place: 'left', isFolded: true },
      { id: 'ImageDisplay', title: 'Front & "back"', place: 'right', settings: { topic: ['/camera'] } },
    ],
    sizes: { left: 300 },
    tabs: { right: 1 },
  },
};

test('an address carries the state', () => {
  const address = writeAddress(state);
  assert.match(address, /^#world=my\+world&view=-6%2C0\.5%2C6%2C0%2C0\.5%2C0&panels=/);
  assert.deepEqual(readAddress(address), state);
  assert.deepEqual(readAddress(''), {});
  assert.deepEqual(readAddress(writeAddress({ world: 'w', isDrawnByServer: true })), { world: 'w', isDrawnByServer: true });
});

test('what an address has no right to say is left out', () => {
  assert.deepEqual(readAddress('#view=1,2&panels=rubbish'), {});
  assert.equal(parseLayout('null'), null);
  assert.equal(parseLayout('{"panels":7}'), null);
  const panels = [7, null, { id: 'Plotting', title: 'Plot', place: 'middle' }, { id: 'Log', title: 'x', place: 'left', settings: { 'a b': ['c'], d: 'e', f: [1] } }];
  assert.deepEqual(parseLayout(JSON.stringify({ panels, sizes: { left: 1, right: 'x', bottom: 200 }, tabs: { left: -1, right: 'x', bottom: 1e9 } })), {
    panels: [{ id: 'Log', title: 'x', place: 'left' }], sizes: { bottom: 200 },
  });
});
