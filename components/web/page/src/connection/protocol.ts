/// Frames of the Foxglove WebSocket protocol (foxglove.websocket.v1), also used by pongsim.web.v1.

export interface Channel {
  id: number;
  topic: string;
  /// "protobuf", or "pongsim" for channels of pongsim.web.v1, which are only offered to this page.
  encoding: string;
  schemaName: string;
  /// For "protobuf": a FileDescriptorSet in base64.
  schema: string;
}

export interface ServiceSide {
  encoding: string;
  schemaName: string;
  schema: string;
}

export interface Service {
  id: number;
  name: string;
  type: string;
  request?: ServiceSide;
  response?: ServiceSide;
}

/// Messages of the server in JSON.
export type ServerMessage =
  | { op: 'serverInfo'; name: string; capabilities: string[]; sessionId?: string; metadata?: Record<string, string> }
  | { op: 'status'; level: 0 | 1 | 2; message: string; id?: string }
  | { op: 'removeStatus'; statusIds: string[] }
  | { op: 'advertise'; channels: Channel[] }
  | { op: 'unadvertise'; channelIds: number[] }
  | { op: 'advertiseServices'; services: Service[] }
  | { op: 'unadvertiseServices'; serviceIds: number[] }
  | { op: 'serviceCallFailure'; serviceId: number; callId: number; message: string }
  | { op: 'parameterValues' }
  | { op: 'connectionGraphUpdate' };

/// Messages of the server in binary form.
export type ServerFrame =
  | { op: 'data'; subscription: number; timeNs: bigint; payload: Uint8Array }
  | { op: 'time'; timeNs: bigint }
  | { op: 'answer'; service: number; call: number; encoding: string; payload: Uint8Array }
  | { op: 'asset'; request: number; error: string | null; payload: Uint8Array };

/// @throws Error if the text is not an object with an "op".
export function readText(text: string): ServerMessage {
  const message: unknown = JSON.parse(text);
  if (typeof message !== 'object' || message === null || typeof (message as { op?: unknown }).op !== 'string') {
    throw new Error('a message of the server has no "op"');
  }
  return message as ServerMessage;
}

/// The result's payload is a view of `bytes`, not a copy.
/// @throws Error if there are too few bytes, or the operation in the first one is unknown.
export function readFrame(bytes: Uint8Array): ServerFrame {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const rest = (from: number): Uint8Array => {
    if (from > bytes.length) throw new RangeError('cut off');
    return bytes.subarray(from);
  };
  const text = (from: number, length: number): string => new TextDecoder().decode(rest(from).subarray(0, length));
  try {
    switch (view.getUint8(0)) {
      case 1:
        return { op: 'data', subscription: view.getUint32(1, true), timeNs: view.getBigUint64(5, true), payload: rest(13) };
      case 2:
        return { op: 'time', timeNs: view.getBigUint64(1, true) };
      case 3: {
        const length = view.getUint32(9, true);
        const [service, call] = [view.getUint32(1, true), view.getUint32(5, true)];
        return { op: 'answer', service, call, encoding: text(13, length), payload: rest(13 + length) };
      }
      case 4: {
        const length = view.getUint32(6, true);
        const error = view.getUint8(5) === 0 ? null : text(10, length);
        return { op: 'asset', request: view.getUint32(1, true), error, payload: rest(10 + length) };
      }
    }
  } catch (fault) {
    if (fault instanceof RangeError) throw new Error('a frame of the server is truncated');
    throw fault;
  }
  throw new Error(`a frame of the server begins with ${bytes[0]}, which is unknown`);
}

/// A binary message on a channel that this client has advertised.
export function publishFrame(channel: number, payload: Uint8Array): Uint8Array<ArrayBuffer> {
  const frame = new Uint8Array(5 + payload.length);
  const view = new DataView(frame.buffer);
  view.setUint8(0, 1);
  view.setUint32(1, channel, true);
  frame.set(payload, 5);
  return frame;
}

export function callFrame(service: number, call: number, encoding: string, payload: Uint8Array): Uint8Array<ArrayBuffer> {
  const name = new TextEncoder().encode(encoding);
  const frame = new Uint8Array(13 + name.length + payload.length);
  const view = new DataView(frame.buffer);
  view.setUint8(0, 2);
  view.setUint32(1, service, true);
  view.setUint32(5, call, true);
  view.setUint32(9, name.length, true);
  frame.set(name, 13);
  frame.set(payload, 13 + name.length);
  return frame;
}
