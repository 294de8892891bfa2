/// The lights of the world: switched, dimmed and added.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, numberField } from '../app/dom.ts';
import type { Message } from '../connection/types.ts';
import { lightSdf, type LightType } from './shapes.ts';

const kKey = 'isLightOn';

/// Whether a light is on: Fortress stores that in the message's header.
export function isOn(light: Message): boolean {
  const entry = (light.header?.data as Message[] | undefined)?.find(({ key }) => key === kKey);
  return entry?.value?.[0] !== '0';
}

/// The same light, switched on or off.
export function switched(light: Message, on: boolean): Message {
  const data = ((light.header?.data ?? []) as Message[]).filter(({ key }) => key !== kKey);
  return { ...light, header: { ...light.header, data: [...data, { key: kKey, value: [on ? '1' : '0'] }] } };
}

export function openLights(context: Context): Panel {
  const { world, connection, selection } = context;
  const ends = new Ends();
  const rows = h('div', {});
  const change = (name: string, light: Message): void => {
    void context.attempt(name, world.ask('light_config', light)).then(() => world.read());
  };
  const show = (): void => {
    if (rows.contains(document.activeElement) && document.activeElement instanceof HTMLInputElement
      && document.activeElement.type === 'number') return;
    const lights = world.entities.all('light').map((entity) => {
      const settings = entity.components.message('Light', 'ignition.msgs.Light', connection.types) ?? {};
      const light = { ...settings, id: entity.id, name: entity.name };
      const box = h('input', { type: 'checkbox', 'aria-label': `${entity.name} is on`, checked: isOn(light) });
      box.addEventListener('change', () => change('Light', switched(light, box.checked)));
      const bright = numberField((settings.intensity as number) ?? 1, { min: 0, step: 0.1, class: 'short', 'aria-label': `Intensity of ${entity.name}` });
      bright.addEventListener('change', () => change('Light', { ...light, intensity: bright.valueAsNumber || 0 }));
      const name = h('button', { type: 'button', class: 'link', onclick: () => selection.set(entity.id) }, entity.name);
      return h('div', { class: 'row' }, box, name, bright);
    });
    rows.replaceChildren(...(lights.length > 0 ? lights : [h('p', { class: 'hint' }, 'There are no lights')]));
  };
  const add = (type: LightType): HTMLElement => h('button', {
    type: 'button', onclick: async () => {
      const place = await context.choosePlace({ name: type, type: ['point', 'spot', 'directional'].indexOf(type), diffuse: { r: 1, g: 1, b: 1, a: 1 } });
      if (place) void context.attempt('Light', world.spawn(lightSdf(type), [place.position[0], place.position[1], 3, 0, 0, 0], type));
    },
  }, `+ ${type}`);
  ends.add(world.changed.on(show));
  show();
  const element = h('div', { class: 'lights' }, rows, h('div', { class: 'row' }, add('point'), add('spot'), add('directional')));
  return { element, close: ends.end };
}
