/// All entities of the world as a tree, with a search.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, setChildren } from '../app/dom.ts';
import type { Entity, Kind } from '../connection/entities.ts';

const kSigns: Record<Kind, string> = {
  world: 'W', model: 'M', link: 'L', joint: 'J', visual: 'V', collision: 'C', sensor: 'S', light: '☀', actor: 'A',
};

/// Whether the name or kind of the entity, or of one below it, contains the words.
export function matches(entity: Entity, words: string): boolean {
  const own = `${entity.name} ${entity.kind}`.toLowerCase();
  return own.includes(words) || entity.children.some((child) => matches(child, words));
}

export function openEntityTree(context: Context): Panel {
  const { world, selection } = context;
  const ends = new Ends();
  const open = new Set<number>();
  const search = h('input', { type: 'search', placeholder: 'Search', 'aria-label': 'Search entities', class: 'wide' });
  const tree = h('ul', { class: 'tree', role: 'tree', 'aria-label': 'Entities' });
  const element = h('div', { class: 'entity-tree' }, search, tree);

  // items by entity id; they are kept when the world changes, and with them focus and clicks
  let items = new Map<number, HTMLElement>();
  let before = items;

  const item = (entity: Entity, words: string, level: number): HTMLElement => {
    const children = entity.children.filter((child) => words === '' || matches(child, words));
    const isOpen = words !== '' || open.has(entity.id);
    const row = before.get(entity.id) ?? h('li', { role: 'treeitem', 'data-id': entity.id },
      h('span', { class: 'row' }, h('span', { class: 'twist' }), h('span', { class: 'sign' }), h('span', { class: 'name' })));
    items.set(entity.id, row);
    const sign = row.querySelector<HTMLElement>('.sign')!;
    sign.dataset.sign = kSigns[entity.kind];
    row.querySelector('.name')!.textContent = entity.name;
    row.setAttribute('tabindex', '-1');
    row.setAttribute('aria-selected', String(selection.id === entity.id));
    row.setAttribute('aria-level', String(level));
    row.setAttribute('aria-label', `${entity.name} ${entity.kind}`);
    if (children.length > 0) row.setAttribute('aria-expanded', String(isOpen));
    else row.removeAttribute('aria-expanded');
    const group = row.querySelector(':scope > ul');
    if (children.length > 0 && isOpen) {
      const shown = group ?? row.appendChild(h('ul', { role: 'group' }));
      setChildren(shown, children.map((child) => item(child, words, level + 1)));
    } else {
      group?.remove();
    }
    return row;
  };
  const show = (): void => {
    const words = search.value.trim().toLowerCase();
    const roots = (world.entities.world?.children ?? []).filter((entity) => words === '' || matches(entity, words));
    const focused = (document.activeElement as HTMLElement | null)?.closest<HTMLElement>('.tree li');
    before = items;
    items = new Map();
    const shown = roots.map((entity) => item(entity, words, 1));
    const why = world.scene ? 'No entity has that name' : 'The world has no SceneBroadcaster';
    setChildren(tree, shown.length > 0 ? shown : [h('li', { role: 'treeitem', class: 'hint' }, why)]);
    const reached = tree.querySelector<HTMLElement>(`li[data-id="${selection.id}"]`) ?? tree.querySelector('li');
    reached?.setAttribute('tabindex', '0');
    // an element that is moved in the document loses the focus
    if (focused && document.activeElement !== focused) tree.querySelector<HTMLElement>(`li[data-id="${focused.dataset.id}"]`)?.focus();
  };
  const idOf = (event: Event): number | null => {
    const id = (event.target as HTMLElement).closest<HTMLElement>('li')?.dataset.id;
    return id === undefined ? null : Number(id);
  };
  const turn = (id: number, isOpen: boolean): void => {
    if (isOpen) open.add(id);
    else open.delete(id);
    show();
  };
  tree.addEventListener('click', (event) => {
    const id = idOf(event);
    if (id === null) return;
    if ((event.target as HTMLElement).classList.contains('twist')) turn(id, !open.has(id));
    else selection.set(id);
  });
  tree.addEventListener('dblclick', (event) => {
    const id = idOf(event);
    if (id !== null) context.view?.lookAt(id);
  });
  tree.addEventListener('keydown', (event) => {
    if (moveInTree(tree, event, (id, isOpen) => turn(id, isOpen))) event.preventDefault();
    else if (event.key === 'Enter' && idOf(event) !== null) selection.set(idOf(event));
  });
  search.addEventListener('input', show);
  const showSelected = (id: number | null): void => {
    for (let up = world.entities.get(id)?.parent; up; up = up.parent) open.add(up.id);
    show();
    tree.querySelector('[aria-selected="true"] .row')?.scrollIntoView({ block: 'nearest' });
  };
  ends.add(world.changed.on(show), selection.changed.on(showSelected));
  show();
  return { element, close: ends.end };
}

/// Moves in the tree by keys, as in ARIA's tree view pattern: up and down; right opens; left closes or moves to the
/// parent.
/// @return Whether the key was handled.
function moveInTree(tree: HTMLElement, event: KeyboardEvent, turn: (id: number, isOpen: boolean) => void): boolean {
  const item = (event.target as HTMLElement).closest<HTMLElement>('li');
  const items = [...tree.querySelectorAll<HTMLElement>('li[data-id]')];
  if (!item || !items.includes(item)) return false;
  const at = items.indexOf(item);
  const isOpen = item.getAttribute('aria-expanded');
  if (event.key === 'ArrowDown') items[at + 1]?.focus();
  else if (event.key === 'ArrowUp') items[at - 1]?.focus();
  else if (event.key === 'ArrowRight' && isOpen === 'false') turn(Number(item.dataset.id), true);
  else if (event.key === 'ArrowRight' && isOpen === 'true') items[at + 1]?.focus();
  else if (event.key === 'ArrowLeft' && isOpen === 'true') turn(Number(item.dataset.id), false);
  else if (event.key === 'ArrowLeft') item.parentElement?.closest<HTMLElement>('li')?.focus();
  else return false;
  return true;
}
