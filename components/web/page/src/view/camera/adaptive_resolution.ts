// resolutions, as fractions of the full width and height
const scales = [1, 0.75, 0.5];
// above this time per frame the resolution is reduced [ms]
const slowest = 60;
// below this time it is increased again [ms]
const quickest = 20;
// number of consecutive frames that have to be slow or fast
const enough = 8;
// frames this far apart are not consecutive [ms]
const pause = 1000;

/// Chooses the resolution while things move: reduced if the browser can't keep up.
export class AdaptiveResolution {
  private level = 0;
  private last = -Infinity;
  private took: number[] = [];

  /// To be called for each frame.
  /// @param now [ms]
  /// @returns The fraction of the full width and height to render.
  next(now: number): number {
    const interval = now - this.last;
    this.last = now;
    if (interval > pause) this.took = [];
    else this.took.push(interval);
    if (this.took.length >= enough) {
      const mean = this.took.reduce((sum, each) => sum + each, 0) / this.took.length;
      if (mean > slowest) this.level = Math.min(this.level + 1, scales.length - 1);
      else if (mean < quickest) this.level = Math.max(this.level - 1, 0);
      this.took = [];
    }
    return scales[this.level]!;
  }
}
