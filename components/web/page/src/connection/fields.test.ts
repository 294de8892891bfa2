import assert from 'node:assert/strict';
import test from 'node:test';
import { exampleTypes } from './example_types.ts';
import { numberReader, numbersIn } from './fields.ts';

const types = exampleTypes();
const type = types.get('test.Point');
const message = types.decode('test.Point', types.encode('test.Point', {
  x: 1, where: { x: 2, list: [3, 4] }, on: true, kind: 1, big: 5n, name: 'n', points: [{ x: 6 }],
}));

test('every number has a path', () => {
  const paths = new Map(numbersIn(type, message).map(({ path, value }) => [path, value]));
  for (const [path, value] of Object.entries({
    x: 1, 'where.x': 2, 'where.list[0]': 3, 'where.list[1]': 4, on: 1, kind: 1, big: 5, 'points[0].x': 6,
  })) {
    assert.equal(paths.get(path), value, path);
    assert.equal(numberReader(type, path)(message), value, path);
  }
  assert.equal(paths.has('name'), false);
});

test('long lists are cut', () => {
  const list = Array.from({ length: 50 }, (_, i) => i);
  const long = types.decode('test.Point', types.encode('test.Point', { list }));
  assert.equal(numbersIn(type, long, 7).filter(({ path }) => path.startsWith('list')).length, 7);
});

test('what is not there is not a number, and what is no path is refused', () => {
  assert.ok(Number.isNaN(numberReader(type, 'where.list[9]')(message)));
  assert.ok(Number.isNaN(numberReader(type, 'where.where.x')(message)));
  for (const path of ['y', 'list', 'x[0]', 'where', 'where.', '', 'list[a]']) {
    assert.throws(() => numberReader(type, path), /test\.Point/, path);
  }
});
