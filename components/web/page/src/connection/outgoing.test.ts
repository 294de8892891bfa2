import assert from 'node:assert/strict';
import test from 'node:test';
import { exampleTypes } from './example_types.ts';
import { Outgoing } from './outgoing.ts';

test('a topic is advertised once a connection', () => {
  const sent: string[] = [];
  const outgoing = new Outgoing(exampleTypes(), (data) => sent.push(typeof data === 'string' ? data : `#${data[1]}`));
  outgoing.publish('/a', 'test.Point', new Uint8Array());
  outgoing.publish('/a', 'test.Point', new Uint8Array());
  outgoing.publish('/b', 'test.Point', new Uint8Array());
  assert.deepEqual(sent.map((each) => each[0]), ['{', '#', '#', '{', '#']);
  assert.deepEqual(JSON.parse(sent[0]!).channels, [{ id: 1, topic: '/a', encoding: 'protobuf', schemaName: 'test.Point' }]);
  outgoing.begin();
  outgoing.publish('/a', 'test.Point', new Uint8Array());
  assert.equal(sent.length, 7);
  assert.throws(() => outgoing.publish('/a', 'no.Such', new Uint8Array()), /no\.Such/);
});
