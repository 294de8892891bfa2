import assert from 'node:assert/strict';
import test from 'node:test';
import { poseMessage } from './poses.ts';
import { modelSdf } from './sdf_writer.ts';

test('a model is written with its links, shapes and joints', () => {
  const box = { box: { size: { x: 1, y: 2, z: 3 } } };
  const inertial = { mass: 2, ixx: 1, ixy: 0, ixz: 0, iyy: 1, iyz: 0, izz: 1 };
  const model = {
    name: 'a<b', isStatic: false, model: [],
    link: [{
      name: 'l', pose: poseMessage([0, 0, 1, 0, 0, 0.5]), inertial,
      collision: [{ name: 'c', geometry: box }],
      visual: [{ name: 'v', geometry: { mesh: { filename: 'model://m/a.dae', scale: { x: 1, y: 1, z: 1 } } }, material: { diffuse: { r: 1, g: 0, b: 0, a: 1 } } }],
    }],
    joint: [{ name: 'j', type: 0, parent: 'world', child: 'l', axis1: { xyz: { z: 1 }, limitLower: -1, limitUpper: Infinity, limitEffort: 5, limitVelocity: Infinity, damping: 0.5, friction: 0 } }],
  };
  const sdf = modelSdf(model, poseMessage([1, 0, 0, 0, 0, 0]));
  for (const part of [
    '<model name="a&lt;b">\n    <pose>1 0 0 0 0 0</pose>', '<pose>0 0 1 0 0 0.5</pose>', '<mass>2</mass>', '<size>1 2 3</size>',
    '<uri>model://m/a.dae</uri>', '<diffuse>1 0 0 1</diffuse>', '<joint name="j" type="revolute">', '<xyz>0 0 1</xyz>',
    '<lower>-1</lower>', '<upper>inf</upper>', '<damping>0.5</damping>',
  ]) assert.ok(sdf.includes(part), `${part} in\n${sdf}`);
  assert.ok(!sdf.includes('<static>'));
  assert.equal(sdf.match(/<(?!\/|\?)/g)!.length, sdf.match(/<\//g)!.length);
});
