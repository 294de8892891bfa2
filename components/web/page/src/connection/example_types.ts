/// A few message types for unit tests.
import { create, toBinary, type MessageInitShape } from '@bufbuild/protobuf';
import {
  FieldDescriptorProto_Label as Label, FieldDescriptorProto_Type as Type, FileDescriptorSetSchema,
  type FieldDescriptorProtoSchema,
} from '@bufbuild/protobuf/wkt';
import { MessageTypes } from './types.ts';

type Field = MessageInitShape<typeof FieldDescriptorProtoSchema>;

const field = (name: string, number: number, type: Type, more: Field = {}): Field => ({
  name, number, type, label: Label.OPTIONAL, jsonName: name, ...more,
});

/// test.Point { double x; string name; Point where; repeated double list; bool on; Kind kind; bytes data; int64 big;
/// repeated Point points }, test.Vector { double x, y, z }, test.Turn { double x, y, z, w }, test.Pose { Vector position;
/// Turn orientation }
export function exampleDescriptors(): Uint8Array {
  const point = [
    field('x', 1, Type.DOUBLE),
    field('name', 2, Type.STRING),
    field('where', 3, Type.MESSAGE, { typeName: '.test.Point' }),
    field('list', 4, Type.DOUBLE, { label: Label.REPEATED }),
    field('on', 5, Type.BOOL),
    field('kind', 6, Type.ENUM, { typeName: '.test.Kind' }),
    field('data', 7, Type.BYTES),
    field('big', 8, Type.INT64),
    field('points', 9, Type.MESSAGE, { typeName: '.test.Point', label: Label.REPEATED }),
  ];
  const numbers = (names: string): Field[] => [...names].map((name, i) => field(name, i + 1, Type.DOUBLE));
  const pose = [
    field('position', 1, Type.MESSAGE, { typeName: '.test.Vector' }), field('orientation', 2, Type.MESSAGE, { typeName: '.test.Turn' }),
  ];
  const kinds = [{ name: 'NONE', number: 0 }, { name: 'ROUND', number: 1 }];
  const file = {
    name: 'test.proto', package: 'test', syntax: 'proto3',
    messageType: [
      { name: 'Point', field: point }, { name: 'Vector', field: numbers('xyz') }, { name: 'Turn', field: numbers('xyzw') },
      { name: 'Pose', field: pose },
    ],
    enumType: [{ name: 'Kind', value: kinds }],
  };
  return toBinary(FileDescriptorSetSchema, create(FileDescriptorSetSchema, { file: [file] }));
}

export function exampleTypes(): MessageTypes {
  const types = new MessageTypes();
  types.add(exampleDescriptors());
  return types;
}
