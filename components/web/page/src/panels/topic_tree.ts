/// All topics of the world as a tree, with a search; each opens in the panel that suits its type.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';

export interface Topic {
  topic: string;
  /// Full name of its message type.
  type: string;
}

export interface TopicNode {
  /// "world/shapes": without the part of the nodes above.
  name: string;
  topic?: Topic;
  children: TopicNode[];
}

/// The topics by the parts of their names. Nodes with a single child are one with it.
/// @param words Only topics whose name or type contains all of them.
export function topicTree(topics: readonly Topic[], words: string): TopicNode[] {
  const wanted = words.toLowerCase().split(/\s+/).filter((word) => word !== '');
  const root: TopicNode = { name: '', children: [] };
  for (const topic of [...topics].sort((a, b) => a.topic.localeCompare(b.topic))) {
    const text = `${topic.topic} ${topic.type}`.toLowerCase();
    if (!wanted.every((word) => text.includes(word))) continue;
    let node = root;
    for (const name of topic.topic.split('/').filter((part) => part !== '')) {
      let child = node.children.find((each) => each.name === name);
      if (!child) node.children.push((child = { name, children: [] }));
      node = child;
    }
    node.topic = topic;
  }
  return root.children.map(joined);
}

function joined(node: TopicNode): TopicNode {
  const [only] = node.children;
  if (!node.topic && node.children.length === 1) return joined({ ...only!, name: `${node.name}/${only!.name}` });
  return { ...node, children: node.children.map(joined) };
}

const kPanelOfType: Record<string, string> = {
  'ignition.msgs.Image': 'ImageDisplay', 'ignition.msgs.LaserScan': 'VisualizeLidar', 'ignition.msgs.PointCloudPacked': 'PointCloud',
};

/// The panel that shows messages of a type.
export function panelOfType(type: string): string {
  return kPanelOfType[type] ?? 'TopicEcho';
}

export function openTopicTree(context: Context): Panel {
  const { connection } = context;
  const ends = new Ends();
  const open = new Set<string>();
  const search = h('input', { type: 'search', placeholder: 'Search', 'aria-label': 'Search topics', class: 'wide' });
  const list = h('ul', { class: 'topics', 'aria-label': 'Topics' });
  const leaf = ({ name, topic }: TopicNode): HTMLElement => h('span', { class: 'row wrap' },
    h('button', { type: 'button', class: 'link', title: `Show ${topic!.topic}`, onclick: () => context.openPanel(panelOfType(topic!.type), { topic: [topic!.topic] }) }, name),
    h('span', { class: 'hint' }, topic!.type.replace(/^ignition\.msgs\./, '')));
  const item = (node: TopicNode, path: string, isSearch: boolean): HTMLElement => {
    if (node.children.length === 0) return h('li', {}, leaf(node));
    const here = `${path}/${node.name}`;
    const details = h('details', { open: isSearch || open.has(here) }, h('summary', {}, node.name),
      node.topic && leaf({ ...node, name: `/${node.name}` }), h('ul', {}, ...node.children.map((child) => item(child, here, isSearch))));
    details.addEventListener('toggle', () => {
      if (details.open) open.add(here);
      else open.delete(here);
    });
    return h('li', {}, details);
  };
  let shown = '';
  const show = (): void => {
    const topics = [...connection.channels.values()].filter(({ encoding }) => encoding === 'protobuf')
      .map(({ topic, schemaName }) => ({ topic, type: schemaName }));
    const words = search.value.trim();
    const nodes = topicTree(topics, words);
    // new elements would lose the focus
    const now = JSON.stringify([words, nodes]);
    if (now === shown) return;
    shown = now;
    list.replaceChildren(...nodes.map((node) => item(node, '', words !== '')));
    if (nodes.length === 0) list.append(h('li', { class: 'hint' }, topics.length > 0 ? 'No topic has that name or type' : 'The world has no topics'));
  };
  search.addEventListener('input', show);
  ends.add(connection.channelsChanged.on(show));
  show();
  return { element: h('div', { class: 'topic-tree' }, search, list), close: ends.end };
}
