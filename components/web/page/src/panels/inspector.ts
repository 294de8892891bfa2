/// Shows the selected entity: its current pose, and its components; what can be changed has fields.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, setChildren, shortNumber } from '../app/dom.ts';
import { move } from '../app/edits.ts';
import { Components } from '../connection/components.ts';
import { kJointNames, sensorSettings, sensorType, type Entity } from '../connection/entities.ts';
import { poseMessage, rollPitchYawOf, sixfoldOf } from '../connection/poses.ts';
import type { Message, MessageTypes } from '../connection/types.ts';
import { PoseTable } from './pose_table.ts';
import { jointPositions, propertyFields, type PropertyFields } from './property_fields.ts';

type Rows = [name: string, value: string][];

const list = (numbers: readonly number[]): string => numbers.map(shortNumber).join('  ');
const vector = (v: Message | undefined): string => list([v?.x ?? 0, v?.y ?? 0, v?.z ?? 0]);

/// The names and values to show for an entity.
export function rowsOf(entity: Entity, types: MessageTypes): Rows {
  const { components, kind } = entity;
  const rows: Rows = [['Name', entity.name], ['Kind', kind], ['Entity', String(entity.id)]];
  if (entity.parent) rows.push(['Parent', `${entity.parent.name} (${entity.parent.id})`]);
  const text = (label: string, name: string, words?: (value: string) => string): void => {
    const value = components.text(name);
    if (value !== undefined && value !== '') rows.push([label, words ? words(value) : value]);
  };
  const yesNo = (value: string): string => (value === '1' ? 'yes' : 'no');
  text('Static', 'Static', yesNo);
  text('Self collide', 'SelfCollide', yesNo);
  text('Gravity [m/s²]', 'Gravity');
  text('Cast shadows', 'CastShadows', yesNo);
  text('Transparency', 'Transparency');
  text('Laser retro', 'LaserRetro');
  text('Charge', 'BatterySoC');
  const inertial = components.message('Inertial', 'ignition.msgs.Inertial', types);
  if (inertial) rows.push(...inertialRows(inertial));
  const geometry = components.message('Geometry', 'ignition.msgs.Geometry', types);
  if (geometry) rows.push(...geometryRows(geometry, types));
  if (kind === 'joint') rows.push(...jointRows(entity, types));
  if (kind === 'sensor') rows.push(...sensorRows(entity, types));
  const light = components.message('Light', 'ignition.msgs.Light', types);
  if (light) {
    rows.push(['Type', ['point', 'spot', 'directional'][light.type as number] ?? ''],
      ['Intensity', shortNumber(light.intensity as number)], ['Range [m]', shortNumber(light.range as number)]);
  }
  return rows;
}

function inertialRows(m: Message): Rows {
  return [
    ['Mass [kg]', shortNumber(m.mass as number)],
    ['Centre of mass [m]', vector(m.pose?.position as Message)],
    ['Moments xx yy zz [kg m²]', list([m.ixx, m.iyy, m.izz] as number[])],
    ['Products xy xz yz [kg m²]', list([m.ixy, m.ixz, m.iyz] as number[])],
  ];
}

function geometryRows(geometry: Message, types: MessageTypes): Rows {
  const json = types.json('ignition.msgs.Geometry', geometry) as Record<string, unknown>;
  const { type, ...shape } = json;
  const [[name, value] = ['', '']] = Object.entries(shape);
  return [['Geometry', `${name || String(type ?? '').toLowerCase()} ${value ? JSON.stringify(value).replaceAll('"', '') : ''}`]];
}

function jointRows({ components }: Entity, types: MessageTypes): Rows {
  const rows: Rows = [
    ['Type', kJointNames[Number(components.text('JointType'))] ?? ''],
    ['From', components.text('ParentLinkName') ?? ''],
    ['To', components.text('ChildLinkName') ?? ''],
  ];
  const axis = components.message('JointAxis', 'ignition.msgs.Axis', types);
  if (!axis) return rows;
  rows.push(['Axis', vector(axis.xyz as Message)], ['Limits', list([axis.limitLower, axis.limitUpper] as number[])]);
  rows.push(['Effort, velocity limits', list([axis.limitEffort, axis.limitVelocity] as number[])]);
  rows.push(['Damping, friction', list([axis.damping, axis.friction] as number[])]);
  return rows;
}

function sensorRows(sensor: Entity, types: MessageTypes): Rows {
  const settings = sensorSettings(sensor, types);
  const rows: Rows = [['Type', sensorType(sensor) ?? '']];
  if (settings) rows.push(['Rate [Hz]', shortNumber(settings.updateRate as number)], ['Topic', settings.topic as string]);
  return rows;
}

export function openInspector(context: Context): Panel {
  const { world, selection, connection } = context;
  const ends = new Ends();
  const pose = new PoseTable((enter) => {
    const entity = world.entities.get(selection.id);
    if (entity) void context.attempt('Move', move(context, entity, (now) => poseMessage(enter(sixfoldOf(now)))));
  });
  const poseRow = [h('dt', {}, 'Pose'), h('dd', {}, pose.element)];
  const table = h('dl', {});
  const nothing = h('p', { class: 'hint' }, 'Select something in the view or the tree; this is the world');
  const motion = h('dd', { id: 'inspector-joint' }, '–');
  const motionRow = [h('dt', {}, 'Position, velocity'), motion];
  let isJoint = false;
  let fields: PropertyFields & { id: number; rows: HTMLElement[] } | null = null;
  // kept while the entity is selected, because new ones would lose the focus
  const fieldsFor = (entity: Entity): PropertyFields & { id: number; rows: HTMLElement[] } => {
    if (fields?.id === entity.id) return fields;
    const made = connection.isReadOnly ? { all: [] } : propertyFields(context, entity);
    const rows = made.all.flatMap(({ name, element }) => [h('dt', {}, name), h('dd', {}, element)]);
    return (fields = { ...made, id: entity.id, rows });
  };
  const show = (): void => {
    const chosen = world.entities.get(selection.id);
    nothing.hidden = !!chosen;
    const entity = chosen ?? world.entities.world;
    if (!entity) {
      table.replaceChildren();
      fields = null;
      return;
    }
    isJoint = entity.kind === 'joint';
    const { all, rows: editable } = fieldsFor(entity);
    for (const field of all) field.show(entity);
    const names = new Set(all.map(({ name }) => name));
    const rows = rowsOf(entity, connection.types).filter(([name]) => !names.has(name))
      .flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]);
    setChildren(table, [...editable, ...rows, ...(isJoint ? motionRow : entity.kind === 'world' ? [] : poseRow)]);
    showPose();
  };
  const canMove = ({ kind, parent }: Entity): boolean =>
    !connection.isReadOnly && (kind === 'model' || kind === 'light') && parent?.kind === 'world';
  const showPose = (): void => {
    const entity = world.entities.get(selection.id);
    if (!entity || isJoint) return;
    const live = world.poses.get(entity.id);
    if (live) {
      const [x, y, z, qx, qy, qz, qw] = live as unknown as [number, number, number, number, number, number, number];
      pose.show([x, y, z, ...rollPitchYawOf([qx, qy, qz, qw])], 'in the world', !canMove(entity));
    } else {
      pose.show(entity.components.numbers('Pose') ?? [], `in ${entity.parent?.kind === 'world' ? 'the world' : entity.parent?.name ?? 'its parent'}`, !canMove(entity));
    }
  };
  // joint positions are not in the pose frames, so the state is subscribed to while a joint is selected
  let endState: (() => void) | null = null;
  const followJoint = (): void => {
    endState?.();
    endState = null;
    if (world.entities.get(selection.id)?.kind !== 'joint') return;
    endState = connection.subscribe(world.path('state'), (step) => {
      const moving = step.state?.entities?.[String(selection.id)] as Message | undefined;
      if (moving) showJoint(moving);
    });
  };
  const showJoint = (moving: Message): void => {
    const components = new Components(moving);
    const data = (name: string): number[] => components.message(name, 'ignition.msgs.Double_V', connection.types)?.data ?? [];
    motion.textContent = `${list(data('JointPosition'))}, ${list(data('JointVelocity'))}`;
    fields?.showPositions?.(jointPositions(moving, connection.types));
  };
  ends.add(selection.changed.on(() => {
    show();
    followJoint();
  }), connection.infoReceived.on(() => {
    fields = null;
    show();
  }), world.changed.on(show), world.framed.on(showPose), () => endState?.());
  show();
  followJoint();
  return { element: h('div', { class: 'inspector' }, nothing, table), close: ends.end };
}
