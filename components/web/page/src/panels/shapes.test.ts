import assert from 'node:assert/strict';
import test from 'node:test';
import { kShapeNames, lightSdf, shapeMessage, shapeSdf } from './shapes.ts';

test('every shape is a model of 1 kg whose moments fit together', () => {
  for (const shape of kShapeNames) {
    const sdf = shapeSdf(shape);
    const moment = (name: string): number => Number(new RegExp(`<${name}>([^<]+)</`).exec(sdf)![1]);
    const [x, y, z] = [moment('ixx'), moment('iyy'), moment('izz')] as [number, number, number];
    assert.ok(x + y >= z && y + z >= x && x + z >= y, shape);
    assert.equal(sdf.split(`<${shape}>`).length, 3);
    assert.ok(shapeMessage(shape).link[0].visual[0].geometry[shape], shape);
  }
});

test('only a spot has a cone', () => {
  assert.match(lightSdf('spot'), /<spot>/);
  assert.doesNotMatch(lightSdf('point'), /<spot>/);
});
