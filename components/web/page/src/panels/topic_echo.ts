/// Shows the messages of a topic as text.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, numberField } from '../app/dom.ts';
import type { Message } from '../connection/types.ts';
import { topicChooser } from './topics.ts';

const kLongest = 20_000;

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
  // written once per animation frame, because messages may arrive faster
  let isScheduled = false;
  const write = (): void => {
    if (isScheduled) return;
    isScheduled = true;
    requestAnimationFrame(() => {
      isScheduled = false;
      output.textContent = kept.join('\n');
    });
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
      if (isPaused.checked) return;
      kept.unshift(echoText(connection.types.json(type, message)));
      drop();
      write();
    }, true);
  };
  const select = topicChooser(context, [], setting(settings, 'topic'), ends, listen);
  ends.add(() => stop());
  const element = h('div', { class: 'topic-echo' }, select,
    h('div', { class: 'row' }, isPaused, h('label', { for: isPaused.id }, 'Paused'), most, ' kept'), output);
  return { element, close: ends.end };
}
