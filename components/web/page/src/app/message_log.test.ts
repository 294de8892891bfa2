import assert from 'node:assert/strict';
import test from 'node:test';
import { MessageLog } from './message_log.ts';

test('the same again is counted', () => {
  const log = new MessageLog();
  log.add('warning', 'a');
  log.add('warning', 'a');
  log.add('error', 'a');
  assert.deepEqual(log.lines.map(({ level, times }) => [level, times]), [['warning', 2], ['error', 1]]);
});

test('the oldest go', () => {
  const log = new MessageLog();
  for (let i = 0; i < 600; i++) log.add('info', String(i));
  assert.equal(log.lines.length, 500);
  assert.equal(log.lines[0]!.text, '100');
});
