/// The resolution of pictures from the server while the viewpoint moves, as a fraction of the full width and height: less
/// where they take long.

// [ms]
const slow = 350;
const quick = 180;
const smallest = 0.3;

export class StreamScale {
  private moving = 1;

  /// @param isMoving Whether the viewpoint moves; a picture that stays has the full resolution.
  now(isMoving: boolean): number {
    return isMoving ? this.moving : 1;
  }

  /// A picture that was asked for during a motion has arrived.
  /// @param took [ms]
  arrived(took: number): void {
    if (took > slow) this.moving = Math.max(this.moving * 0.7, smallest);
    else if (took < quick) this.moving = Math.min(this.moving * 1.2, 1);
  }
}

/// The size of a picture for an element, with at most this many pixels and no edge longer than the server's limit.
export function pictureSize(width: number, height: number, scale: number): [width: number, height: number] {
  const most = 500_000;
  const longest = 1280;
  const shortest = 16;
  const fit = Math.min(1, Math.sqrt(most / (width * height)), longest / Math.max(width, height)) * scale;
  const edge = (length: number): number => Math.max(Math.round(length * fit), shortest);
  return [edge(width), edge(height)];
}
