import assert from 'node:assert/strict';
import test from 'node:test';
import { addValue, csvOf, joined, kMostValues, type Curve } from './plot_data.ts';

const curve = (name: string, ...points: [number, number][]): Curve => {
  const made: Curve = { name, times: [], values: [] };
  for (const [time, value] of points) addValue(made, time, value);
  return made;
};

test('curves stand side by side over all their times', () => {
  const curves = [curve('a', [0, 1], [2, 3]), curve('b,"c"', [1, 5], [2, 6])];
  assert.deepEqual(joined(curves), [[0, 1, 2], [1, null, 3], [null, 5, 6]]);
  assert.deepEqual(joined(curves, 1)[0], [1, 2]);
  assert.equal(csvOf(curves), 'time [s],a,"b,""c"""\n0,1,\n1,,5\n2,3,6\n');
});

test('a reset begins anew', () => {
  assert.deepEqual(curve('a', [5, 1], [6, 2], [0, 3]).values, [3]);
});

test('what is kept is bounded', () => {
  const long = curve('a');
  for (let i = 0; i <= kMostValues; i++) addValue(long, i, i);
  assert.equal(long.times.length, kMostValues / 2 + 1);
  assert.equal(long.values.at(-1), kMostValues);
});
