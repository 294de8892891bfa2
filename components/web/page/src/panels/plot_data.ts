/// Values over simulated time, in ascending order and limited in number.

export interface Curve {
  /// "/topic field.path"
  name: string;
  times: number[];
  values: number[];
}

/// Maximum number of values per curve; beyond it the oldest half is dropped.
export const kMostValues = 20_000;

/// Appends a value. If the time is before the last one, the world was reset: the curve starts anew.
export function addValue(curve: Curve, time: number, value: number): void {
  const last = curve.times.at(-1);
  if (last !== undefined && time < last) {
    curve.times.length = 0;
    curve.values.length = 0;
  }
  curve.times.push(time);
  curve.values.push(value);
  if (curve.times.length > kMostValues) {
    curve.times.splice(0, kMostValues / 2);
    curve.values.splice(0, kMostValues / 2);
  }
}

/// The values of all curves at a common list of times, from `since` on; null where a curve has no value.
export function joined(curves: readonly Curve[], since = -Infinity): [number[], ...(number | null)[][]] {
  const times = [...new Set(curves.flatMap((curve) => curve.times.filter((time) => time >= since)))].sort((a, b) => a - b);
  const columns = curves.map((curve) => {
    const at = new Map(curve.times.map((time, i) => [time, curve.values[i]!]));
    return times.map((time) => at.get(time) ?? null);
  });
  return [times, ...columns];
}

/// The curves as CSV, with a common column of times.
export function csvOf(curves: readonly Curve[]): string {
  const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const [times, ...columns] = joined(curves);
  const lines = times.map((time, i) => [time, ...columns.map((column) => column[i] ?? '')].join(','));
  return [['time [s]', ...curves.map(({ name }) => quoted(name))].join(','), ...lines].join('\n') + '\n';
}
