import assert from 'node:assert/strict';
import test from 'node:test';
import { isOn, switched } from './lights.ts';

test('a light is on unless its header says no', () => {
  const light = { name: 'sun', header: { data: [{ key: 'other', value: ['1'] }] } };
  assert.ok(isOn(light));
  assert.ok(isOn({}));
  const off = switched(light, false);
  assert.ok(!isOn(off));
  assert.ok(isOn(switched(off, true)));
  assert.equal(switched(off, true).header.data.length, 2);
});
