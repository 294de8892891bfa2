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

test('elements of a list have their names, where these are different', () => {
  const named = types.decode('test.Point', types.encode('test.Point', {
    points: [{ name: 'a::left', x: 1 }, { name: 'b', x: 2 }, { name: 'b', x: 3 }, { name: '7', x: 4 }, { name: 'c.d', x: 5 }],
  }));
  const paths = numbersIn(type, named).map(({ path }) => path).filter((path) => /^points.*x$/.test(path));
  assert.deepEqual(paths, ['points[a::left].x', 'points[b].x', 'points[2].x', 'points[3].x', 'points[4].x']);
  assert.deepEqual(paths.map((path) => numberReader(type, path)(named)), [1, 2, 3, 4, 5]);
  assert.ok(Number.isNaN(numberReader(type, 'points[z].x')(named)));
});

test('vectors have a length, and quaternions angles', () => {
  const turned = types.get('test.Pose');
  const quarter = Math.SQRT1_2;
  const pose = types.decode('test.Pose', types.encode('test.Pose', {
    position: { x: 3, y: 4, z: 12 }, orientation: { x: 0, y: 0, z: quarter, w: quarter },
  }));
  assert.equal(numberReader(turned, 'position.length')(pose), 13);
  assert.ok(Math.abs(numberReader(turned, 'orientation.yaw')(pose) - Math.PI / 2) < 1e-12);
  const paths = numbersIn(turned, pose).map(({ path }) => path);
  assert.ok(['position.length', 'orientation.roll', 'orientation.pitch', 'orientation.yaw'].every((path) => paths.includes(path)));
  assert.throws(() => numberReader(turned, 'position.length.x'), /test\.Pose/);
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
