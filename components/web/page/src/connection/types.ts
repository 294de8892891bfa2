/// Protobuf messages by reflection on their descriptors, without generated code and without eval.
import {
  create, createFileRegistry, fromBinary, fromJson, toBinary, toJson,
  type DescMessage, type FileRegistry, type JsonValue, type Message as AnyMessage,
} from '@bufbuild/protobuf';
import { FileDescriptorSetSchema } from '@bufbuild/protobuf/wkt';

/// A decoded message: fields in camelCase, 64-bit numbers as bigint, enums as numbers, bytes as Uint8Array, repeated
/// fields as arrays; an unset message is undefined, a oneof is { case, value }.
// the fields are only known by reflection
export type Message = Record<string, any>;

/// A copy without type names, because protobuf-es encodes an object with a type name as it is, even if some of its
/// fields were replaced by plain objects.
function fieldsOf(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(fieldsOf);
  if (value === null || typeof value !== 'object' || ArrayBuffer.isView(value)) return value;
  const fields = Object.entries(value).filter(([name]) => name !== '$typeName' && name !== '$unknown');
  return Object.fromEntries(fields.map(([name, part]) => [name, fieldsOf(part)]));
}

export class MessageTypes {
  private readonly registries: FileRegistry[] = [];
  private readonly schemasSeen = new Set<string>();

  /// Adds the types of a FileDescriptorSet. Types that are known already are not replaced.
  /// @throws Error if the bytes are invalid.
  add(descriptors: Uint8Array): void {
    this.registries.push(createFileRegistry(fromBinary(FileDescriptorSetSchema, descriptors)));
  }

  /// Like `add`, for the base64 text in a channel. Not parsed if the type is known.
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

  /// @throws Error with the type's name if it is unknown.
  get(typeName: string): DescMessage {
    const found = this.find(typeName);
    if (!found) throw new Error(`the message type ${typeName} is unknown`);
    return found;
  }

  /// The sorted names of all top-level message types.
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

  /// @param fields The fields of a message; missing ones have their defaults.
  encode(typeName: string, fields: Message): Uint8Array {
    const type = this.get(typeName);
    return toBinary(type, create(type, fieldsOf(fields) as AnyMessage));
  }

  /// @throws Error with the field's name if the JSON does not match the type.
  encodeJson(typeName: string, json: JsonValue): Uint8Array {
    const type = this.get(typeName);
    return toBinary(type, fromJson(type, json));
  }

  /// A message as JSON for display: enums by name, 64-bit numbers and bytes as text.
  json(typeName: string, message: Message): JsonValue {
    return toJson(this.get(typeName), message as AnyMessage, { useProtoFieldName: true });
  }
}
