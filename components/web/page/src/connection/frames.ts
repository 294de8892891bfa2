/// Frames of the channel /world/NAME/frame: the world poses of entities that have moved since this client's previous
/// frame.

export interface Frame {
  /// Simulated time.
  timeNs: bigint;
  iterations: bigint;
  realTimeFactor: number;
  isPaused: boolean;
  /// Whether it contains all entities.
  hasAll: boolean;
  /// Changes when models or links are added or removed.
  revision: number;
  ids: Uint32Array;
  /// 7 numbers each: position [m], quaternion x, y, z, w.
  poses: Float32Array;
}

/// The bytes "PWF1"; web/frames/frame.hh defines the format.
const kMagic = 0x31465750;
const kHeadBytes = 48;
const kEntryBytes = 32;

/// @throws Error if the bytes are not a complete frame.
export function readFrame(bytes: Uint8Array): Frame {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < kHeadBytes || view.getUint32(0, true) !== kMagic) throw new Error('this is not a frame of poses');
  const count = view.getUint32(44, true);
  if (bytes.length < kHeadBytes + count * kEntryBytes) throw new Error('a frame of poses is truncated');
  const ids = new Uint32Array(count);
  const poses = new Float32Array(7 * count);
  for (let i = 0; i < count; i++) {
    const at = kHeadBytes + i * kEntryBytes;
    ids[i] = view.getUint32(at, true);
    for (let j = 0; j < 7; j++) poses[7 * i + j] = view.getFloat32(at + 4 + 4 * j, true);
  }
  return {
    timeNs: view.getBigUint64(8, true),
    iterations: view.getBigUint64(16, true),
    realTimeFactor: view.getFloat64(24, true),
    isPaused: view.getUint32(32, true) !== 0,
    hasAll: (view.getUint32(4, true) & 1) !== 0,
    revision: view.getUint32(40, true),
    ids,
    poses,
  };
}

/// Merges all frames that arrive between two animation frames. None may be dropped, because each contains only changes.
export class FrameGatherer {
  /// The latest pose of each entity.
  readonly poses = new Map<number, Float32Array>();
  private readonly moved = new Set<number>();
  private last: Frame | null = null;

  add(frame: Frame): void {
    if (frame.hasAll) {
      this.poses.clear();
      this.moved.clear();
    }
    frame.ids.forEach((id, i) => {
      const pose = frame.poses.subarray(7 * i, 7 * i + 7);
      const kept = this.poses.get(id);
      if (kept) kept.set(pose);
      else this.poses.set(id, pose.slice());
      this.moved.add(id);
    });
    this.last = frame;
  }

  /// @return All entities that have moved since the last call, as one frame; null if none has.
  take(): Frame | null {
    if (!this.last) return null;
    const frame = this.frameOf([...this.moved], this.last);
    this.moved.clear();
    this.last = null;
    return frame;
  }

  /// @return The poses of all entities, as a frame with this revision.
  all(revision: number): Frame {
    const nothing = { timeNs: 0n, iterations: 0n, realTimeFactor: 0, isPaused: true, hasAll: true, revision };
    return this.frameOf([...this.poses.keys()], { ...nothing, ids: new Uint32Array(), poses: new Float32Array() });
  }

  private frameOf(ids: number[], head: Frame): Frame {
    const poses = new Float32Array(7 * ids.length);
    ids.forEach((id, i) => poses.set(this.poses.get(id)!, 7 * i));
    return { ...head, ids: Uint32Array.from(ids), poses };
  }
}
