import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BufferGeometry } from 'three';

import { beamsOf, put } from './scan.ts';

function near(values: ArrayLike<number>, expected: number[]): void {
  assert.equal(values.length, expected.length);
  expected.forEach((value, i) => assert.ok(Math.abs(values[i]! - value) < 1e-6, `${Array.from(values)}`));
}

test('beams go from the smallest angle to the left, each from the shortest range', () => {
  const scan = { angleMin: 0, angleStep: Math.PI / 2, rangeMin: 0.5, rangeMax: 10, count: 2, ranges: [2, 3] };
  const { hits, hitLines } = beamsOf(scan);
  near(hits, [2, 0, 0, 0, 3, 0]);
  near(hitLines, [0.5, 0, 0, 2, 0, 0, 0, 0.5, 0, 0, 3, 0]);
});

test('rows go from the lowest up', () => {
  const { hits } = beamsOf({
    count: 1, verticalCount: 2, verticalAngleMin: -Math.PI / 4, verticalAngleStep: Math.PI / 2, rangeMax: 10,
    ranges: [Math.SQRT2, Math.SQRT2],
  });
  near(hits, [1, 0, -1, 1, 0, 1]);
});

test('what met nothing is shown as long as the sensor sees', () => {
  const { hits, missLines } = beamsOf({ count: 4, rangeMin: 0, rangeMax: 8, ranges: [Infinity, NaN, 2, 8] });
  near(hits, [2, 0, 0]);
  near(missLines, [0, 0, 0, 8, 0, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 8, 0, 0]);
});

test('a scan with fewer ranges than it says is no more than these', () => {
  assert.equal(beamsOf({ count: 100, verticalCount: 4, rangeMax: 9, ranges: [1, 2] }).hits.length, 6);
  assert.equal(beamsOf({}).missLines.length, 0);
});

test('a geometry is written over where there is room, and shows only what is new', () => {
  const geometry = new BufferGeometry();
  put(geometry, [1, 2, 3, 4, 5, 6]);
  const first = geometry.getAttribute('position');
  put(geometry, [7, 8, 9]);
  assert.equal(geometry.getAttribute('position'), first);
  assert.equal(geometry.drawRange.count, 1);
  assert.equal(first.getX(0), 7);
  put(geometry, Array.from({ length: 9 }, () => 1));
  assert.notEqual(geometry.getAttribute('position'), first);
});
