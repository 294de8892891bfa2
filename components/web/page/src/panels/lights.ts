/// The world's lights: switches, intensities, and buttons that add lights.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, numberField, setChildren } from '../app/dom.ts';
import { changeLight, fromText, insert, lightNow } from '../app/edits.ts';
import type { Entity } from '../connection/entities.ts';
import type { Message } from '../connection/types.ts';
import { lightSdf, type LightType } from './shapes.ts';

const kKey = 'isLightOn';

/// Whether a light is on. Fortress stores that in the message's header, as `isLightOn`.
export function isOn(light: Message): boolean {
  const entry = (light.header?.data as Message[] | undefined)?.find(({ key }) => key === kKey);
  return entry?.value?.[0] !== '0';
}

/// A copy of the light message, switched on or off.
export function switched(light: Message, on: boolean): Message {
  const data = ((light.header?.data ?? []) as Message[]).filter(({ key }) => key !== kKey);
  return { ...light, header: { ...light.header, data: [...data, { key: kKey, value: [on ? '1' : '0'] }] } };
}

/// The row of a light, kept while the light changes, because a new element would lose focus or a click in progress.
class Row {
  private readonly box = h('input', { type: 'checkbox' });
  private readonly name = h('button', { type: 'button', class: 'link' });
  private readonly intensity = numberField(1, { min: 0, step: 0.1, class: 'short' });
  readonly element = h('div', { class: 'row' }, this.box, this.name, this.intensity);

  /// @param change Requests the change of the light.
  constructor(change: (how: (light: Message) => Message) => void, choose: () => void) {
    this.box.addEventListener('change', () => change((light) => switched(light, this.box.checked)));
    this.intensity.addEventListener('change', () => change((light) => ({ ...light, intensity: this.intensity.valueAsNumber || 0 })));
    this.name.addEventListener('click', choose);
  }

  show(light: Message): void {
    this.box.checked = isOn(light);
    this.box.setAttribute('aria-label', `${light.name} is on`);
    this.name.textContent = light.name as string;
    this.intensity.setAttribute('aria-label', `Intensity of ${light.name}`);
    if (document.activeElement !== this.intensity) this.intensity.value = String(light.intensity ?? 1);
  }
}

export function openLights(context: Context): Panel {
  const { world, selection } = context;
  const ends = new Ends();
  const rows = h('div', {});
  const none = h('p', { class: 'hint' }, 'There are no lights');
  let byId = new Map<number, Row>();
  const show = (): void => {
    const before = byId;
    byId = new Map(world.entities.all('light').map((light) => {
      const row = before.get(light.id) ?? new Row((how) => void change(light, how), () => selection.set(light.id));
      row.show(lightNow(context, light));
      return [light.id, row];
    }));
    setChildren(rows, byId.size > 0 ? [...byId.values()].map(({ element }) => element) : [none]);
  };
  const change = async (light: Entity, how: (light: Message) => Message): Promise<void> => {
    if (!(await context.attempt('Light', changeLight(context, light, how)))) await world.read();
    // also if the request was refused, to show the actual values
    setTimeout(show);
  };
  const add = (type: LightType): HTMLElement => h('button', {
    type: 'button', onclick: async () => {
      const place = await context.choosePlace({ name: type, type: ['point', 'spot', 'directional'].indexOf(type), diffuse: { r: 1, g: 1, b: 1, a: 1 } });
      if (!place) return;
      const factory = fromText(lightSdf(type), [place.position[0], place.position[1], 3, 0, 0, 0], type);
      void context.attempt('Light', insert(context, `Add ${type} light`, factory, type));
    },
  }, `+ ${type}`);
  ends.add(world.changed.on(show));
  show();
  const element = h('div', { class: 'lights' }, rows, h('div', { class: 'row' }, add('point'), add('spot'), add('directional')));
  return { element, close: ends.end };
}
