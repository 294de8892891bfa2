import { Matrix4, Vector3 } from 'three';

import { type Placement, inverse, times } from '../maths/placement.ts';
import { type Place, isWithin } from './content.ts';

/// World poses of entities that have moved: position [m] and quaternion x, y, z, w each.
export interface Frame {
  timeNs: bigint;
  /// Changes when entities are added or removed. The scene of this revision may be set before or after the frame.
  revision: number;
  ids: Uint32Array;
  poses: Float32Array;
}

const unscaled = new Vector3(1, 1, 1);

// smaller motions are ignored, such as those of a body at rest, because they are invisible [m]
const tremble = 2e-6;

function isThere({ position: p, rotation: q }: Placement, poses: Float32Array, at: number): boolean {
  const near = (value: number, i: number) => Math.abs(value - poses[at + i]!) < tremble;
  return near(p.x, 0) && near(p.y, 1) && near(p.z, 2) && near(q.x, 3) && near(q.y, 4) && near(q.z, 5) && near(q.w, 6);
}

/// The poses of all places, and which have moved since the last call. A model dragged by its handles is shown at the
/// pose of the handles, with everything in it; poses from frames are kept until it is released.
export class Places {
  private places: ReadonlyMap<number, Place> = new Map();
  /// Lights and sensors of links by link id: they are not in frames, and move with their link.
  private readonly attached = new Map<number, number[]>();
  private readonly moved = new Set<number>();
  private held: { model: number; X_WorldModel: Placement } | null = null;

  set(places: ReadonlyMap<number, Place>): void {
    this.places = places;
    this.moved.clear();
    this.attached.clear();
    for (const place of places.values()) {
      this.moved.add(place.id);
      if (isAttached(place)) this.attached.set(place.parent, [...(this.attached.get(place.parent) ?? []), place.id]);
    }
    if (this.held && !places.has(this.held.model)) this.held = null;
  }

  /// @returns Whether a place has moved visibly.
  apply(frame: Frame): boolean {
    const { ids, poses } = frame;
    const count = Math.min(ids.length, Math.floor(poses.length / 7));
    let hasMoved = false;
    for (let i = 0; i < count; ++i) {
      const place = this.places.get(ids[i]!);
      if (place === undefined) continue;
      const at = i * 7;
      // ignores poses with infinities or NaN
      let sum = 0;
      for (let k = 0; k < 7; ++k) sum += poses[at + k]!;
      if (!Number.isFinite(sum)) continue;
      if (isThere(place.X_WorldPlace, poses, at)) continue;
      place.X_WorldPlace.position.fromArray(poses, at);
      place.X_WorldPlace.rotation.fromArray(poses, at + 3);
      this.moved.add(place.id);
      hasMoved = true;
    }
    return hasMoved;
  }

  /// Shows a model at another pose; null: at the pose from frames.
  hold(model: number, X_WorldModel: Placement | null): void {
    const before = this.held?.model ?? 0;
    this.held = X_WorldModel === null ? null : { model, X_WorldModel };
    for (const id of this.places.keys()) {
      if (isWithin(this.places, id, model) || isWithin(this.places, id, before)) this.moved.add(id);
    }
  }

  /// Takes the pose at which the held model is shown as its own, until a frame with it arrives.
  settle(): void {
    const { held } = this;
    if (held === null) return;
    for (const place of this.places.values()) {
      const shown = isWithin(this.places, place.id, held.model) && place.id !== held.model ? this.shown(place.id) : null;
      if (shown && !isAttached(place)) place.X_WorldPlace = shown;
    }
    const model = this.places.get(held.model);
    if (model) model.X_WorldPlace = held.X_WorldModel;
    this.hold(held.model, null);
  }

  /// The pose at which a place is shown.
  shown(id: number): Placement | null {
    const place = this.places.get(id);
    if (place === undefined) return null;
    if (isAttached(place)) {
      const link = this.shown(place.parent);
      return link && times(link, place.X_ParentPlace);
    }
    const { held } = this;
    if (held === null || !isWithin(this.places, id, held.model)) return place.X_WorldPlace;
    const model = this.places.get(held.model)!;
    return times(held.X_WorldModel, times(inverse(model.X_WorldPlace), place.X_WorldPlace));
  }

  /// @param into Is overwritten and returned.
  matrix(id: number, into = new Matrix4()): Matrix4 | null {
    const shown = this.shown(id);
    return shown && into.compose(shown.position, shown.rotation, unscaled);
  }

  position(id: number): Vector3 | null {
    return this.shown(id)?.position ?? null;
  }

  /// @returns The ids of places that have moved since the last call.
  takeMoved(): number[] {
    // everything in a held model moves with it
    if (this.held && this.moved.size > 0) {
      const { model } = this.held;
      if (this.moved.has(model)) this.hold(model, this.held.X_WorldModel);
    }
    const ids = [...this.moved];
    this.moved.clear();
    return ids.flatMap((id) => [id, ...(this.attached.get(id) ?? [])]);
  }
}

function isAttached(place: Place): boolean {
  return place.parent !== 0 && (place.kind === 'light' || place.kind === 'sensor');
}
