/// Changes of the world that can be undone. All panels and tools make them here.
import type { Entity } from '../connection/entities.ts';
import { poseMessage, type Sixfold } from '../connection/poses.ts';
import { modelSdf } from '../connection/sdf_writer.ts';
import type { Message } from '../connection/types.ts';
import type { World } from '../connection/world.ts';
import { Asked } from './asked.ts';
import type { Context } from './context.ts';
import { isSure } from './dialog.ts';

/// How the entities were inserted that this page has inserted, by id: the fields of an ignition.msgs.EntityFactory.
const sources = new WeakMap<World, Map<number, Message>>();

/// What was asked for, of each world.
const wishes = new WeakMap<World, Asked>();

function askedOf(world: World): Asked {
  let asked = wishes.get(world);
  if (!asked) wishes.set(world, (asked = new Asked()));
  return asked;
}

function sourcesOf(world: World): Map<number, Message> {
  let known = sources.get(world);
  if (!known) sources.set(world, (known = new Map()));
  return known;
}

/// The pose of an entity now.
function poseOf(world: World, entity: Entity): Message {
  const live = world.poses.get(entity.id);
  if (live) {
    const [x, y, z, qx, qy, qz, qw] = live;
    return { position: { x, y, z }, orientation: { x: qx, y: qy, z: qz, w: qw } };
  }
  const numbers = entity.components.numbers('Pose');
  return poseMessage(numbers?.length === 6 ? (numbers as Sixfold) : [0, 0, 0, 0, 0, 0]);
}

function lightOf({ world, connection }: Context, entity: Entity): Message {
  const light = entity.components.message('Light', 'ignition.msgs.Light', connection.types) ?? {};
  const pose = entity.components.has('Pose') ? poseOf(world, entity) : (light.pose as Message | undefined);
  return { ...light, id: entity.id, name: entity.name, ...(pose && { pose }) };
}

/// The light as it was asked for, or as the world tells it.
export function lightNow(context: Context, light: Entity): Message {
  const { world } = context;
  return askedOf(world).now(keyOf('light', light), lightOf(context, world.entities.get(light.id) ?? light));
}

const keyOf = (what: string, { id }: Entity): string => `${what} ${id}`;

// after which a pose that was asked for is taken to be told [ms]
const kToldMs = 300;

/// Resolves when the world has told the pose of an entity, at the latest after a while: it tells only what moves.
function poseTold(world: World, id: number): Promise<void> {
  return new Promise((resolve) => {
    const finish = (): void => {
      end();
      clearTimeout(timer);
      resolve();
    };
    const timer = setTimeout(finish, kToldMs);
    const end = world.framed.on(({ ids }) => ids.includes(id) && finish());
  });
}

/// Moves a model or light of the world.
/// @param how The new pose, from the present one: ignition.msgs.Pose.
export function move(context: Context, entity: Entity, how: (now: Message) => Message): Promise<void> {
  const { world, history } = context;
  if (entity.kind === 'light') return changeLight(context, entity, (light) => ({ ...light, pose: how(light.pose as Message) }), 'Move');
  const to = async (there: Message): Promise<void> => void (await world.ask('set_pose', { id: history.current(entity.id), ...there }));
  return askedOf(world).change(keyOf('pose', entity), poseOf(world, entity), how,
    (before, after) => history.perform({ what: `Move ${entity.name}`, redo: () => to(after), undo: () => to(before) }),
    () => poseTold(world, history.current(entity.id)));
}

/// Changes something by a service of the world that takes what it was, too.
/// @param entity Null: the world itself.
/// @param told What the world tells of it.
/// @param fields Of the request, for a value.
function change<T>(
  { world, history }: Context, what: string, service: string, entity: Entity | null, told: T, how: (now: T) => T, fields: (value: T) => Message,
): Promise<void> {
  const to = async (value: T): Promise<void> => {
    await world.ask(service, entity ? { ...fields(value), id: history.current(entity.id) } : fields(value));
    await world.read();
  };
  return askedOf(world).change(`${service} ${entity?.id}`, told, how,
    (before, after) => history.perform({ what, redo: () => to(after), undo: () => to(before) }));
}

/// Changes a light.
/// @param how The new light, from the present one: ignition.msgs.Light.
export function changeLight(context: Context, light: Entity, how: (now: Message) => Message, verb = 'Change'): Promise<void> {
  const { world, history } = context;
  const to = async (fields: Message): Promise<void> => {
    await world.ask('light_config', { ...fields, id: history.current(light.id) });
    await world.read();
  };
  return askedOf(world).change(keyOf('light', light), lightNow(context, light), how,
    (before, after) => history.perform({ what: `${verb} ${light.name}`, redo: () => to(after), undo: () => to(before) }));
}

/// Changes the gravity of the world [m/s²].
export function setGravity(context: Context, told: readonly number[], how: (now: readonly number[]) => readonly number[]): Promise<void> {
  return change(context, 'Change gravity', 'set_physics', null, told, how, ([x, y, z]) => ({ gravity: { x, y, z } }));
}

/// Changes the mass of a link [kg].
export function setMass(context: Context, link: Entity, told: number, mass: number): Promise<void> {
  return change(context, `Change the mass of ${link.name}`, 'set_mass', link, told, () => mass, (value) => ({ inertial: { mass: value } }));
}

/// Red, green, blue, 0 to 1.
export type Rgb = [number, number, number];

/// Changes the colour of a visual.
export function setColor(context: Context, visual: Entity, told: Rgb, color: Rgb): Promise<void> {
  return change(context, `Colour ${visual.name}`, 'visual_config', visual, told, () => color, ([r, g, b]) => ({ material: { diffuse: { r, g, b, a: 1 } } }));
}

/// Moves the axes of a joint [rad or m].
export function setJointPositions(
  context: Context, joint: Entity, told: readonly number[], how: (now: readonly number[]) => readonly number[],
): Promise<void> {
  const fields = ([first, second]: readonly number[]): Message =>
    ({ axis1: { position: first }, ...(second !== undefined && { axis2: { position: second } }) });
  return change(context, `Move ${joint.name}`, 'set_joint_position', joint, told, how, fields);
}

/// Inserts a model or light.
/// @param factory The fields of an ignition.msgs.EntityFactory.
/// @param name The name that it is to have; it gets another one if this is taken.
export function insert(context: Context, what: string, factory: Message, name: string): Promise<void> {
  let id: number | null = null;
  return context.history.perform({
    what,
    redo: async () => {
      const made = await create(context, factory, name);
      if (id !== null && made) context.history.replace(id, made);
      id ??= made;
    },
    undo: async () => {
      if (id === null) throw new Error(`${name} is no longer known`);
      await context.world.remove(context.history.current(id));
      await context.world.read();
    },
  });
}

/// Creates an entity.
/// @return Its id; null if the world does not tell it.
async function create({ world }: Context, factory: Message, name: string): Promise<number | null> {
  await world.read();
  const before = new Set(world.entities.byId.keys());
  await world.ask('create', { ...factory, allowRenaming: true });
  await world.read();
  const added = (world.entities.world?.children ?? []).filter(({ id }) => !before.has(id));
  const made = added.find((entity) => entity.name === name) ?? added.find((entity) => entity.name.startsWith(name));
  if (made) sourcesOf(world).set(made.id, factory);
  return made?.id ?? null;
}

/// Removes a model or light, after a question if it can't be brought back as it is.
/// @return Whether it was removed.
/// @throws Error with the reason if the world refuses it.
export async function remove(context: Context, entity: Entity): Promise<boolean> {
  const { world, history } = context;
  const source = usableSource(world, entity);
  if (entity.kind === 'model' && !source) {
    const text = 'Undo brings it back as the page sees it: with its links, joints and looks, but without its plugins, sensors and friction.';
    if (!(await isSure(`Remove ${entity.name}?`, text, 'Remove'))) return false;
  }
  const pose = poseOf(world, entity);
  const factory = source ? { ...source, pose, name: entity.name } : { ...sourceOf(context, entity, pose), name: entity.name };
  await history.perform({
    what: `Remove ${entity.name}`,
    redo: async () => {
      await world.remove(history.current(entity.id));
      await world.read();
    },
    undo: async () => {
      const made = await create(context, factory, entity.name);
      if (made) history.replace(history.current(entity.id), made);
    },
  });
  return true;
}

/// How the page has inserted an entity, if that can be done again: the original of a copy must still be there.
function usableSource(world: World, entity: Entity): Message | undefined {
  const source = sourcesOf(world).get(entity.id);
  const from = source?.from as { case: string; value: string } | undefined;
  const isThere = from?.case !== 'cloneName' || world.entities.all('model').some(({ name, id }) => name === from.value && id !== entity.id);
  return isThere ? source : undefined;
}

/// What creates an entity of the world's file again, as far as scene and state describe it.
function sourceOf(context: Context, entity: Entity, pose: Message): Message {
  if (entity.kind === 'light') return { from: { case: 'light', value: lightOf(context, entity) } };
  const message = ((context.world.scene?.model ?? []) as Message[]).find(({ id }) => id === entity.id);
  if (!message) throw new Error(`the world does not describe ${entity.name}`);
  return { from: { case: 'sdf', value: modelSdf(message, pose) } };
}

/// The fields of an ignition.msgs.EntityFactory for an SDF or URDF text.
export function fromText(sdf: string, pose: Sixfold | null, name = ''): Message {
  return { from: { case: 'sdf', value: sdf }, name, ...(pose ? { pose: poseMessage(pose) } : {}) };
}
