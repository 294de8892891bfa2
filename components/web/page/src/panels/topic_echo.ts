/// Shows the messages of a topic as text.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, numberField, shortNumber } from '../app/dom.ts';
import type { Message } from '../connection/types.ts';
import { topicChooser, topicSetting } from './topics.ts';

const kLongest = 20_000;
// time between two updates of the text, and of the rate
const kWriteMs = 300;
const kRateMs = 1000;

/// A message as indented JSON, with long values shortened, and truncated if it is still too long.
export function echoText(json: unknown): string {
  const text = JSON.stringify(json, shortened, 2);
  return text.length > kLongest ? `${text.slice(0, kLongest)}\n… ${text.length - kLongest} more characters` : text;
}

/// A replacer for JSON.stringify, which shortens long text; bytes are base64 text by then.
function shortened(_key: string, value: unknown): unknown {
  if (typeof value === 'string' && value.length > 400) return `${value.slice(0, 80)}… (${value.length} letters)`;
  if (Array.isArray(value) && value.length > 100) return [...value.slice(0, 100), `… ${value.length - 100} more`];
  return value;
}

export function openTopicEcho(context: Context, settings: Settings): Panel {
  const { connection } = context;
  const ends = new Ends();
  let stop = (): void => {};
  const kept: string[] = [];
  const isPaused = h('input', { type: 'checkbox', id: `echo-paused-${Math.random().toString(36).slice(2)}` });
  const most = numberField(10, { min: 1, max: 100, step: 1, 'aria-label': 'Messages to keep', class: 'short' });
  const output = h('pre', { class: 'echo', tabindex: 0, role: 'region', 'aria-label': 'Messages of the topic' });
  const rate = h('span', { class: 'hint' });
  // written a few times a second, because messages may arrive faster than anybody reads
  let timer: ReturnType<typeof setTimeout> | undefined;
  let [count, since] = [0, performance.now()];
  const write = (): void => {
    timer ??= setTimeout(() => {
      timer = undefined;
      output.textContent = kept.join('\n');
      const now = performance.now();
      if (now - since < kRateMs) return;
      rate.textContent = `${shortNumber(Math.round((10_000 * count) / (now - since)) / 10)} per second`;
      [count, since] = [0, now];
    }, kWriteMs);
  };
  const drop = (): void => {
    kept.length = Math.min(kept.length, Math.max(1, most.valueAsNumber || 1));
  };
  most.addEventListener('input', () => {
    drop();
    write();
  });
  const listen = (topic: string): void => {
    stop();
    stop = (): void => {};
    kept.length = 0;
    write();
    if (!topic) return;
    stop = connection.subscribe(topic, (message: Message, _time, type) => {
      ++count;
      if (isPaused.checked) return;
      kept.unshift(echoText(connection.types.json(type, message)));
      drop();
      write();
    }, true);
  };
  const select = topicChooser(context, [], setting(settings, 'topic'), ends, listen);
  ends.add(() => stop(), () => clearTimeout(timer));
  const element = h('div', { class: 'topic-echo' }, select,
    h('div', { class: 'row' }, isPaused, h('label', { for: isPaused.id }, 'Paused'), most, ' kept', rate), output);
  return { element, close: ends.end, settings: () => topicSetting(select) };
}
