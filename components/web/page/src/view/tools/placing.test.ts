import assert from 'node:assert/strict';
import test from 'node:test';

import { arrowOffset } from './placing.ts';

const press = (key: string, shiftKey = false) => ({ key, shiftKey });

test('arrows move along the axis that is nearest to their direction on the screen', () => {
  assert.deepEqual(arrowOffset(press('ArrowUp'), { x: 1, y: 0.3 }), [0.1, 0]);
  assert.deepEqual(arrowOffset(press('ArrowLeft'), { x: 1, y: 0.3 }), [0, 0.1]);
  assert.deepEqual(arrowOffset(press('ArrowRight', true), { x: 1, y: 0.3 }), [0, -1]);
  assert.deepEqual(arrowOffset(press('ArrowUp'), { x: 0.2, y: -1 }), [0, -0.1]);
  assert.deepEqual(arrowOffset(press('ArrowDown'), { x: -1, y: 0 }), [0.1, 0]);
  // a view from above has a direction on the screen, too: that of its yaw
  assert.deepEqual(arrowOffset(press('ArrowUp'), { x: 1e-3, y: 0 }), [0.1, 0]);
});

test('other keys move nothing', () => assert.equal(arrowOffset(press('a'), { x: 1, y: 0 }), null));
