import assert from 'node:assert/strict';
import test from 'node:test';
import { sdfName } from './spawn.ts';

test('a file is known by what it holds', () => {
  assert.equal(sdfName('<sdf version="1.9"><model name="crate">'), 'crate');
  assert.equal(sdfName("<light type='point'\n name='lamp'>"), 'lamp');
  assert.equal(sdfName('<?xml version="1.0"?><robot name="arm">'), 'arm');
  assert.equal(sdfName('hello'), null);
  assert.equal(sdfName('<model>'), null);
});
