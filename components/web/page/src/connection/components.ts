/// Components of entities in Fortress's world states, found by name.
import type { Message, MessageTypes } from './types.ts';

const numbers = new Map<string, string>();

/// The type id of a component in a world state, for a name such as "Pose": the 64-bit FNV-1a hash of its full name, as
/// a decimal number.
export function componentNumber(name: string): string {
  let number = numbers.get(name);
  if (number === undefined) {
    let hash = 0xcbf29ce484222325n;
    for (const byte of new TextEncoder().encode('ign_gazebo_components.' + name)) {
      hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    }
    number = BigInt.asIntN(64, hash).toString();
    numbers.set(name, number);
  }
  return number;
}

/// The components of one entity: an ignition.msgs.SerializedEntityMap.
export class Components {
  constructor(private readonly entity: Message) {}

  has(name: string): boolean {
    return this.bytes(name) !== undefined;
  }

  bytes(name: string): Uint8Array | undefined {
    const component = this.entity.components[componentNumber(name)] as Message | undefined;
    return component?.component as Uint8Array | undefined;
  }

  /// The value of a component that is serialized as text, such as numbers and names.
  text(name: string): string | undefined {
    const bytes = this.bytes(name);
    return bytes && new TextDecoder().decode(bytes);
  }

  /// The values of a component with numbers separated by blanks; a pose is x y z roll pitch yaw.
  numbers(name: string): number[] | undefined {
    return this.text(name)?.trim().split(/\s+/).map(Number);
  }

  message(name: string, type: string, types: MessageTypes): Message | undefined {
    const bytes = this.bytes(name);
    return bytes && types.decode(type, bytes);
  }
}
