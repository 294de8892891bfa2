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
