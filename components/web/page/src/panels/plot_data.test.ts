import assert from 'node:assert/strict';
import test from 'node:test';
import { columnsOf, csvOf, Curve, kLongest, kMostValues } from './plot_data.ts';

const curve = (name: string, ...points: [number, number][]): Curve => {
  const made = new Curve(name);
  for (const [time, value] of points) made.add(time, value);
  return made;
};

test('curves stand side by side over all their times', () => {
  const curves = [curve('a', [0, 1], [2, 3]), curve('b,"c"', [1, 5], [2, 6])];
  assert.deepEqual(columnsOf(curves, 0, 2, 100), [[0, 1, 2], [1, null, 3], [null, 5, 6]]);
  assert.equal(csvOf(curves), 'time [s],a,"b,""c"""\n0,1,\n1,,5\n2,3,6\n');
});

test('lines lead over the borders of what is shown', () => {
  const points = Array.from({ length: 10 }, (_, i): [number, number] => [i, i]);
  assert.deepEqual(columnsOf([curve('a', ...points)], 3, 5, 100)[0], [2, 3, 4, 5]);
});

test('a reset begins anew, and of several values at a time the last counts', () => {
  assert.deepEqual([...curve('a', [5, 1], [6, 2], [0, 3]).values], [3]);
  assert.deepEqual([...curve('a', [5, 1], [5, 2]).values], [2]);
});

test('30 s at 1 kHz are kept whole, and drawn with all their peaks in two values per pixel', () => {
  const long = new Curve('a');
  for (let i = 0; i < 30_000; ++i) long.add(i / 1000, i === 12_345 ? 9 : i === 23_456 ? -7 : Math.sin(i / 500));
  assert.equal(long.times.length, 30_000);
  const columns = columnsOf([long, curve('b', [10, 1], [20, 2])], 0, 30, 400);
  assert.ok(columns[0].length <= 806, `${columns[0].length} rows`);
  assert.ok(columns[0].every((time, i) => i === 0 || time > columns[0][i - 1]!));
  const [times, values, few] = columns;
  assert.equal(Math.max(...values!.map((value) => value ?? 0)), 9);
  assert.equal(Math.min(...values!.map((value) => value ?? 0)), -7);
  // within a pixel of its time
  assert.ok(Math.abs(times[values!.indexOf(9)]! - 12.345) < 30 / 400);
  assert.deepEqual(few!.filter((value) => value !== null), [1, 2]);
});

test('what is kept is bounded in number, and peaks stay', () => {
  const long = new Curve('a');
  for (let i = 0; i < 3 * kMostValues; ++i) long.add(i / 1000, i === 777 ? 9 : i % 2);
  assert.ok(long.times.length <= kMostValues);
  assert.ok(long.isThinned);
  assert.ok(long.values.includes(9));
  // nothing is missing at the start
  assert.ok(long.times[0]! < 0.1);
  assert.ok(long.times.every((time, i) => i === 0 || time > long.times[i - 1]!));
});

test('what is kept is bounded in time', () => {
  const long = new Curve('a');
  for (let i = 0; i < 10_000; ++i) long.add(i, i);
  assert.equal(long.times[0], 9999 - kLongest);
  assert.equal(long.last, 9999);
});

test('NaN hides no number beside it', () => {
  const gaps = new Curve('a');
  for (let i = 0; i < 1000; ++i) gaps.add(i / 1000, i % 3 === 0 ? NaN : 5);
  const [, values] = columnsOf([gaps], 0, 1, 10);
  assert.ok(values!.includes(5));
});
