/// Publishes a message, entered in a form for its type, once or at a rate.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, labelled, numberField } from '../app/dom.ts';
import { fullTopic } from '../connection/topic_name.ts';
import { messageForm } from './message_form.ts';

export function openPublisher(context: Context, settings: Settings): Panel {
  const { connection, log } = context;
  const ends = new Ends();
  const topic = h('input', { value: fullTopic(setting(settings, 'topic') ?? '/cmd_vel'), class: 'wide' });
  const list = h('datalist', { id: 'message-types' }, ...connection.types.names().map((name) => h('option', { value: name })));
  const type = h('input', { value: setting(settings, 'msg_type') ?? 'ignition.msgs.Twist', list: 'message-types', class: 'wide' });
  const place = h('div', {});
  const note = h('p', { class: 'hint', role: 'status' });
  const rate = numberField(0, { min: 0, max: 100, title: '0: once', class: 'short' });
  let form: ReturnType<typeof messageForm> | null = null;
  const make = (): void => {
    form = null;
    const found = connection.types.find(type.value.replace(/^gz\.msgs\./, 'ignition.msgs.'));
    note.textContent = found ? '' : `The message type ${type.value} is unknown`;
    if (found) form = messageForm(found);
    place.replaceChildren(...(form ? [form.element] : []));
  };
  let timer: ReturnType<typeof setInterval> | undefined;
  const publish = (): boolean => {
    try {
      if (!form) throw new Error('there is no such message type');
      connection.publish(topic.value, type.value.replace(/^gz\.msgs\./, 'ignition.msgs.'), form.value());
      note.textContent = `Published on ${topic.value}`;
      return true;
    } catch (fault) {
      note.textContent = (fault as Error).message;
      log.add('error', `Publish: ${(fault as Error).message}`);
      return false;
    }
  };
  const stop = (): void => {
    clearInterval(timer);
    timer = undefined;
    button.textContent = 'Publish';
  };
  const button = h('button', {
    type: 'button', onclick: () => {
      if (timer !== undefined) return stop();
      if (!publish() || !(rate.valueAsNumber > 0)) return;
      timer = setInterval(() => publish() || stop(), 1000 / rate.valueAsNumber);
      button.textContent = 'Stop';
    },
  }, 'Publish');
  type.addEventListener('change', make);
  make();
  ends.add(() => clearInterval(timer));
  const element = h('div', { class: 'publisher' }, labelled('Topic', topic), labelled('Type', type), list, place,
    h('div', { class: 'row' }, labelled('Rate [Hz]', rate), button), note);
  return { element, close: ends.end, settings: () => ({ topic: [topic.value], msg_type: [type.value] }) };
}
