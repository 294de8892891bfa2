/// A connection to pongsim: topics, services and files by name. When it breaks, it is established again.
import { Emitter } from './emitter.ts';
import { Latest } from './latest.ts';
import { Outgoing } from './outgoing.ts';
import { readFrame, readText, type Channel, type ServerFrame, type ServerMessage, type Service } from './protocol.ts';
import { Requests } from './requests.ts';
import { Traffic } from './traffic.ts';
import { MessageTypes, type Message } from './types.ts';

export type ConnectionState = 'connecting' | 'open' | 'lost';

export interface Status {
  level: 0 | 1 | 2;
  message: string;
}

/// The part of a WebSocket that the connection uses.
export interface Socket {
  binaryType: string;
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: ((event: { code: number; reason: string }) => void) | null;
  send(data: string | Uint8Array<ArrayBuffer>): void;
  close(): void;
}

export interface ConnectionOptions {
  connect(): Socket;
  /// Schedules a call for the next animation frame.
  nextAnimationFrame(callback: () => void): void;
  later(callback: () => void, ms: number): void;
}

interface Listener {
  /// Whether it gets every message; else only the latest one before each animation frame.
  isEvery: boolean;
  receive(payload: Uint8Array, timeNs: bigint, channel: Channel): void;
}

interface Subscription {
  id: number;
  topic: string;
  /// The channel of the topic on the current connection; null while there is none.
  channel: Channel | null;
  listeners: Set<Listener>;
}

const kLongestWaitMs = 5000;

export class Connection {
  state: ConnectionState = 'connecting';
  /// Channels by topic, services by name.
  readonly channels = new Map<string, Channel>();
  readonly services = new Map<string, Service>();
  serverName = '';
  capabilities: string[] = [];
  /// Reason for the end of the last connection.
  reason = '';

  readonly stateChanged = new Emitter<ConnectionState>();
  /// The server has sent its `serverInfo`.
  readonly infoReceived = new Emitter<void>();
  /// After a reconnection, the server is another run than before.
  readonly runChanged = new Emitter<void>();
  readonly channelsChanged = new Emitter<void>();
  readonly servicesChanged = new Emitter<void>();
  /// A status message of the server.
  readonly statusReceived = new Emitter<Status>();
  /// What arrives for subscriptions.
  readonly traffic = new Traffic();
  readonly timeReceived = new Emitter<bigint>();

  private socket: Socket | null = null;
  private run: string | undefined;
  private waitMs = 250;
  private nextId = 1;
  private readonly subscriptions = new Map<string, Subscription>();
  private readonly byId = new Map<number, Subscription>();
  private readonly latest: Latest;
  private readonly requests = new Requests();
  private readonly outgoing: Outgoing;
  /// The message that was decoded last.
  private decoded: { payload: Uint8Array; message: Message } | null = null;

  constructor(readonly types: MessageTypes, private readonly options: ConnectionOptions) {
    this.latest = new Latest(options.nextAnimationFrame);
    this.outgoing = new Outgoing(types, (data) => this.send(data));
    this.open();
  }

  /// Whether the server is read-only.
  get isReadOnly(): boolean {
    return this.capabilities.length > 0 && !this.capabilities.includes('clientPublish');
  }

  /// Subscribes to a topic, now or when it is advertised, and again after a reconnection. Only the latest message
  /// before each animation frame is decoded, unless `isEvery`. Listeners share the message, and must not change it.
  /// @return A function that ends the subscription.
  subscribe(topic: string, receive: (message: Message, timeNs: bigint, type: string) => void, isEvery = false): () => void {
    return this.subscribeBytes(
      topic,
      (payload, timeNs, channel) => receive(this.decode(payload, channel), timeNs, channel.schemaName),
      isEvery,
    );
  }

  /// Like `subscribe`, but passes on the encoded message.
  subscribeBytes(topic: string, receive: Listener['receive'], isEvery = false): () => void {
    let subscription = this.subscriptions.get(topic);
    if (!subscription) {
      subscription = { id: this.nextId++, topic, channel: null, listeners: new Set() };
      this.subscriptions.set(topic, subscription);
      this.byId.set(subscription.id, subscription);
      this.begin(subscription);
    }
    const listener = { isEvery, receive };
    subscription.listeners.add(listener);
    return () => this.leave(subscription, listener);
  }

  /// @param fields Fields of the message; missing ones have their defaults.
  /// @throws Error if the type is unknown.
  publish(topic: string, type: string, fields: Message): void {
    this.outgoing.publish(topic, type, this.types.encode(type, fields));
  }

  /// Says what is wanted of a topic that sends only on demand. Without a subscription, or while the topic does not exist,
  /// nothing happens.
  ask(topic: string, wish: Message): void {
    const subscription = this.subscriptions.get(topic);
    if (subscription?.channel) this.send(JSON.stringify({ op: 'ask', subscriptionId: subscription.id, ...wish }));
  }

  publishBytes(topic: string, type: string, payload: Uint8Array): void {
    this.outgoing.publish(topic, type, payload);
  }

  /// @throws Error with the reason if the service does not exist or refuses the request, or the connection breaks.
  async call(name: string, fields: Message = {}): Promise<Message> {
    const service = this.services.get(name);
    if (!service?.request || !service.response) {
      // the server hides services that change something from read-only clients
      throw new Error(`the world has no service ${name}${this.isReadOnly ? ': this page is read-only' : ''}`);
    }
    const request = this.types.encode(service.request.schemaName, fields);
    const answer = await this.requests.call(service.id, request, (data) => this.sendNow(data));
    return this.types.decode(service.response.schemaName, answer);
  }

  /// Requests a file by its address in the scene.
  asset(address: string): Promise<ArrayBuffer> {
    return this.requests.asset(address, (data) => this.sendNow(data));
  }

  /// Schedules a call for the next animation frame.
  nextAnimationFrame(callback: () => void): void {
    this.options.nextAnimationFrame(callback);
  }

  private open(): void {
    this.setState('connecting');
    const socket = this.options.connect();
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      this.waitMs = 250;
      this.setState('open');
      this.outgoing.begin();
    };
    socket.onmessage = ({ data }) => {
      try {
        if (typeof data === 'string') this.receiveText(readText(data));
        else this.receiveFrame(readFrame(new Uint8Array(data as ArrayBuffer)));
      } catch (fault) {
        this.statusReceived.emit({ level: 2, message: String(fault) });
      }
    };
    socket.onclose = ({ reason }) => this.lose(reason);
    this.socket = socket;
  }

  private lose(reason: string): void {
    this.socket = null;
    this.reason = reason;
    this.requests.fail(reason || 'the connection is lost');
    this.channels.clear();
    this.services.clear();
    for (const subscription of this.byId.values()) subscription.channel = null;
    this.setState('lost');
    this.channelsChanged.emit();
    this.servicesChanged.emit();
    this.options.later(() => this.open(), this.waitMs);
    this.waitMs = Math.min(2 * this.waitMs, kLongestWaitMs);
  }

  private receiveText(message: ServerMessage): void {
    switch (message.op) {
      case 'serverInfo':
        this.serverName = message.name;
        this.capabilities = message.capabilities;
        if (this.run !== undefined && this.run !== message.sessionId) this.runChanged.emit();
        this.run = message.sessionId;
        this.infoReceived.emit();
        return;
      case 'status':
        this.statusReceived.emit(message);
        return;
      case 'advertise':
        for (const channel of message.channels) this.addChannel(channel);
        this.channelsChanged.emit();
        return;
      case 'unadvertise':
        this.removeChannels(new Set(message.channelIds));
        this.channelsChanged.emit();
        return;
      case 'advertiseServices':
        for (const service of message.services) this.addService(service);
        this.servicesChanged.emit();
        return;
      case 'unadvertiseServices':
        for (const [name, { id }] of this.services) if (message.serviceIds.includes(id)) this.services.delete(name);
        this.servicesChanged.emit();
        return;
      case 'serviceCallFailure':
        this.requests.refuse(message.callId, message.message);
        return;
      case 'removeStatus':
      case 'parameterValues':
      case 'connectionGraphUpdate':
        return;
    }
  }

  private receiveFrame(frame: ServerFrame): void {
    switch (frame.op) {
      case 'data':
        this.receiveData(frame.subscription, frame.payload, frame.timeNs);
        return;
      case 'time':
        this.timeReceived.emit(frame.timeNs);
        return;
      case 'answer':
        this.requests.answer(frame.call, frame.payload);
        return;
      case 'asset':
        this.requests.answerAsset(frame.request, frame.error, frame.payload);
        return;
    }
  }

  private receiveData(id: number, payload: Uint8Array, timeNs: bigint): void {
    const subscription = this.byId.get(id);
    const channel = subscription?.channel;
    if (!subscription || !channel) return;
    this.traffic.add(subscription.topic, payload.length);
    for (const listener of [...subscription.listeners]) {
      if (listener.isEvery) listener.receive(payload, timeNs, channel);
      else this.latest.put(listener, () => listener.receive(payload, timeNs, channel));
    }
  }

  /// Decodes a message once for all its listeners.
  private decode(payload: Uint8Array, { schemaName }: Channel): Message {
    if (this.decoded?.payload !== payload) this.decoded = { payload, message: this.types.decode(schemaName, payload) };
    return this.decoded.message;
  }

  private addChannel(channel: Channel): void {
    if (channel.encoding === 'protobuf') this.types.addSchema(channel.schemaName, channel.schema);
    this.channels.set(channel.topic, channel);
    const subscription = this.subscriptions.get(channel.topic);
    if (subscription && !subscription.channel) this.begin(subscription);
  }

  private removeChannels(ids: Set<number>): void {
    for (const [topic, { id }] of this.channels) if (ids.has(id)) this.channels.delete(topic);
    for (const subscription of this.byId.values()) {
      // the server has ended the channel
      if (subscription.channel && ids.has(subscription.channel.id)) subscription.channel = null;
    }
  }

  private addService(service: Service): void {
    for (const side of [service.request, service.response]) {
      if (side?.encoding === 'protobuf') this.types.addSchema(side.schemaName, side.schema);
    }
    this.services.set(service.name, service);
  }

  private begin(subscription: Subscription): void {
    const channel = this.channels.get(subscription.topic);
    if (!channel || this.state !== 'open') return;
    subscription.channel = channel;
    const request = { id: subscription.id, channelId: channel.id };
    this.send(JSON.stringify({ op: 'subscribe', subscriptions: [request] }));
  }

  private leave(subscription: Subscription, listener: Listener): void {
    this.latest.drop(listener);
    if (!subscription.listeners.delete(listener) || subscription.listeners.size > 0) return;
    this.subscriptions.delete(subscription.topic);
    this.byId.delete(subscription.id);
    if (subscription.channel) this.send(JSON.stringify({ op: 'unsubscribe', subscriptionIds: [subscription.id] }));
  }

  private setState(state: ConnectionState): void {
    this.state = state;
    this.stateChanged.emit(state);
  }

  private send(data: string | Uint8Array<ArrayBuffer>): void {
    if (this.state === 'open') this.socket?.send(data);
  }

  private sendNow(data: string | Uint8Array<ArrayBuffer>): void {
    if (this.state !== 'open') throw new Error('there is no connection');
    this.send(data);
  }
}
