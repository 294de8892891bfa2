/// Publishes keys that are pressed anywhere in the page, like Fortress's Key Publisher: Qt's key code as an Int32 on
/// /keyboard/keypress.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, labelled } from '../app/dom.ts';
import { fullTopic } from '../connection/topic_name.ts';

const kNamed: Record<string, number> = {
  Escape: 0x01000000, Tab: 0x01000001, Backspace: 0x01000003, Enter: 0x01000004, Insert: 0x01000006, Delete: 0x01000007,
  Home: 0x01000010, End: 0x01000011, ArrowLeft: 0x01000012, ArrowUp: 0x01000013, ArrowRight: 0x01000014,
  ArrowDown: 0x01000015, PageUp: 0x01000016, PageDown: 0x01000017, Shift: 0x01000020, Control: 0x01000021,
  Meta: 0x01000022, Alt: 0x01000023,
};

/// @param key `KeyboardEvent.key`.
/// @return Qt's key code; undefined if there is none.
export function keyNumber(key: string): number | undefined {
  const functionKey = /^F(\d{1,2})$/.exec(key);
  if (functionKey) return 0x01000030 + Number(functionKey[1]) - 1;
  // Qt's code of a letter is that of the capital
  return [...key].length === 1 ? key.toUpperCase().codePointAt(0) : kNamed[key];
}

/// Whether the focused element uses the key, so that it is not published.
export function isTyping(target: EventTarget | null, key: string): boolean {
  const element = target as HTMLElement | null;
  if (!element?.closest) return false;
  if (element.closest('textarea, select, [contenteditable], dialog[open]')) return true;
  if (element.closest('[role="tree"]')) return key.startsWith('Arrow') || key === 'Enter';
  const input = element.closest('input');
  if (input) return !['checkbox', 'radio', 'button'].includes(input.type) || key === ' ';
  return element.closest('button, summary, a') !== null && (key === ' ' || key === 'Enter');
}

export function openKeyPublisher(context: Context, settings: Settings): Panel {
  const { connection, log } = context;
  const ends = new Ends();
  const topic = h('input', { value: fullTopic(setting(settings, 'topic') ?? '/keyboard/keypress'), class: 'wide' });
  const isOn = h('input', { type: 'checkbox', checked: true, id: 'send-keys' });
  const last = h('output', { class: 'last-key', 'aria-live': 'off' }, '–');
  const press = (event: KeyboardEvent): void => {
    if (!isOn.checked || event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target, event.key)) return;
    const number = keyNumber(event.key);
    // leaves the keys for navigation and for the page's help to the browser
    if (number === undefined || event.key === 'Tab' || event.key === '?') return;
    event.preventDefault();
    event.stopImmediatePropagation();
    try {
      connection.publish(topic.value, 'ignition.msgs.Int32', { data: number });
      last.textContent = `${event.key} (${number})`;
    } catch (fault) {
      log.add('error', `Key Publisher: ${(fault as Error).message}`);
    }
  };
  // capture: called before the page's shortcuts
  window.addEventListener('keydown', press, { capture: true });
  ends.add(() => window.removeEventListener('keydown', press, { capture: true }));
  const element = h('div', { class: 'key-publisher' },
    h('div', { class: 'row' }, isOn, h('label', { for: 'send-keys' }, 'Send keys pressed in the page')),
    labelled('Topic', topic),
    h('p', {}, 'Last key: ', last));
  return { element, close: ends.end, settings: () => ({ topic: [topic.value] }) };
}
