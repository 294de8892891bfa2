/// Numbers of messages by path: fields, such as "pose.position.x" and "position[2]"; of a list whose elements have names
/// also "joint[wheel].axis1.position"; and what follows from vectors and quaternions, "velocity.linear.length" and
/// "pose.orientation.yaw".
import type { DescField, DescMessage } from '@bufbuild/protobuf';
import { ScalarType } from '@bufbuild/protobuf';
import { rollPitchYawOf } from './poses.ts';
import type { Message } from './types.ts';

type Read = (message: Message) => number;

const length = ({ x, y, z }: Message): number => Math.hypot(Number(x), Number(y), Number(z));
const angle = (index: 0 | 1 | 2): Read => ({ x, y, z, w }) => rollPitchYawOf([x, y, z, w] as [number, number, number, number])[index];
const kOfVectors: ReadonlyMap<string, Read> = new Map([['length', length]]);
const kOfQuaternions: ReadonlyMap<string, Read> = new Map([['roll', angle(0)], ['pitch', angle(1)], ['yaw', angle(2)]]);

/// What follows from a message with these fields besides its header; by name.
function derivedOf(type: DescMessage): ReadonlyMap<string, Read> {
  const names = type.fields.map(({ name }) => name).filter((name) => name !== 'header').join(' ');
  if (names === 'x y z') return kOfVectors;
  return names === 'x y z w' ? kOfQuaternions : new Map();
}

/// The paths of all numbers, booleans and enums in a message, and of what follows from them, with their values; at most
/// `most` elements of each repeated field.
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
      const labels = labelsOf(value as unknown[]);
      (value as unknown[]).slice(0, most).forEach((each, i) => add(field, each, `${path}[${labels[i]}]`, most, found));
    } else if (field.fieldKind !== 'map') {
      add(field, value, path, most, found);
    }
  }
  for (const [name, read] of derivedOf(type)) found.push({ path: before + name, value: read(message) });
}

/// What stands for each element of a list in brackets: the first one with a name, if a path can contain it, else the
/// index.
function labelsOf(list: readonly unknown[]): string[] {
  const names = list.map((each) => (each as Message | null)?.name as unknown);
  return names.map((name, i) => (typeof name === 'string' && /^[^\d.[\]][^.[\]]*$/.test(name) && names.indexOf(name) === i ? name : String(i)));
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
export function numberReader(type: DescMessage, path: string): Read {
  const parts = path.split('.');
  const steps: ((value: Message) => unknown)[] = [];
  let at: DescMessage | undefined = type;
  for (const part of parts) {
    const derived: Read | undefined = at && derivedOf(at).get(part);
    if (derived) {
      steps.push(derived);
      at = undefined;
      continue;
    }
    const [, name, label] = /^([^[\]]+)(?:\[([^[\]]+)\])?$/.exec(part) ?? [];
    const field: DescField | undefined = at?.fields.find((each) => each.name === name);
    const element = label === undefined ? undefined : elementReader(field, label);
    if (!field || (field.fieldKind === 'list') !== (element !== undefined)) throw new Error(`${type.typeName} has no ${path}`);
    steps.push((value) => fieldOf(field, value));
    if (element) steps.push(element as unknown as (value: Message) => unknown);
    at = field.message;
  }
  if (at) throw new Error(`${path} of ${type.typeName} is not a number`);
  return (message) => {
    let value: unknown = message;
    for (const step of steps) {
      value = step(value as Message);
      if (value === undefined) return NaN;
    }
    return Number(value);
  };
}

/// Finds the element of a list by its index, or by its name if such elements can have one.
function elementReader(field: DescField | undefined, label: string): ((list: readonly unknown[]) => unknown) | undefined {
  if (/^\d+$/.test(label)) return (list) => list[Number(label)];
  const hasName = field?.message?.fields.some(({ name, scalar }) => name === 'name' && scalar === ScalarType.STRING);
  return hasName ? (list) => list.find((each) => (each as Message).name === label) : undefined;
}

/// Whether a field is text, a number, a boolean or bytes.
export function scalarKind(type: ScalarType): 'text' | 'bool' | 'bytes' | 'number' {
  if (type === ScalarType.STRING) return 'text';
  if (type === ScalarType.BOOL) return 'bool';
  return type === ScalarType.BYTES ? 'bytes' : 'number';
}
