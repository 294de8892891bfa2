import { Matrix4, Vector3 } from 'three';

import { type Placement, inverse, times } from '../maths/placement.ts';
import { type Place, isWithin } from './content.ts';

/// World poses of what has moved: 7 numbers each, position [m] and quaternion x, y, z, w.
export interface Frame {
  timeNs: bigint;
  /// Changes when entities are added or removed: setScene has been called with that scene, or will be.
  revision: number;
  ids: Uint32Array;
  poses: Float32Array;
}

const unscaled = new Vector3(1, 1, 1);

// smaller motions, such as the trembling of a body at rest, are invisible [m]
const tremble = 2e-6;

function isThere({ position: p, rotation: q }: Placement, poses: Float32Array, at: number): boolean {
  const near = (value: number, i: number) => Math.abs(value - poses[at + i]!) < tremble;
  return near(p.x, 0) && near(p.y, 1) && near(p.z, 2) && near(q.x, 3) && near(q.y, 4) && near(q.z, 5) && near(q.w, 6);
}

/// The poses of everything, and what has moved since the last call. A model held by its handles is shown where it is
/// held, with everything in it; its poses from frames are kept for later.
export class Places {
  private places: ReadonlyMap<number, Place> = new Map();
  /// Lights and sensors of links are not in frames: they move with their link.
  private readonly riders = new Map<number, number[]>();
  private readonly moved = new Set<number>();
  private held: { model: number; X_WorldModel: Placement } | null = null;

  set(places: ReadonlyMap<number, Place>): void {
    this.places = places;
    this.moved.clear();
    this.riders.clear();
    for (const place of places.values()) {
      this.moved.add(place.id);
      if (isRider(place)) this.riders.set(place.parent, [...(this.riders.get(place.parent) ?? []), place.id]);
    }
    if (this.held && !places.has(this.held.model)) this.held = null;
  }

  /// @returns Whether anything has moved visibly.
  apply(frame: Frame): boolean {
    const { ids, poses } = frame;
    const count = Math.min(ids.length, Math.floor(poses.length / 7));
    let hasMoved = false;
    for (let i = 0; i < count; ++i) {
      const place = this.places.get(ids[i]!);
      if (place === undefined) continue;
      const at = i * 7;
      // a pose that is not finite is ignored
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

  /// Shows a model at another pose; null: at its own.
  hold(model: number, X_WorldModel: Placement | null): void {
    const before = this.held?.model ?? 0;
    this.held = X_WorldModel === null ? null : { model, X_WorldModel };
    for (const id of this.places.keys()) {
      if (isWithin(this.places, id, model) || isWithin(this.places, id, before)) this.moved.add(id);
    }
  }

  /// Assumes that the held model is where it is shown, until a frame arrives.
  settle(): void {
    const { held } = this;
    if (held === null) return;
    for (const place of this.places.values()) {
      const shown = isWithin(this.places, place.id, held.model) && place.id !== held.model ? this.shown(place.id) : null;
      if (shown && !isRider(place)) place.X_WorldPlace = shown;
    }
    const model = this.places.get(held.model);
    if (model) model.X_WorldPlace = held.X_WorldModel;
    this.hold(held.model, null);
  }

  /// The pose at which something is shown.
  shown(id: number): Placement | null {
    const place = this.places.get(id);
    if (place === undefined) return null;
    if (isRider(place)) {
      const link = this.shown(place.parent);
      return link && times(link, place.X_ParentPlace);
    }
    const { held } = this;
    if (held === null || !isWithin(this.places, id, held.model)) return place.X_WorldPlace;
    const model = this.places.get(held.model)!;
    return times(held.X_WorldModel, times(inverse(model.X_WorldPlace), place.X_WorldPlace));
  }

  /// @param into Overwritten and returned.
  matrix(id: number, into = new Matrix4()): Matrix4 | null {
    const shown = this.shown(id);
    return shown && into.compose(shown.position, shown.rotation, unscaled);
  }

  position(id: number): Vector3 | null {
    return this.shown(id)?.position ?? null;
  }

  /// @returns The ids of what has moved since the last call.
  takeMoved(): number[] {
    // the parts of a held model move with it
    if (this.held && this.moved.size > 0) {
      const { model } = this.held;
      if (this.moved.has(model)) this.hold(model, this.held.X_WorldModel);
    }
    const ids = [...this.moved];
    this.moved.clear();
    return ids.flatMap((id) => [id, ...(this.riders.get(id) ?? [])]);
  }
}

function isRider(place: Place): boolean {
  return place.parent !== 0 && (place.kind === 'light' || place.kind === 'sensor');
}
