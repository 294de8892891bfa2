/// Numeric fields of messages by path, such as "pose.position.x" and "position[2]".
import type { DescField, DescMessage } from '@bufbuild/protobuf';
import { ScalarType } from '@bufbuild/protobuf';
import type { Message } from './types.ts';

/// The paths of all numbers, booleans and enums in a message, with their values; at most `most` elements of each
/// repeated field.
export function numbersIn(type: DescMessage, message: Message, most = 20): { path: string; value: number }[] {
  const found: { path: string; value: number }[] = [];
  collect(type, message, '', most, found);
  return found;
}

function collect(
  type: DescMessage, message: Message, before: string, most: number, found: { path: string; value: number }[],
): void {
  for (const field of type.fields) {
    const value = fieldOf(field, message);
    if (value === undefined) continue;
    const path = before + field.name;
    if (field.fieldKind === 'list') {
      (value as unknown[]).slice(0, most).forEach((each, i) => add(field, each, `${path}[${i}]`, most, found));
    } else if (field.fieldKind !== 'map') {
      add(field, value, path, most, found);
    }
  }
}

function add(field: DescField, value: unknown, path: string, most: number, found: { path: string; value: number }[]): void {
  if (field.message) collect(field.message, value as Message, path + '.', most, found);
  else if (typeof value === 'number' || typeof value === 'boolean' || typeof value === 'bigint') {
    found.push({ path, value: Number(value) });
  }
}

function fieldOf(field: DescField, message: Message): unknown {
  if (!field.oneof) return message[field.localName];
  const choice = message[field.oneof.localName] as { case?: string; value?: unknown } | undefined;
  return choice?.case === field.localName ? choice.value : undefined;
}

/// Parses a path once, to read the number from many messages.
/// @return A function that returns the number at the path; NaN if the message has none.
/// @throws Error if the type has no such path.
export function numberReader(type: DescMessage, path: string): (message: Message) => number {
  const parts = path.split('.');
  const steps: { field: DescField; index: number | null }[] = [];
  let at: DescMessage | undefined = type;
  for (const part of parts) {
    const [, name, index] = /^([^[\]]+)(?:\[(\d+)\])?$/.exec(part) ?? [];
    const field: DescField | undefined = at?.fields.find((each) => each.name === name);
    if (!field || (field.fieldKind === 'list') !== (index !== undefined)) throw new Error(`${type.typeName} has no ${path}`);
    steps.push({ field, index: index === undefined ? null : Number(index) });
    at = field.message;
  }
  if (at) throw new Error(`${path} of ${type.typeName} is not a number`);
  return (message) => {
    let value: unknown = message;
    for (const { field, index } of steps) {
      value = fieldOf(field, value as Message);
      if (index !== null) value = (value as unknown[] | undefined)?.[index];
      if (value === undefined) return NaN;
    }
    return Number(value);
  };
}

/// Whether a field is text, a number, a boolean or bytes.
export function scalarKind(type: ScalarType): 'text' | 'bool' | 'bytes' | 'number' {
  if (type === ScalarType.STRING) return 'text';
  if (type === ScalarType.BOOL) return 'bool';
  return type === ScalarType.BYTES ? 'bytes' : 'number';
}
