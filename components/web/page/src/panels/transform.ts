/// Shows the pose of the selected model, which can be changed by handles or numbers.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, numberField } from '../app/dom.ts';
import { move } from '../app/edits.ts';
import { poseMessage, rollPitchYawOf, sixfoldOf, type Sixfold } from '../connection/poses.ts';
import type { Tool } from '../view/index.ts';

const kAxes = ['X [m]', 'Y [m]', 'Z [m]', 'Roll [rad]', 'Pitch [rad]', 'Yaw [rad]'];

export function openTransform(context: Context): Panel {
  const { world, selection, view, connection } = context;
  const ends = new Ends();
  const fields = kAxes.map((name) => numberField(0, { 'aria-label': name, step: 0.1 }));
  const name = h('strong', {}, '–');
  // entered numbers are kept until they are applied or another entity is selected
  let isEdited = false;
  fields.forEach((field) => field.addEventListener('input', () => (isEdited = true)));
  const tools = (['select', 'move', 'turn'] as Tool[]).map((tool) => h('button', {
    type: 'button', 'data-tool': tool, disabled: !view, onclick: () => view?.setTool(tool),
  }, { select: 'Select', move: 'Move', turn: 'Turn' }[tool]));
  const top = (): number | null => {
    const entity = world.entities.get(selection.id);
    const found = entity && entity.kind !== 'world' ? world.entities.topOf(entity) : undefined;
    return found?.kind === 'model' ? found.id : null;
  };
  const show = (): void => {
    const id = top();
    const entity = world.entities.get(id);
    name.textContent = entity?.name ?? 'No model is selected';
    apply.disabled = !entity || connection.isReadOnly;
    if (!entity || isEdited || fields.some((field) => field === document.activeElement)) return;
    const live = world.poses.get(entity.id);
    const message = live && { position: { x: live[0], y: live[1], z: live[2] } };
    const turned = live ? rollPitchYawOf([live[3]!, live[4]!, live[5]!, live[6]!]) : [];
    const pose = message ? [...sixfoldOf(message).slice(0, 3), ...turned] : (entity.components.numbers('Pose') ?? []);
    fields.forEach((field, i) => (field.value = String(Number((pose[i] ?? 0).toFixed(4)))));
  };
  const apply = h('button', { type: 'submit' }, 'Move there');
  const form = h('form', { onsubmit: (event: Event) => {
    event.preventDefault();
    const id = top();
    const pose = fields.map((field) => field.valueAsNumber || 0) as Sixfold;
    isEdited = false;
    const entity = world.entities.get(id);
    if (entity) void context.attempt('Move', move(context, entity, () => poseMessage(pose)));
  } }, h('div', { class: 'six' }, ...fields.map((field, i) => h('label', {}, kAxes[i]!, field))), apply);
  ends.add(selection.changed.on(() => {
    isEdited = false;
    show();
  }), world.changed.on(show), world.framed.on(show));
  show();
  return { element: h('div', { class: 'transform' }, h('p', {}, name), h('div', { class: 'row' }, ...tools), form), close: ends.end };
}
