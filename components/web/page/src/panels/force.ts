/// Applies forces and torques to a link: publishes wrenches on the topics of ApplyLinkWrench.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, labelled, numberField, setChoices } from '../app/dom.ts';
import type { Entity } from '../connection/entities.ts';

// ignition.msgs.Entity.Type
const kLink = 3;

function linksOf(model: Entity): Entity[] {
  return model.children.flatMap((child) => (child.kind === 'link' ? [child] : child.kind === 'model' ? linksOf(child) : []));
}

export function openForce(context: Context): Panel {
  const { world, connection, selection } = context;
  const ends = new Ends();
  const name = h('strong', {}, '–');
  const link = h('select', { class: 'wide' });
  const vector = (unit: string): HTMLInputElement[] => ['x', 'y', 'z'].map((axis) => numberField(0, { 'aria-label': `${axis} [${unit}]` }));
  const [force, torque] = [vector('N'), vector('N m')];
  const note = h('p', { class: 'hint', role: 'status' });
  const missing = h('p', { class: 'hint' }, 'This world has no system ApplyLinkWrench, which applies forces');
  const xyz = (fields: HTMLInputElement[]): object => {
    const [x, y, z] = fields.map((field) => field.valueAsNumber || 0);
    return { x, y, z };
  };
  const entity = (): object | null => {
    const chosen = world.entities.get(Number(link.value));
    return chosen ? { id: BigInt(chosen.id), type: kLink } : null;
  };
  const send = (suffix: string, with_: boolean): void => {
    const whose = entity();
    if (!whose) return;
    const topic = world.path('wrench') + suffix;
    try {
      if (with_) connection.publish(topic, 'ignition.msgs.EntityWrench', { entity: whose, wrench: { force: xyz(force), torque: xyz(torque) } });
      else connection.publish(topic, 'ignition.msgs.Entity', whose);
      note.textContent = 'Sent';
    } catch (fault) {
      note.textContent = (fault as Error).message;
    }
  };
  // the topic is there while the system listens to it
  const showSystem = (): void => {
    const isThere = connection.channels.has(world.path('wrench'));
    missing.hidden = isThere;
  };
  const show = (): void => {
    const chosen = world.entities.get(selection.id);
    const model = chosen && world.entities.topOf(chosen);
    const links = model?.kind === 'model' ? linksOf(model) : [];
    name.textContent = links.length > 0 ? model!.name : 'No model is selected';
    setChoices(link, links.map(({ id }) => String(id)));
    [...link.options].forEach((option, i) => (option.textContent = world.entities.scopedName(links[i]!)));
    const own = links.find(({ id }) => id === selection.id);
    if (own) link.value = String(own.id);
  };
  ends.add(selection.changed.on(show), world.changed.on(show), connection.channelsChanged.on(showSystem));
  show();
  showSystem();
  const button = (text: string, act: () => void): HTMLElement => h('button', { type: 'button', onclick: act }, text);
  const element = h('div', { class: 'force' }, h('p', {}, name), labelled('Link', link),
    h('fieldset', {}, h('legend', {}, 'Force [N]'), ...force), h('fieldset', {}, h('legend', {}, 'Torque [N m]'), ...torque),
    h('div', { class: 'row' }, button('For one step', () => send('', true)), button('From now on', () => send('/persistent', true)),
      button('End', () => send('/clear', false))), missing, note);
  return { element, close: ends.end };
}
