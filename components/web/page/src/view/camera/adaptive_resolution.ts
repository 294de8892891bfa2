// resolutions, as fractions of the full width and height
const scales = [1, 0.75, 0.5, 0.35];
// above this time per frame the resolution is reduced [ms]
const slowest = 60;
// above this time it is reduced to the lowest at once [ms]
const muchTooSlow = 240;
// below this time it is increased again [ms]
const quickest = 20;
// number of frames that have to be slow or fast, and much too slow
const enough = 8;
const enoughForAll = 3;

/// Chooses the resolution while things move: reduced if the browser can't keep up.
export class AdaptiveResolution {
  private level = 0;
  private took: number[] = [];

  /// Whether the browser can't keep up in the full resolution.
  get isReduced(): boolean {
    return this.level > 0;
  }

  /// To be called for each frame.
  /// @param ms Time from the request for the frame until the browser lets it be drawn. If it can't keep up, it is still busy
  /// with the frame before. Unlike the time between frames, it is short where there is seldom something to draw.
  /// @returns The fraction of the full width and height to render.
  next(ms: number): number {
    this.took.push(ms);
    if (this.took.length >= enoughForAll && Math.min(...this.took.slice(-enoughForAll)) > muchTooSlow) {
      this.level = scales.length - 1;
      this.took = [];
    } else if (this.took.length >= enough) {
      const mean = this.took.reduce((sum, each) => sum + each, 0) / this.took.length;
      if (mean > slowest) this.level = Math.min(this.level + 1, scales.length - 1);
      else if (mean < quickest) this.level = Math.max(this.level - 1, 0);
      this.took = [];
    }
    return scales[this.level]!;
  }
}
