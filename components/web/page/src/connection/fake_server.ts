/// The server's side of a connection, for unit tests: records what the page sends, and passes messages to it.
import { exampleDescriptors } from './example_types.ts';
import type { Channel, Service } from './protocol.ts';
import type { ConnectionOptions, Socket } from './connection.ts';

const schema = btoa(String.fromCharCode(...exampleDescriptors()));
const side = { encoding: 'protobuf', schemaName: 'test.Point', schema };

export const exampleChannel = (id: number, topic: string): Channel => ({ id, topic, ...side });
export const exampleService = (id: number, name: string): Service => ({
  id, name, type: 'test.Point', request: side, response: side,
});

export class FakeServer implements Socket {
  static last: FakeServer;
  /// Calls scheduled for the next animation frame, and for a time.
  static pictures: (() => void)[] = [];
  static timers: (() => void)[] = [];
  static readonly options: ConnectionOptions = {
    connect: () => (FakeServer.last = new FakeServer()),
    nextAnimationFrame: (callback) => void FakeServer.pictures.push(callback),
    later: (callback) => void FakeServer.timers.push(callback),
  };

  binaryType = '';
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: ((event: { code: number; reason: string }) => void) | null = null;
  sent: (Record<string, unknown> | Uint8Array)[] = [];

  send(data: string | Uint8Array<ArrayBuffer>): void {
    this.sent.push(typeof data === 'string' ? (JSON.parse(data) as Record<string, unknown>) : data);
  }
  close(): void {
    this.onclose?.({ code: 1000, reason: '' });
  }

  say(message: object): void {
    this.onmessage?.({ data: JSON.stringify(message) });
  }

  sayData(subscription: number, payload: Uint8Array, timeNs = 0n): void {
    const frame = new Uint8Array(13 + payload.length);
    const view = new DataView(frame.buffer);
    view.setUint8(0, 1);
    view.setUint32(1, subscription, true);
    view.setBigUint64(5, timeNs, true);
    frame.set(payload, 13);
    this.onmessage?.({ data: frame.buffer });
  }

  static draw(): void {
    for (const callback of FakeServer.pictures.splice(0)) callback();
  }
}
