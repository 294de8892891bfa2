import assert from 'node:assert/strict';
import test from 'node:test';
import { timeText } from './world_stats.ts';

test('times are days, hours, minutes and seconds', () => {
  assert.equal(timeText(undefined), '0 00:00:00.000');
  assert.equal(timeText({ sec: 3723n, nsec: 45_999_999 }), '0 01:02:03.045');
  assert.equal(timeText({ sec: 86400n * 12n + 59n, nsec: 0 }), '12 00:00:59.000');
});
