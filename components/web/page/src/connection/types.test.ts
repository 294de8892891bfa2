import assert from 'node:assert/strict';
import test from 'node:test';
import { exampleTypes } from './example_types.ts';
import { MessageTypes } from './types.ts';
import { create, toBinary } from '@bufbuild/protobuf';
import { FileDescriptorSetSchema } from '@bufbuild/protobuf/wkt';

test('a message survives the way there and back', () => {
  const types = exampleTypes();
  const bytes = types.encode('test.Point', { x: 1.5, name: 'a', where: { x: -2 } });
  const message = types.decode('test.Point', bytes);
  assert.equal(message.x, 1.5);
  assert.equal(message.name, 'a');
  assert.equal(message.where.x, -2);
  assert.equal(message.where.where, undefined);
  assert.deepEqual(message.list, []);
});

test('a decoded message may be copied and changed', () => {
  const types = exampleTypes();
  const before = types.decode('test.Point', types.encode('test.Point', {
    x: 1, where: { name: 'b', list: [4] }, data: Uint8Array.of(7), points: [{ x: 2 }], big: 9n,
  }));
  const changed = { ...before, x: 5, where: { ...before.where, where: { x: 6 } }, points: [...before.points, { name: 'new' }] };
  const after = types.decode('test.Point', types.encode('test.Point', changed));
  assert.deepEqual([after.x, after.where.name, after.where.list, after.where.where.x], [5, 'b', [4], 6]);
  assert.deepEqual(after.points.map(({ x, name }: { x: number; name: string }) => [x, name]), [[2, ''], [0, 'new']]);
  assert.deepEqual([...after.data, after.big], [7, 9n]);
  // `where` is unset in the decoded message, and set here to a plain object without a type name
  const added = types.decode('test.Point', types.encode('test.Point', { ...types.decode('test.Point', new Uint8Array()), where: { x: 3 } }));
  assert.equal(added.where.x, 3);
  assert.equal(before.x, 1);
});

test('JSON is read and refused by the field', () => {
  const types = exampleTypes();
  const bytes = types.encodeJson('test.Point', { x: 3, list: [1, 2] });
  assert.deepEqual(types.json('test.Point', types.decode('test.Point', bytes)), { x: 3, list: [1, 2] });
  assert.throws(() => types.encodeJson('test.Point', { x: 'three' }), /x/);
});

test('types come from the schema of a channel, once', () => {
  const types = new MessageTypes();
  const file = { name: 'a.proto', package: 'p', syntax: 'proto3', messageType: [{ name: 'M' }] };
  const bytes = toBinary(FileDescriptorSetSchema, create(FileDescriptorSetSchema, { file: [file] }));
  types.addSchema('p.M', btoa(String.fromCharCode(...bytes)));
  assert.equal(types.get('p.M').name, 'M');
  types.addSchema('p.M', 'not base64');
  assert.deepEqual(types.names(), ['p.M']);
});

test('an unknown type is named', () => {
  assert.throws(() => new MessageTypes().decode('no.Such', new Uint8Array()), /no\.Such/);
});
