/// Sets target positions of a model's joints: publishes Doubles on the topics of JointPositionController.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, numberField, setChoices } from '../app/dom.ts';
import { kJointNames, type Entity } from '../connection/entities.ts';
import type { Message } from '../connection/types.ts';
import { topicSetting, topicsOf } from './topics.ts';

/// The range of a joint's slider: its limits; without limits one turn, or 1 m, in each direction.
export function rangeOf(kind: string, axis: Message | undefined): [number, number] {
  const [lower, upper] = [axis?.limitLower as number, axis?.limitUpper as number];
  const isLimited = Number.isFinite(lower) && Number.isFinite(upper) && upper > lower && upper - lower < 1e3;
  if (isLimited) return [lower, upper];
  return kind === 'prismatic' ? [-1, 1] : [-Math.PI, Math.PI];
}

/// The topic on which a controller of the joint listens: the usual one, or one whose name has that of the joint; '' if there
/// is neither.
/// @param topics Those of type Double.
export function controllerTopic(model: string, joint: string, topics: readonly string[]): string {
  const usual = `/model/${model}/joint/${joint}/0/cmd_pos`;
  if (topics.includes(usual)) return usual;
  const own = topics.filter((topic) => !/^\/model\/.*\/joint\/.*\/cmd_(?:pos|vel|force)$/.test(topic));
  return own.find((topic) => topic.split(/[/_]/).includes(joint) || topic.includes(joint)) ?? '';
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
  // update the topics of the rows
  let shownTopics: (() => void)[] = [];

  const row = (model: string, joint: Entity): HTMLElement => {
    const kind = kJointNames[Number(joint.components.text('JointType'))] ?? '';
    const axis = joint.components.message('JointAxis', 'ignition.msgs.Axis', connection.types);
    const [lower, upper] = rangeOf(kind, axis);
    // a controller may name any topic, so the user can choose
    const topic = h('select', { class: 'wide target', 'aria-label': `Topic of ${joint.name}` });
    const now = joint.components.message('JointPosition', 'ignition.msgs.Double_V', connection.types)?.data?.[0] ?? 0;
    const slider = h('input', { type: 'range', min: lower, max: upper, step: (upper - lower) / 500, class: 'wide', 'aria-label': joint.name });
    const field = numberField(Number((now as number).toFixed(4)), { class: 'short', 'aria-label': `${joint.name}, number` });
    slider.value = field.value;
    const send = (value: number): void => {
      if (!Number.isFinite(value) || topic.value === '') return;
      try {
        connection.publish(topic.value, 'ignition.msgs.Double', { data: value });
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
    const showTopic = (): void => {
      const topics = topicsOf(context, ['ignition.msgs.Double']);
      const isUsual = controllerTopic(model, joint.name, topics) === `/model/${model}/joint/${joint.name}/0/cmd_pos`;
      const before = topic.value;
      setChoices(topic, topics, `${joint.name}: no controller's topic`);
      if (before === '') topic.value = controllerTopic(model, joint.name, topics);
      topic.hidden = isUsual;
      slider.disabled = field.disabled = topic.value === '';
    };
    topic.addEventListener('change', showTopic);
    showTopic();
    shownTopics.push(showTopic);
    return h('div', { class: 'slider' }, h('span', { title: joint.name }, joint.name), slider, field, topic);
  };
  const show = (): void => {
    const models = world.entities.all('model').filter((model) => movingJoints(model).length > 0);
    setChoices(select, models.map((model) => world.entities.scopedName(model)));
    const model = models.find((each) => world.entities.scopedName(each) === select.value);
    const joints = model ? movingJoints(model) : [];
    const key = `${select.value} ${joints.map(({ id }) => id).join(' ')}`;
    if (key === shown) return;
    shown = key;
    shownTopics = [];
    if (model) rows.replaceChildren(...joints.map((joint) => row(model.name, joint)));
    else rows.replaceChildren(h('p', { class: 'hint' }, 'No model has joints that move'));
  };
  select.addEventListener('change', () => {
    select.dataset.chosen = 'yes';
    show();
  });
  ends.add(connection.channelsChanged.on(() => shownTopics.forEach((update) => update())), world.changed.on(show), selection.changed.on((id) => {
    const entity = world.entities.get(id);
    if (entity) select.value = world.entities.scopedName(world.entities.topOf(entity)) || select.value;
    if (select.value === '') select.selectedIndex = 0;
    show();
  }));
  show();
  const wanted = setting(settings, 'model_name');
  if (wanted && [...select.options].some(({ value }) => value === wanted)) {
    select.value = wanted;
    select.dataset.chosen = 'yes';
    show();
  }
  return { element: h('div', { class: 'joints' }, select, rows), close: ends.end, settings: () => topicSetting(select, 'model_name') };
}
