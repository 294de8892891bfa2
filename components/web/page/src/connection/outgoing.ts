/// Publishing: a topic is advertised with its first message, and again on each new connection.
import { publishFrame } from './protocol.ts';
import { fullTopic } from './topic_name.ts';
import type { MessageTypes } from './types.ts';

export class Outgoing {
  private readonly ids = new Map<string, number>();
  private nextId = 1;

  constructor(
    private readonly types: MessageTypes,
    private readonly send: (data: string | Uint8Array<ArrayBuffer>) => void,
  ) {}

  /// To be called for a new connection, on which no topic is advertised yet.
  begin(): void {
    this.ids.clear();
  }

  publish(name: string, type: string, payload: Uint8Array): void {
    const topic = fullTopic(name);
    this.types.get(type);
    const key = `${topic} ${type}`;
    let id = this.ids.get(key);
    if (id === undefined) {
      id = this.nextId++;
      this.ids.set(key, id);
      this.send(JSON.stringify({ op: 'advertise', channels: [{ id, topic, encoding: 'protobuf', schemaName: type }] }));
    }
    this.send(publishFrame(id, payload));
  }
}
