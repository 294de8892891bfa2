/// Messages of protobuf by the descriptions of their types, without generated code and without eval.
import {
  create, createFileRegistry, fromBinary, fromJson, toBinary, toJson,
  type DescMessage, type FileRegistry, type JsonValue, type Message as AnyMessage,
} from '@bufbuild/protobuf';
import { FileDescriptorSetSchema } from '@bufbuild/protobuf/wkt';

/// A decoded message: fields in camelCase, numbers of 64 bits as bigint, enums as numbers, bytes as Uint8Array, repeated
/// fields as arrays; a message that is not set is undefined, a oneof is { case, value }.
// fields are known by reflection only
export type Message = Record<string, any>;

export class MessageTypes {
  private readonly registries: FileRegistry[] = [];
  private readonly schemasSeen = new Set<string>();

  /// Takes over the types of a FileDescriptorSet. Of a type that is known the first one stays.
  /// @throws Error where the bytes are none.
  add(descriptors: Uint8Array): void {
    this.registries.push(createFileRegistry(fromBinary(FileDescriptorSetSchema, descriptors)));
  }

  /// The same of base64, as channels have it; where the type is known already it is not read.
  addSchema(typeName: string, base64: string): void {
    if (this.find(typeName) || this.schemasSeen.has(typeName)) return;
    this.schemasSeen.add(typeName);
    this.add(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
  }

  find(typeName: string): DescMessage | undefined {
    for (const registry of this.registries) {
      const found = registry.getMessage(typeName);
      if (found) return found;
    }
    return undefined;
  }

  /// @throws Error naming the type where it is unknown.
  get(typeName: string): DescMessage {
    const found = this.find(typeName);
    if (!found) throw new Error(`the message type ${typeName} is unknown`);
    return found;
  }

  /// The names of all messages that stand for themselves, in order.
  names(): string[] {
    const names = new Set<string>();
    for (const registry of this.registries) {
      for (const type of registry) if (type.kind === 'message' && !type.parent) names.add(type.typeName);
    }
    return [...names].sort();
  }

  decode(typeName: string, bytes: Uint8Array): Message {
    return fromBinary(this.get(typeName), bytes) as Message;
  }

  /// @param fields As in a decoded message; what is left out has its default.
  encode(typeName: string, fields: Message): Uint8Array {
    const type = this.get(typeName);
    return toBinary(type, create(type, fields as AnyMessage));
  }

  /// @throws Error with the field's name where the JSON does not fit the type.
  encodeJson(typeName: string, json: JsonValue): Uint8Array {
    const type = this.get(typeName);
    return toBinary(type, fromJson(type, json));
  }

  /// For reading: enums by name, numbers of 64 bits and bytes as text.
  json(typeName: string, message: Message): JsonValue {
    return toJson(this.get(typeName), message as AnyMessage, { useProtoFieldName: true });
  }
}
