/// A list to select a topic of certain types.
import type { Context, Ends } from '../app/context.ts';
import { h, setChoices } from '../app/dom.ts';
import { fullTopic } from '../connection/topic_name.ts';

/// The server's topics with one of these types; all topics if no types are given.
export function topicsOf(context: Context, types: readonly string[]): string[] {
  return [...context.connection.channels.values()]
    .filter(({ encoding, schemaName }) => encoding === 'protobuf' && (types.length === 0 || types.includes(schemaName)))
    .map(({ topic }) => topic)
    .sort();
}

/// A list of these topics that is updated when topics are advertised or end.
/// @param wanted Selected until the user chooses another, also before it exists: no other topic takes its place.
/// @param chosen Called with the selected topic, '' for none.
export function topicChooser(
  context: Context, types: readonly string[], wanted: string | undefined, ends: Ends, chosen: (topic: string) => void,
): HTMLSelectElement {
  const select = h('select', { 'aria-label': 'Topic', class: 'wide' });
  let current = fullTopic(wanted ?? '');
  let isNew = current !== '';
  const update = (): void => {
    const topics = topicsOf(context, types);
    if (current && !topics.includes(current)) topics.push(current);
    setChoices(select, topics, types.length === 0 ? 'Choose a topic' : undefined);
    if (isNew) {
      isNew = false;
      select.value = current;
      chosen(current);
    }
    if (select.value === current) return;
    current = select.value;
    chosen(current);
  };
  if (current) select.dataset.chosen = 'yes';
  select.addEventListener('change', () => {
    select.dataset.chosen = 'yes';
    update();
  });
  ends.add(context.connection.channelsChanged.on(update));
  // after the caller has finished the panel, because it calls `chosen`
  queueMicrotask(update);
  return select;
}

/// The settings of a panel with this list: its topic, if the user or the world has chosen it.
/// @param name Of the element.
export function topicSetting(select: HTMLSelectElement, name = 'topic'): Record<string, string[]> {
  return select.dataset.chosen ? { [name]: [select.value] } : {};
}
