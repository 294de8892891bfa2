/// The toolbar: world, connection, tools, shapes, screenshots, panels.
import { kShapeNames } from '../panels/shapes.ts';
import { spawnShape } from '../panels/spawn.ts';
import type { Tool } from '../view/index.ts';
import { copyAsSdf, removeChosen, undo } from './actions.ts';
import { saveScreenshot, toggleVideo } from './capture.ts';
import type { Context, Ends } from './context.ts';
import { h, iconButton } from './dom.ts';
import { icon, type Icon } from './icons.ts';
import { measure } from './measure.ts';
import type { Layout } from './layout.ts';
import { kPanels } from './registry.ts';
import { showHelp } from './shortcuts.ts';
import { currentTheme, setTheme } from './theme.ts';

/// The name of a menu's item, and what it does.
type Item = [name: string, act: () => void];

/// A button that opens a menu.
/// @param items Its items, or a function that returns them when it opens; those without a function are not available.
function menu(title: string, items: Item[] | (() => [name: string, act: (() => void) | null][])): HTMLElement {
  const summary = h('summary', {}, `${title} ▾`);
  const details = h('details', { class: 'menu' }, summary);
  const choose = (act: () => void, event: MouseEvent): void => {
    details.open = false;
    // chosen by a key: the button with the focus is hidden now
    if (event.detail === 0) summary.focus();
    act();
  };
  const button = ([name, act]: [string, (() => void) | null]): HTMLElement =>
    h('button', { type: 'button', disabled: !act, onclick: (event: MouseEvent) => act && choose(act, event) }, name);
  const list = h('div', { class: 'items' });
  details.append(list);
  // before it opens, so that the next key finds the items
  if (typeof items === 'function') summary.addEventListener('click', () => list.replaceChildren(...items().map(button)));
  else list.append(...items.map(button));
  details.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !details.open) return;
    event.stopPropagation();
    details.open = false;
    summary.focus();
  });
  details.addEventListener('focusout', (event) => {
    if (event.relatedTarget && !details.contains(event.relatedTarget as Node)) details.open = false;
  });
  return details;
}

/// @param ends Gets what ends with the world.
/// @param shell What is called when the user has selected another theme, and to return to the world's own panels.
export function toolbar(context: Context, layout: Layout, ends: Ends, shell: { themed(): void; resetLayout(): void }): HTMLElement {
  const { view, history, connection } = context;
  const tools: [Tool & Icon, string][] = [['select', 'Select'], ['move', 'Move'], ['turn', 'Turn']];
  const toolButtons = tools.map(([tool, name]) => iconButton(icon(tool), name, () => view?.setTool(tool), { disabled: !view, 'data-tool': tool }));
  const showAccess = (): void => {
    for (const button of toolButtons.slice(1)) button.disabled = !view || connection.isReadOnly;
  };
  ends.add(connection.infoReceived.on(showAccess));
  showAccess();
  let isFilming = false;
  const film = iconButton(icon('film'), 'Record a video', async () => {
    isFilming = await toggleVideo(context, isFilming);
    film.classList.toggle('on', isFilming);
    film.title = isFilming ? 'Stop recording' : 'Record a video';
    film.setAttribute('aria-label', film.title);
  }, { disabled: !view });
  const openPanel = (id: string): void => {
    const kind = kPanels.find((each) => each.id === id)!;
    if (kind.isMany || !layout.has(kind)) layout.add(kind, context);
    layout.reveal(kind);
  };
  return h('div', { class: 'tools', role: 'toolbar', 'aria-label': 'Tools' },
    ...toolButtons,
    iconButton(icon('ruler'), 'Measure', () => void measure(context, layout.stage), { disabled: !view, id: 'measure' }),
    menu('Add', () => kShapeNames.map((shape) => [shape, connection.isReadOnly ? null : () => void spawnShape(context, shape)])),
    menu('Edit', () => [
      [`Undo ${history.nextUndo ?? ''}`.trim(), history.nextUndo ? () => void undo(context) : null],
      [`Redo ${history.nextRedo ?? ''}`.trim(), history.nextRedo ? () => void undo(context, true) : null],
      ['Copy as SDF', () => void copyAsSdf(context)],
      ['Remove', connection.isReadOnly ? null : () => void removeChosen(context)],
    ]),
    iconButton(icon('camera'), 'Screenshot', () => void saveScreenshot(context)),
    film,
    menu('Panels', [...kPanels.map(({ id, title }): Item => [title, () => openPanel(id)]), ['As the world asks for', () => shell.resetLayout()]]),
    iconButton(icon('theme'), 'Dark or light', () => {
      setTheme(currentTheme() === 'dark' ? 'light' : 'dark');
      shell.themed();
    }),
    iconButton('?', 'Keys', showHelp));
}
