/// Values over simulated time, and the few of them that suffice to draw their curve.

/// Largest number of values that a curve keeps.
export const kMostValues = 131_072;
/// Older values than this before the latest one are dropped [s].
export const kLongest = 3600;

// values that are replaced by their minimum and maximum where there are too many
const kGroup = 4;

/// Columns of a chart: times, and the values of each curve at them; null where a curve has none.
export type Columns = [number[], ...(number | null)[][]];

/// The values of one curve, with ascending times. Beyond `kMostValues`, of each four of the older half the minimum and the
/// maximum are kept, so that peaks stay.
export class Curve {
  /// Whether minima and maxima have replaced values.
  isThinned = false;
  private allTimes = new Float64Array(1024);
  private allValues = new Float64Array(1024);
  private begin = 0;
  private end = 0;

  /// @param name "/topic field.path"
  constructor(readonly name: string) {}

  get times(): Float64Array {
    return this.allTimes.subarray(this.begin, this.end);
  }

  get values(): Float64Array {
    return this.allValues.subarray(this.begin, this.end);
  }

  /// The time of the latest value; undefined if there is none.
  get last(): number | undefined {
    return this.end > this.begin ? this.allTimes[this.end - 1] : undefined;
  }

  /// Appends a value; of several at one time, the last one stays. If the time is before the last one, the world was reset:
  /// the curve starts anew.
  add(time: number, value: number): void {
    const { last } = this;
    if (last !== undefined && time < last) this.clear();
    if (time === last) --this.end;
    else if (this.end === this.allTimes.length) this.makeRoom();
    this.allTimes[this.end] = time;
    this.allValues[this.end++] = value;
    while (this.allTimes[this.begin]! < time - kLongest) ++this.begin;
  }

  private clear(): void {
    this.begin = this.end = 0;
    this.isThinned = false;
  }

  private makeRoom(): void {
    const capacity = this.allTimes.length;
    if (this.begin > capacity / 4) this.moveTo(this.allTimes, this.allValues);
    else if (capacity < kMostValues) this.moveTo(new Float64Array(2 * capacity), new Float64Array(2 * capacity));
    else this.thin();
  }

  private moveTo(times: Float64Array<ArrayBuffer>, values: Float64Array<ArrayBuffer>): void {
    const count = this.end - this.begin;
    times.set(this.times);
    values.set(this.values);
    [this.allTimes, this.allValues, this.begin, this.end] = [times, values, 0, count];
  }

  private thin(): void {
    const { allTimes: times, allValues: values } = this;
    const half = this.begin + kGroup * Math.floor((this.end - this.begin) / (2 * kGroup));
    let kept = this.begin;
    for (let i = this.begin; i < half; i += kGroup) {
      for (const at of extremes(values, i, i + kGroup)) {
        times[kept] = times[at]!;
        values[kept++] = values[at]!;
      }
    }
    times.copyWithin(kept, half, this.end);
    values.copyWithin(kept, half, this.end);
    this.end -= half - kept;
    this.isThinned = true;
  }
}

/// The indices of the smallest and the largest value in a range, in ascending order; one index if they are the same.
function extremes(values: Float64Array, from: number, to: number): number[] {
  let [least, most] = [from, from];
  for (let i = from + 1; i < to; ++i) {
    // a number instead of NaN, too
    if (values[i]! < values[least]! || Number.isNaN(values[least])) least = i;
    if (values[i]! > values[most]! || Number.isNaN(values[most])) most = i;
  }
  return least === most ? [least] : least < most ? [least, most] : [most, least];
}

/// The first index whose time is not before `time`.
function indexOf(times: Float64Array, time: number): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < time) low = middle + 1;
    else high = middle;
  }
  return low;
}

/// What is to be drawn of curves between two times in a chart of this many pixels: all values, or where a curve has more
/// than two per pixel, the minimum and maximum of each pixel.
export function columnsOf(curves: readonly Curve[], from: number, to: number, pixels: number): Columns {
  // one value beyond each border, to which the line leads
  const ranges = curves.map(({ times }): [number, number] => [Math.max(indexOf(times, from) - 1, 0), indexOf(times, to) + 1]);
  const isFine = ranges.every(([begin, end]) => end - begin <= 2 * pixels + 2);
  return isFine ? joined(curves, ranges) : extremesOf(curves, ranges, from, to, pixels);
}

/// The values in these ranges of indices at a common list of times.
function joined(curves: readonly Curve[], ranges: readonly [number, number][]): Columns {
  const parts = curves.map((curve, i) => ({ times: curve.times.subarray(...ranges[i]!), values: curve.values.subarray(...ranges[i]!) }));
  const times = [...new Set(parts.flatMap((part) => [...part.times]))].sort((a, b) => a - b);
  return [times, ...parts.map((part) => {
    let next = 0;
    return times.map((time) => (part.times[next] === time ? part.values[next++]! : null));
  })];
}

function extremesOf(curves: readonly Curve[], ranges: readonly [number, number][], from: number, to: number, pixels: number): Columns {
  const width = (to - from) / pixels;
  // borders are multiples of the width, so that peaks do not flicker while the curve moves
  const first = Math.floor(from / width) - 1;
  const count = pixels + 3;
  const times = Array.from({ length: 2 * count }, (_, i) => (first + i / 2 + 0.25) * width);
  return [times, ...curves.map(({ times: of, values }, i) => {
    const column = new Array<number | null>(2 * count).fill(null);
    let [at, end] = ranges[i]!;
    end = Math.min(end, of.length);
    while (at < end) {
      const pixel = Math.floor(of[at]! / width);
      let next = at + 1;
      while (next < end && of[next]! < (pixel + 1) * width) ++next;
      const place = Math.min(Math.max(pixel - first, 0), count - 1);
      extremes(values, at, next).forEach((index, k) => (column[2 * place + k] = values[index]!));
      at = next;
    }
    return column;
  })];
}

/// The curves as CSV, with a common column of times.
export function csvOf(curves: readonly Curve[]): string {
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const [times, ...columns] = joined(curves, curves.map(({ times: all }) => [0, all.length]));
  const lines = times.map((time, i) => [time, ...columns.map((column) => column[i] ?? '')].join(','));
  return [['time [s]', ...curves.map(({ name }) => quoted(name))].join(','), ...lines].join('\n') + '\n';
}
