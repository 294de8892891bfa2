/// One world of the server: its entities and poses, and requests to change it.
import type { Connection } from './connection.ts';
import { Emitter } from './emitter.ts';
import { completeScene, Entities } from './entities.ts';
import { FrameGatherer, readFrame, type Frame } from './frames.ts';
import type { Message } from './types.ts';

/// Types of an ignition.msgs.Entity.
export const kModel = 2;
export const kLight = 1;

/// The names of all worlds, by their services: `control`, and `scene/info`, which read-only clients also see.
export function worldNames(services: Iterable<string>): string[] {
  const names = [...services].map((name) => /^\/world\/([^/]+)\/(?:control|scene\/info)$/.exec(name)?.[1]);
  return [...new Set(names.filter((name) => name !== undefined))].sort();
}

export class World {
  /// An ignition.msgs.Scene, completed from the state; null until it has been received, or if no system provides it.
  scene: Message | null = null;
  entities = new Entities(null);
  readonly changed = new Emitter<World>();
  /// Called with the poses that have changed since the previous call.
  readonly framed = new Emitter<Frame>();
  /// The simulated time has gone back, or the connection leads to another run.
  readonly restarted = new Emitter<void>();
  revision = -1;
  private timeNs = 0n;
  private readonly frames = new FrameGatherer();
  private isDrawScheduled = false;
  private reading: Promise<void> | null = null;
  private isStale = false;
  private readonly ends: (() => void)[] = [];

  constructor(readonly connection: Connection, readonly name: string) {
    this.ends.push(
      connection.subscribeBytes(this.path('frame'), (payload) => this.receiveFrame(readFrame(payload)), true),
      connection.subscribe(this.path('scene/deletion'), () => void this.read(), true),
      connection.subscribe(this.path('scene/info'), () => void this.read()),
      connection.servicesChanged.on(() => {
        if (!this.scene && connection.services.has(this.path('scene/info'))) void this.read();
      }),
      connection.runChanged.on(() => this.restarted.emit()),
      connection.stateChanged.on((state) => {
        if (state === 'lost') this.scene = null;
      }),
    );
    void this.read();
  }

  /// The latest world pose of each link and model: position and quaternion x, y, z, w.
  get poses(): ReadonlyMap<number, Float32Array> {
    return this.frames.poses;
  }

  /// The latest poses of all links and models as one frame, for a new listener.
  allPoses(): Frame {
    return this.frames.all(this.revision);
  }

  end(): void {
    for (const end of this.ends.splice(0)) end();
  }

  /// @return "/world/NAME/" with a suffix.
  path(rest: string): string {
    return `/world/${this.name}/${rest}`;
  }

  /// Calls a service of this world.
  /// @throws Error with the reason if it fails.
  async ask(service: string, fields: Message = {}): Promise<Message> {
    return this.connection.call(this.path(service), fields);
  }

  control(fields: Message): Promise<Message> {
    return this.ask('control', fields);
  }

  async remove(id: number): Promise<void> {
    const isLight = this.entities.get(id)?.kind === 'light';
    await this.ask('remove', { id: BigInt(id), type: isLight ? kLight : kModel });
  }

  /// Requests scene and state, and repeats it if `read` is called meanwhile.
  /// @return Resolved when the scene and state are at least as new as this call.
  read(): Promise<void> {
    this.isStale = true;
    return (this.reading ??= this.readUntilFresh());
  }

  private async readUntilFresh(): Promise<void> {
    while (this.isStale) {
      this.isStale = false;
      try {
        await this.readOnce();
      } catch {
        // the connection broke, or no system provides the scene: it is requested when the service appears
      }
    }
    this.reading = null;
  }

  private async readOnce(): Promise<void> {
    const scene = await this.ask('scene/info');
    const state = this.connection.services.has(this.path('state')) ? await this.ask('state') : null;
    this.entities = new Entities(state);
    this.scene = completeScene(scene, this.entities, this.connection.types);
    this.changed.emit(this);
  }

  private receiveFrame(frame: Frame): void {
    this.frames.add(frame);
    if (frame.timeNs < this.timeNs) this.restarted.emit();
    this.timeNs = frame.timeNs;
    if (frame.revision !== this.revision) {
      this.revision = frame.revision;
      void this.read();
    }
    if (this.isDrawScheduled) return;
    this.isDrawScheduled = true;
    this.connection.nextAnimationFrame(() => {
      this.isDrawScheduled = false;
      const moved = this.frames.take();
      if (moved) this.framed.emit(moved);
    });
  }
}
