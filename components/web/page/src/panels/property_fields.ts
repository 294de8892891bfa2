/// Fields of the inspector that change the selected entity.
import { Components } from '../connection/components.ts';
import type { Entity } from '../connection/entities.ts';
import type { Message, MessageTypes } from '../connection/types.ts';
import type { Context } from '../app/context.ts';
import { h, isEditing, numberField, onEntered } from '../app/dom.ts';
import { changeLight, setColor, setGravity, setJointPositions, setMass, type Rgb } from '../app/edits.ts';
import { isOn, switched } from './lights.ts';

/// A row of the inspector.
export interface PropertyField {
  name: string;
  element: HTMLElement;
  /// Shows the present value, unless the field is being edited.
  show(entity: Entity): void;
}

const kHex = 16;

/// "#ff8000" for a colour with numbers from 0 to 1.
export function hexOf(color: Rgb): string {
  const pair = (share: number): string => Math.round(Math.min(Math.max(share, 0), 1) * 255).toString(kHex).padStart(2, '0');
  return `#${color.map(pair).join('')}`;
}

export function rgbOfHex(text: string): Rgb {
  return [1, 3, 5].map((start) => parseInt(text.slice(start, start + 2), kHex) / 255) as Rgb;
}

/// Rounded, as messages have colours and intensities with 24 bits.
const kDigits = 6;
const rounded = (value: number): string => String(Number(value.toPrecision(kDigits)));

/// A row of numbers that are changed together.
class Numbers implements PropertyField {
  private readonly inputs: HTMLInputElement[];
  private values: readonly number[] = [];
  readonly element: HTMLElement;

  /// @param names Accessible names, one for each number.
  /// @param change Called when a number has been entered, with what makes the new numbers of the present ones.
  constructor(
    readonly name: string, names: readonly string[], private readonly read: (entity: Entity) => readonly number[],
    change: (enter: (now: readonly number[]) => number[]) => void, more: Record<string, string | number> = {},
  ) {
    this.inputs = names.map((each, i) => numberField(0, {
      'aria-label': each, class: 'short', ...more, onblur: () => this.write(i),
    }));
    this.inputs.forEach((input, i) => onEntered(input, () => {
      const entered = input.valueAsNumber;
      if (Number.isFinite(entered)) change((now) => now.map((value, k) => (k === i ? entered : value)));
    }));
    this.element = h('span', { class: 'property' }, ...this.inputs);
  }

  show(entity: Entity): void {
    this.showValues(this.read(entity));
  }

  showValues(values: readonly number[]): void {
    this.values = values;
    this.inputs.forEach((input, i) => {
      if (!isEditing(input)) this.write(i);
    });
  }

  private write(i: number): void {
    this.inputs[i]!.value = this.values[i] === undefined ? '' : rounded(this.values[i]);
  }
}

class Color implements PropertyField {
  readonly name = 'Colour';
  readonly element = h('input', { type: 'color', 'aria-label': 'Colour' });

  constructor(private readonly read: (entity: Entity) => Rgb, change: (color: Rgb) => void) {
    onEntered(this.element, () => change(rgbOfHex(this.element.value)));
  }

  show(entity: Entity): void {
    this.element.value = hexOf(this.read(entity));
  }
}

class Switch implements PropertyField {
  readonly element = h('input', { type: 'checkbox' });

  constructor(readonly name: string, private readonly read: (entity: Entity) => boolean, change: (on: boolean) => void) {
    this.element.setAttribute('aria-label', name);
    this.element.addEventListener('change', () => change(this.element.checked));
  }

  show(entity: Entity): void {
    this.element.checked = this.read(entity);
  }
}

const rgb = (color: Message | undefined): Rgb => [color?.r ?? 0, color?.g ?? 0, color?.b ?? 0];

/// The colour of a visual; that of one without a material.
export function colorOf(visual: Entity, types: MessageTypes): Rgb {
  const material = visual.components.message('Material', 'ignition.msgs.Material', types);
  return material ? rgb(material.diffuse as Message) : [0.7, 0.7, 0.7];
}

/// Whether a link is part of a static model, so that its mass has no effect.
function isFixed(link: Entity): boolean {
  for (let above = link.parent; above; above = above.parent) if (above.components.text('Static') === '1') return true;
  return false;
}

/// The positions of a joint's axes in a state message.
export function jointPositions(entity: Message, types: MessageTypes): number[] {
  return (new Components(entity).message('JointPosition', 'ignition.msgs.Double_V', types)?.data ?? []) as number[];
}

export interface PropertyFields {
  all: PropertyField[];
  /// Of a joint: shows where it is now.
  showPositions?(positions: readonly number[]): void;
}

/// The fields of an entity; none if nothing of it can be changed.
export function propertyFields(context: Context, entity: Entity): PropertyFields {
  const { connection: { types }, world } = context;
  const now = (): Entity => world.entities.get(entity.id) ?? entity;
  // shows what is true after a change, also if it was refused
  const ask = (what: string, change: Promise<void>): void => void context.attempt(what, change).then((isDone) => (isDone ? undefined : world.read()));
  if (entity.kind === 'world') {
    const read = ({ components }: Entity): number[] => components.numbers('Gravity') ?? [];
    const change = (enter: Enter): void => ask('Gravity', setGravity(context, read(now()), enter));
    return { all: [new Numbers('Gravity [m/s²]', ['Gravity x', 'Gravity y', 'Gravity z'], read, change)] };
  }
  if (entity.kind === 'link' && !isFixed(entity)) {
    const read = ({ components }: Entity): number[] => [components.message('Inertial', 'ignition.msgs.Inertial', types)?.mass ?? 0];
    const change = (enter: Enter): void => ask('Mass', setMass(context, entity, read(now())[0]!, enter([0])[0]!));
    return { all: [new Numbers('Mass [kg]', ['Mass'], read, change, { min: 0 })] };
  }
  if (entity.kind === 'visual') {
    return { all: [new Color((visual) => colorOf(visual, types), (color) => ask('Colour', setColor(context, entity, colorOf(now(), types), color)))] };
  }
  if (entity.kind === 'joint') return jointFields(context, entity, ask);
  return entity.kind === 'light' ? { all: lightFields(context, entity, ask) } : { all: [] };
}

type Enter = (now: readonly number[]) => number[];
type Ask = (what: string, change: Promise<void>) => void;

function jointFields(context: Context, joint: Entity, ask: Ask): PropertyFields {
  const axes = ['JointAxis', 'JointAxis2'].filter((name) => joint.components.has(name)).length;
  if (axes === 0) return { all: [] };
  let positions: readonly number[] = [];
  const names = axes > 1 ? ['Position of axis 1', 'Position of axis 2'] : ['Position'];
  const field = new Numbers('Position', names, () => positions, (enter) => ask('Joint', setJointPositions(context, joint, positions, enter)));
  return {
    all: [field],
    showPositions: (seen) => {
      positions = seen;
      field.showValues(seen);
    },
  };
}

function lightFields(context: Context, entity: Entity, ask: Ask): PropertyField[] {
  const { types } = context.connection;
  const read = ({ components }: Entity): Message => components.message('Light', 'ignition.msgs.Light', types) ?? {};
  const change = (how: (light: Message) => Message): void => ask('Light', changeLight(context, entity, how));
  const number = (name: string, key: string): Numbers =>
    new Numbers(name, [name], (light) => [read(light)[key] as number], (enter) => change((light) => ({ ...light, [key]: enter([0])[0] })), { min: 0 });
  return [
    new Switch('On', (light) => isOn(read(light)), (on) => change((light) => switched(light, on))),
    new Color((light) => rgb(read(light).diffuse as Message),
      ([r, g, b]) => change((light) => ({ ...light, diffuse: { ...(light.diffuse as Message), r, g, b } }))),
    number('Intensity', 'intensity'),
    number('Range [m]', 'range'),
  ];
}
