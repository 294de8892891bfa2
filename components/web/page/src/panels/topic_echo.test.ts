import assert from 'node:assert/strict';
import test from 'node:test';
import { echoText } from './topic_echo.ts';

test('messages are indented, and what is long is cut', () => {
  assert.equal(echoText({ a: 1 }), '{\n  "a": 1\n}');
  assert.match(echoText({ data: 'x'.repeat(1000) }), /^.{0,120}… \(1000 letters\)/s);
  assert.match(echoText({ list: Array.from({ length: 150 }, () => 1) }), /… 50 more/);
  assert.match(echoText(Object.fromEntries(Array.from({ length: 5000 }, (_, i) => [i, 1]))), /more characters$/);
});
