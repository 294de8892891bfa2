/// Drives a model by a joystick, a gamepad, sliders and buttons: publishes Twists at 10 Hz while any value is not 0.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, labelled, numberField, shortNumber } from '../app/dom.ts';
import { fullTopic } from '../connection/topic_name.ts';
import { followGamepad } from './gamepad.ts';
import { joystick } from './joystick.ts';

export function openTeleop(context: Context, settings: Settings): Panel {
  const { connection, log } = context;
  const ends = new Ends();
  const topics = h('datalist', { id: 'twist-topics' });
  const topic = h('input', { value: fullTopic(setting(settings, 'topic') ?? '/cmd_vel'), list: 'twist-topics', class: 'wide' });
  const limits = { forward: numberField(1, { min: 0, class: 'short' }), turn: numberField(1, { min: 0, class: 'short' }) };
  let [forward, turn] = [0, 0];
  let timer: ReturnType<typeof setInterval> | undefined;
  const send = (): void => {
    try {
      connection.publish(topic.value, 'ignition.msgs.Twist', { linear: { x: forward }, angular: { z: turn } });
    } catch (fault) {
      clearInterval(timer);
      log.add('error', `Teleop: ${(fault as Error).message}`);
    }
  };
  const slider = (name: string, limit: HTMLInputElement, set: (value: number) => void): [HTMLElement, (value: number) => void] => {
    const range = h('input', { type: 'range', min: -1, max: 1, step: 0.01, class: 'wide', 'aria-label': name });
    const value = h('output', {}, '0');
    range.value = '0';
    const changed = (): void => {
      const wanted = range.valueAsNumber * (limit.valueAsNumber || 0);
      value.textContent = shortNumber(wanted);
      range.setAttribute('aria-valuetext', value.textContent);
      set(wanted);
      drive();
    };
    range.addEventListener('input', changed);
    const element = h('div', { class: 'slider' }, h('span', {}, name), range, value);
    return [element, (part) => {
      range.value = String(part);
      changed();
    }];
  };
  const drive = (): void => {
    clearInterval(timer);
    send();
    if (forward !== 0 || turn !== 0) timer = setInterval(send, 100);
  };
  const [forwardRow, setForward] = slider('Forward [m/s]', limits.forward, (value) => (forward = value));
  const [turnRow, setTurn] = slider('Turn left [rad/s]', limits.turn, (value) => (turn = value));
  const button = (sign: string, name: string, x: number, z: number): HTMLElement => h('button', {
    type: 'button', 'aria-label': name, title: name, onclick: () => {
      setForward(x);
      setTurn(z);
    },
  }, sign);
  ends.add(() => {
    clearInterval(timer);
    if (forward !== 0 || turn !== 0) {
      [forward, turn] = [0, 0];
      send();
    }
  });
  const offer = (): void => {
    const names = [...connection.channels.values()].filter(({ schemaName }) => schemaName === 'ignition.msgs.Twist');
    topics.replaceChildren(...names.map((channel) => h('option', { value: channel.topic })));
  };
  ends.add(connection.channelsChanged.on(offer));
  offer();
  const steer = (right: number, up: number): void => {
    setForward(up);
    setTurn(-right);
  };
  const stick = joystick(steer);
  ends.add(followGamepad(steer));
  const element = h('div', { class: 'teleop' },
    h('div', { class: 'steering' }, stick, h('div', { class: 'pad' },
      button('↑', 'Forward', 1, 0), button('←', 'Turn left', 0, 1), button('■', 'Stop', 0, 0),
      button('→', 'Turn right', 0, -1), button('↓', 'Back', -1, 0))),
    forwardRow, turnRow, labelled('Topic', topic), topics,
    h('div', { class: 'row wrap' }, labelled('Max [m/s]', limits.forward), labelled('Max [rad/s]', limits.turn)));
  return { element, close: ends.end, settings: () => ({ topic: [topic.value] }) };
}
