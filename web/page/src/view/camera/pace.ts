// shares of the picture's width and height that are drawn
const scales = [1, 0.75, 0.5];
// a browser that takes longer than that for a picture draws coarser ones [ms]
const slowest = 60;
// and finer ones again where it takes less [ms]
const quickest = 20;
// so many pictures in a row tell
const enough = 8;
// pictures that far apart are not in a row [ms]
const pause = 1000;

/// How fine pictures are drawn while things move: coarser where the browser can't keep up.
export class Pace {
  private level = 0;
  private last = -Infinity;
  private took: number[] = [];

  /// A picture is to be drawn.
  /// @param now [ms]
  /// @returns The share of the full width and height that it is to have.
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
