/// The entities of a world: those of its state as a tree, and its scene, completed from the state.
import { Components } from './components.ts';
import { poseMessage, type Sixfold } from './poses.ts';
import type { Message, MessageTypes } from './types.ts';

export type Kind = 'world' | 'model' | 'link' | 'joint' | 'visual' | 'collision' | 'sensor' | 'light' | 'actor';

export interface Entity {
  id: number;
  name: string;
  kind: Kind;
  parent: Entity | null;
  children: Entity[];
  components: Components;
}

const kKinds: [string, Kind][] = [
  ['World', 'world'], ['Model', 'model'], ['Link', 'link'], ['Joint', 'joint'], ['Visual', 'visual'],
  ['Collision', 'collision'], ['Sensor', 'sensor'], ['Light', 'light'], ['Actor', 'actor'],
];
/// The component of each sensor type, and its name in SDF.
export const kSensorTypes: [string, string][] = [
  ['Imu', 'imu'], ['Magnetometer', 'magnetometer'], ['Altimeter', 'altimeter'], ['AirPressureSensor', 'air_pressure'],
  ['GpuLidar', 'gpu_lidar'], ['Lidar', 'lidar'], ['Camera', 'camera'], ['DepthCamera', 'depth_camera'],
  ['RgbdCamera', 'rgbd_camera'], ['ThermalCamera', 'thermal_camera'],
];
/// ignition.msgs.Geometry.Type
const kMesh = 6;
/// ignition.msgs.Joint.Type by sdf::JointType, which begins at 1. There is no continuous type; 7 is fixed.
const kJointTypes = [0, 4, 0, 7, 6, 2, 0, 1, 5, 3];
export const kJointNames = [
  '', 'ball', 'continuous', 'fixed', 'gearbox', 'prismatic', 'revolute', 'revolute2', 'screw', 'universal',
];

export class Entities {
  readonly byId = new Map<number, Entity>();
  readonly world: Entity | null;

  /// @param step An ignition.msgs.SerializedStepMap with all entities; null: a world without entities.
  constructor(step: Message | null) {
    const all = (step?.state?.entities ?? {}) as Record<string, Message>;
    for (const [key, entity] of Object.entries(all)) {
      const components = new Components(entity);
      const kind = kKinds.find(([name]) => components.has(name))?.[1];
      if (!kind) continue;
      const id = Number(key);
      this.byId.set(id, { id, name: components.text('Name') ?? '', kind, parent: null, children: [], components });
    }
    let world: Entity | null = null;
    for (const entity of [...this.byId.values()].sort((a, b) => a.id - b.id)) {
      const parent = this.byId.get(Number(entity.components.text('ParentEntity')));
      if (entity.kind === 'world') world = entity;
      if (!parent || parent === entity) continue;
      entity.parent = parent;
      parent.children.push(entity);
    }
    this.world = world;
  }

  get(id: number | null): Entity | undefined {
    return id === null ? undefined : this.byId.get(id);
  }

  all(kind: Kind): Entity[] {
    return [...this.byId.values()].filter((entity) => entity.kind === kind).sort((a, b) => a.id - b.id);
  }

  /// The top-level model that contains an entity; the entity itself if it is an actor or a light of the world.
  topOf(entity: Entity): Entity {
    let top = entity;
    while (top.parent && top.parent.kind !== 'world') top = top.parent;
    return top;
  }

  /// The scoped name of an entity, such as "robot::arm::hand".
  scopedName(entity: Entity): string {
    const parent = entity.parent;
    return parent && parent.kind !== 'world' ? `${this.scopedName(parent)}::${entity.name}` : entity.name;
  }

  /// The link of a model by its scoped name in SDF.
  linkOf(model: Entity, scoped: string): Entity | undefined {
    const [first, ...rest] = scoped.split('::');
    const found = model.children.find(({ name, kind }) => name === first && (rest.length > 0 ? kind === 'model' : kind === 'link'));
    return found && rest.length > 0 ? this.linkOf(found, rest.join('::')) : found;
  }
}

/// Completes an ignition.msgs.Scene with values that only the state contains: ambient light, background, sky, shadows,
/// grid, joints, collisions, inertia, transparency, types of sensors, and actors as models without links.
export function completeScene(scene: Message, entities: Entities, types: MessageTypes): Message {
  const world = entities.world;
  const surroundings = world?.components.message('Scene', 'ignition.msgs.Scene', types);
  if (surroundings) {
    for (const field of ['ambient', 'background', 'sky', 'shadows', 'grid', 'originVisual']) scene[field] = surroundings[field];
  }
  for (const model of scene.model as Message[]) completeModel(model, entities, types);
  scene.model.push(...entities.all('actor').map((actor) => actorMessage(actor, types)));
  return scene;
}

/// An actor as an ignition.msgs.Model: its skin, at the pose in the file, and the visuals of its links.
function actorMessage(actor: Entity, types: MessageTypes): Message {
  const { id, name, components } = actor;
  const message = components.message('Actor', 'ignition.msgs.Actor', types);
  const visual: Message[] = [];
  if (message?.skinFilename) {
    const [x, y, z] = Array<number>(3).fill(message.skinScale as number);
    const mesh = { filename: message.skinFilename as string, scale: { x, y, z } };
    visual.push({ name: 'skin', castShadows: true, geometry: { type: kMesh, mesh } });
  }
  for (const { id: part, kind, name: partName, components: of } of actor.children) {
    if (kind !== 'visual') continue;
    visual.push({
      id: part,
      name: partName,
      pose: poseOf(of),
      castShadows: of.text('CastShadows') === '1',
      transparency: of.numbers('Transparency')?.[0] ?? 0,
      geometry: of.message('Geometry', 'ignition.msgs.Geometry', types),
      material: of.message('Material', 'ignition.msgs.Material', types),
    });
  }
  return { id, name, pose: poseOf(components), visual, link: [], model: [] };
}

function completeModel(model: Message, entities: Entities, types: MessageTypes): void {
  for (const inner of model.model as Message[]) completeModel(inner, entities, types);
  const entity = entities.get(model.id as number);
  if (!entity) return;
  model.isStatic = entity.components.text('Static') === '1';
  model.joint = entity.children.filter(({ kind }) => kind === 'joint').map((joint) => jointMessage(joint, entity, entities, types));
  for (const link of model.link as Message[]) completeLink(link, entities, types);
}

function completeLink(link: Message, entities: Entities, types: MessageTypes): void {
  const entity = entities.get(link.id as number);
  if (!entity) return;
  link.inertial = entity.components.message('Inertial', 'ignition.msgs.Inertial', types);
  link.collision = entity.children
    .filter(({ kind }) => kind === 'collision')
    .map(({ id, name, components }) => ({
      id, name, pose: poseOf(components), geometry: components.message('Geometry', 'ignition.msgs.Geometry', types),
    }));
  for (const visual of link.visual as Message[]) {
    const found = entities.get(visual.id as number);
    if (found) visual.transparency = found.components.numbers('Transparency')?.[0] ?? 0;
  }
  for (const sensor of link.sensor as Message[]) {
    const found = entities.get(sensor.id as number);
    if (found) sensor.type = sensorType(found) ?? '';
  }
}

export function sensorType(sensor: Entity): string | undefined {
  return kSensorTypes.find(([component]) => sensor.components.has(component))?.[1];
}

/// The settings of a sensor as an ignition.msgs.Sensor; undefined if the state does not contain them.
export function sensorSettings(sensor: Entity, types: MessageTypes): Message | undefined {
  const component = kSensorTypes.find(([name]) => sensor.components.has(name))?.[0];
  return component ? sensor.components.message(component, 'ignition.msgs.Sensor', types) : undefined;
}

function jointMessage(joint: Entity, model: Entity, entities: Entities, types: MessageTypes): Message {
  const { components } = joint;
  const [parent, child] = [components.text('ParentLinkName') ?? '', components.text('ChildLinkName') ?? ''];
  return {
    id: joint.id,
    name: joint.name,
    type: kJointTypes[Number(components.text('JointType'))] ?? 0,
    parent,
    parentId: entities.linkOf(model, parent)?.id ?? 0,
    child,
    childId: entities.linkOf(model, child)?.id ?? 0,
    pose: poseOf(components),
    axis1: components.message('JointAxis', 'ignition.msgs.Axis', types),
    axis2: components.message('JointAxis2', 'ignition.msgs.Axis', types),
  };
}

function poseOf(components: Components): Message {
  const numbers = components.numbers('Pose');
  return poseMessage(numbers?.length === 6 ? (numbers as Sixfold) : [0, 0, 0, 0, 0, 0]);
}
