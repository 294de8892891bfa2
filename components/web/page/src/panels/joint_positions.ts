/// Sets target positions of a model's joints: publishes Doubles on the topics of JointPositionController.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, numberField, setChoices } from '../app/dom.ts';
import { kJointNames, type Entity } from '../connection/entities.ts';
import type { Message } from '../connection/types.ts';

/// The range of a joint's slider: its limits; without limits one turn, or 1 m, in each direction.
export function rangeOf(kind: string, axis: Message | undefined): [number, number] {
  const [lower, upper] = [axis?.limitLower as number, axis?.limitUpper as number];
  const isLimited = Number.isFinite(lower) && Number.isFinite(upper) && upper > lower && upper - lower < 1e3;
  if (isLimited) return [lower, upper];
  return kind === 'prismatic' ? [-1, 1] : [-Math.PI, Math.PI];
}

function movingJoints(model: Entity): Entity[] {
  const own = model.children.filter(({ kind, components }) => kind === 'joint' && components.has('JointAxis'));
  return [...own, ...model.children.filter(({ kind }) => kind === 'model').flatMap(movingJoints)];
}

export function openJointPositions(context: Context, settings: Settings): Panel {
  const { connection, world, selection, log } = context;
  const ends = new Ends();
  const select = h('select', { 'aria-label': 'Model', class: 'wide' });
  const rows = h('div', {});
  let shown = '';

  const row = (model: string, joint: Entity): HTMLElement => {
    const kind = kJointNames[Number(joint.components.text('JointType'))] ?? '';
    const axis = joint.components.message('JointAxis', 'ignition.msgs.Axis', connection.types);
    const [lower, upper] = rangeOf(kind, axis);
    const topic = `/model/${model}/joint/${joint.name}/0/cmd_pos`;
    const now = joint.components.message('JointPosition', 'ignition.msgs.Double_V', connection.types)?.data?.[0] ?? 0;
    const slider = h('input', { type: 'range', min: lower, max: upper, step: (upper - lower) / 500, class: 'wide', 'aria-label': joint.name });
    const field = numberField(Number((now as number).toFixed(4)), { class: 'short', 'aria-label': `${joint.name}, number` });
    slider.value = field.value;
    const send = (value: number): void => {
      if (!Number.isFinite(value)) return;
      try {
        connection.publish(topic, 'ignition.msgs.Double', { data: value });
      } catch (fault) {
        log.add('error', `Joint position: ${(fault as Error).message}`);
      }
    };
    slider.addEventListener('input', () => {
      field.value = String(Number(slider.valueAsNumber.toFixed(4)));
      send(slider.valueAsNumber);
    });
    field.addEventListener('change', () => {
      slider.value = field.value;
      send(field.valueAsNumber);
    });
    return h('div', { class: 'slider', title: topic }, h('span', {}, joint.name), slider, field);
  };
  const show = (): void => {
    const models = world.entities.all('model').filter((model) => movingJoints(model).length > 0);
    setChoices(select, models.map((model) => world.entities.scopedName(model)));
    const model = models.find((each) => world.entities.scopedName(each) === select.value);
    const joints = model ? movingJoints(model) : [];
    const key = `${select.value} ${joints.map(({ id }) => id).join(' ')}`;
    if (key === shown) return;
    shown = key;
    if (model) rows.replaceChildren(...joints.map((joint) => row(model.name, joint)));
    else rows.replaceChildren(h('p', { class: 'hint' }, 'No model has joints that move'));
  };
  select.addEventListener('change', show);
  ends.add(world.changed.on(show), selection.changed.on((id) => {
    const entity = world.entities.get(id);
    if (entity) select.value = world.entities.scopedName(world.entities.topOf(entity)) || select.value;
    if (select.value === '') select.selectedIndex = 0;
    show();
  }));
  show();
  const wanted = setting(settings, 'model_name');
  if (wanted && [...select.options].some(({ value }) => value === wanted)) {
    select.value = wanted;
    show();
  }
  return { element: h('div', { class: 'joints' }, select, rows), close: ends.end };
}
