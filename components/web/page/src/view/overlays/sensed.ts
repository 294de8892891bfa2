import { Group, type Object3D } from 'three';

import { matrixOf, placementOf } from '../maths/placement.ts';
import type { Message } from '../messages.ts';
import { fullName } from '../scene/content.ts';
import type { Stage } from '../scene/stage.ts';

interface Shape {
  object: Object3D;
  set(message: Message): void;
  dispose(): void;
}

interface ShownMessage {
  shape: Shape;
  message: Message;
  /// The entity in whose frame the message is, if the caller gave one.
  entity: number | undefined;
}

/// The name of a message's frame, from its header or a scan's `frame` field; empty if there is none.
export function frameNameOf(message: Message): string {
  const data = (message['header']?.data ?? []) as { key?: string; value?: string[] }[];
  const frame = data.find(({ key }) => key === 'frame_id')?.value?.[0];
  return frame ?? (message['frame'] as string | undefined) ?? '';
}

/// Overlays of sensors' latest messages, at the sensors' poses.
export class Sensed {
  readonly group = new Group();
  private readonly entries = new Map<string, ShownMessage>();

  constructor(
    private readonly stage: Stage,
    private readonly make: () => Shape,
  ) {}

  /// @param message Null removes the overlay.
  /// @param entity The entity in whose frame the message is; if missing, the frame named in the message.
  set(key: string, message: Message | null, entity?: number): void {
    let entry = this.entries.get(key);
    if (message === null) {
      if (entry === undefined) return;
      this.group.remove(entry.shape.object);
      entry.shape.dispose();
      this.entries.delete(key);
      return;
    }
    if (entry === undefined) {
      entry = { shape: this.make(), message, entity };
      entry.shape.object.matrixAutoUpdate = false;
      this.entries.set(key, entry);
      this.group.add(entry.shape.object);
    }
    entry.message = message;
    entry.entity = entity;
    entry.shape.set(message);
    this.place(entry);
  }

  /// Moves all overlays to the current poses of their sensors.
  update(): void {
    for (const entry of this.entries.values()) this.place(entry);
  }

  clear(): void {
    for (const key of [...this.entries.keys()]) this.set(key, null);
  }

  private place({ shape, message, entity }: ShownMessage): void {
    const id = entity ?? this.idOf(frameNameOf(message));
    const matrix = id === undefined ? null : this.stage.places.matrix(id);
    shape.object.matrix.copy(matrix ?? matrixOf(placementOf(message['worldPose'])));
    shape.object.updateMatrixWorld(true);
  }

  private idOf(name: string): number | undefined {
    if (name === '') return undefined;
    const { places } = this.stage.content;
    for (const id of places.keys()) if (fullName(places, id) === name) return id;
    return undefined;
  }
}
