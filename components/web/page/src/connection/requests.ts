/// Service calls and requests for files without a response so far.
import { callFrame } from './protocol.ts';

type Send = (data: string | Uint8Array<ArrayBuffer>) => void;

interface Waiting<T> {
  resolve(value: T): void;
  reject(fault: Error): void;
}

export class Requests {
  private nextId = 1;
  private readonly calls = new Map<number, Waiting<Uint8Array>>();
  private readonly assets = new Map<number, Waiting<ArrayBuffer>>();

  call(service: number, payload: Uint8Array, send: Send): Promise<Uint8Array> {
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      send(callFrame(service, id, 'protobuf', payload));
      this.calls.set(id, { resolve, reject });
    });
  }

  asset(uri: string, send: Send): Promise<ArrayBuffer> {
    const requestId = this.nextId++;
    return new Promise((resolve, reject) => {
      send(JSON.stringify({ op: 'fetchAsset', uri, requestId }));
      this.assets.set(requestId, { resolve, reject });
    });
  }

  answer(id: number, payload: Uint8Array): void {
    this.calls.get(id)?.resolve(payload);
    this.calls.delete(id);
  }

  refuse(id: number, reason: string): void {
    this.calls.get(id)?.reject(new Error(reason));
    this.calls.delete(id);
  }

  answerAsset(id: number, error: string | null, payload: Uint8Array): void {
    const waiting = this.assets.get(id);
    this.assets.delete(id);
    if (error !== null) waiting?.reject(new Error(error));
    else waiting?.resolve(payload.slice().buffer);
  }

  /// Fails all pending requests, because the connection has ended.
  fail(reason: string): void {
    for (const waiting of [...this.calls.values(), ...this.assets.values()]) waiting.reject(new Error(reason));
    this.calls.clear();
    this.assets.clear();
  }
}
