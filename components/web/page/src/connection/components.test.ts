import assert from 'node:assert/strict';
import test from 'node:test';
import { Components, componentNumber } from './components.ts';
import { exampleTypes } from './example_types.ts';

test('a component has the number that Fortress gives it', () => {
  // the expected value was computed by another program
  assert.equal(componentNumber('Pose'), '6612894081701502240');
  assert.equal(componentNumber('Pose'), componentNumber('Pose'));
});

test('components are read as text, numbers and messages', () => {
  const types = exampleTypes();
  const text = (value: string): object => ({ component: new TextEncoder().encode(value) });
  const components = new Components({
    components: {
      [componentNumber('Name')]: text('ball'),
      [componentNumber('Pose')]: text('1 2 -3.5 0 0 1e-3'),
      [componentNumber('Point')]: { component: types.encode('test.Point', { x: 4 }) },
    },
  });
  assert.equal(components.text('Name'), 'ball');
  assert.deepEqual(components.numbers('Pose'), [1, 2, -3.5, 0, 0, 0.001]);
  assert.equal(components.message('Point', 'test.Point', types)?.x, 4);
  assert.equal(components.has('Inertial'), false);
  assert.equal(components.text('Inertial'), undefined);
});
