import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { completeScene, Entities, sensorType } from './entities.ts';
import { componentNumber } from './components.ts';
import { poseMessage } from './poses.ts';
import { MessageTypes, type Message } from './types.ts';

const text = (value: string | number): Uint8Array => new TextEncoder().encode(String(value));

/// The descriptors of the ignition-msgs types that the tests use, written by the build.
function types(): MessageTypes {
  const all = new MessageTypes();
  all.add(new Uint8Array(readFileSync('../../share/pongsim/message_types')));
  return all;
}

/// A world state: entities by id, each with components by name.
function state(entities: Record<number, Record<string, Uint8Array>>): Message {
  const made: Message = {};
  for (const [id, components] of Object.entries(entities)) {
    const entries = Object.entries(components).map(([name, component]) => [componentNumber(name), { component }]);
    made[id] = { id: BigInt(id), components: Object.fromEntries(entries) };
  }
  return { state: { entities: made } };
}

const none = new Uint8Array();
function place(kind: string, name: string, parent: number): Record<string, Uint8Array> {
  return { [kind]: none, Name: text(name), ParentEntity: text(parent) };
}

const robot = state({
  1: { World: none, Name: text('w') },
  2: place('Model', 'robot', 1),
  3: place('Link', 'base', 2),
  4: place('Model', 'arm', 2),
  5: place('Link', 'hand', 4),
  6: { ...place('Joint', 'wrist', 2), JointType: text(6), ParentLinkName: text('base'), ChildLinkName: text('arm::hand') },
  7: { ...place('Collision', 'c', 3), Pose: text('0 0 1 0 0 0') },
  8: { ...place('Sensor', 'eye', 3), Camera: none },
  9: { Light: none, Name: text('sun'), ParentEntity: text(1) },
  11: { ...place('Visual', 'v', 3), Transparency: text(0.25) },
  10: { Name: text('battery'), ParentEntity: text(2) },
});

test('entities are a tree with names', () => {
  const entities = new Entities(robot);
  assert.deepEqual(entities.world?.children.map(({ name }) => name), ['robot', 'sun']);
  const hand = entities.get(5)!;
  assert.equal(entities.scopedName(hand), 'robot::arm::hand');
  assert.equal(entities.topOf(hand).name, 'robot');
  assert.equal(entities.topOf(entities.get(9)!).name, 'sun');
  assert.deepEqual(entities.all('link').map(({ id }) => id), [3, 5]);
  assert.equal(entities.linkOf(entities.get(2)!, 'arm::hand')?.id, 5);
  assert.equal(entities.linkOf(entities.get(2)!, 'arm::foot'), undefined);
  assert.equal(sensorType(entities.get(8)!), 'camera');
});

test('without a state there is nothing', () => {
  assert.equal(new Entities(null).world, null);
  assert.equal(new Entities(null).get(null), undefined);
});

test('the scene gets what the state alone tells', () => {
  const scene: Message = {
    model: [{ id: 2, link: [{ id: 3, sensor: [{ id: 8 }], visual: [{ id: 11 }] }], model: [{ id: 4, link: [], model: [] }] }],
  };
  completeScene(scene, new Entities(robot), types());
  const [model] = scene.model;
  assert.equal(model.joint[0].type, 0);
  assert.deepEqual([model.joint[0].parentId, model.joint[0].childId], [3, 5]);
  assert.deepEqual(model.link[0].collision[0].pose, poseMessage([0, 0, 1, 0, 0, 0]));
  assert.equal(model.link[0].sensor[0].type, 'camera');
  assert.equal(model.link[0].visual[0].transparency, 0.25);
  assert.equal(model.isStatic, false);
});

test('actors are models of the scene, with skin and visuals', () => {
  const known = types();
  const actor = (fields: Message): Uint8Array => known.encode('ignition.msgs.Actor', fields);
  const world = state({
    1: { World: none, Name: text('w') },
    2: { Actor: actor({ skinFilename: '/m/walk.dae', skinScale: 0.5 }), Name: text('walker'), ParentEntity: text(1), Pose: text('1 2 3 0 0 0') },
    3: { Actor: actor({}), Name: text('box'), ParentEntity: text(1) },
    4: { ...place('Visual', 'v', 3), Geometry: known.encode('ignition.msgs.Geometry', { type: 1 }), CastShadows: text(1), Pose: text('0 0 1 0 0 0') },
  });
  const scene = completeScene({ model: [] }, new Entities(world), known);
  const [walker, box] = scene.model as [Message, Message];
  assert.deepEqual([walker.id, walker.name, walker.pose], [2, 'walker', poseMessage([1, 2, 3, 0, 0, 0])]);
  assert.deepEqual(walker.visual[0].geometry, { type: 6, mesh: { filename: '/m/walk.dae', scale: { x: 0.5, y: 0.5, z: 0.5 } } });
  assert.deepEqual(box.visual.map(({ id, name, castShadows, pose }: Message) => [id, name, castShadows, pose]),
    [[4, 'v', true, poseMessage([0, 0, 1, 0, 0, 0])]]);
  assert.equal(box.visual[0].geometry.type, 1);
});
