/// Keyboard shortcuts, and the dialog that lists them.
import { copyChosen, paste, removeChosen, undo } from './actions.ts';
import { saveScreenshot } from './capture.ts';
import type { Context } from './context.ts';
import { h } from './dom.ts';
import { isTyping } from '../panels/key_publisher.ts';

interface Shortcut {
  /// "t", "Delete", "ctrl+c"
  keys: string;
  what: string;
  act(context: Context): void;
}

function lookAtSelection({ view, stream, selection, world }: Context): void {
  const { id } = selection;
  if (id === null) return;
  view?.lookAt(id);
  const pose = world.poses.get(id);
  if (pose) stream?.lookAt(pose[0]!, pose[1]!, pose[2]!);
}

export const kShortcuts: readonly Shortcut[] = [
  { keys: '?', what: 'This page', act: () => showHelp() },
  { keys: 'space', what: 'Play or pause', act: () => document.getElementById('play')?.click() },
  { keys: '.', what: 'Step', act: () => document.getElementById('step')?.click() },
  { keys: 'escape', what: 'Select, and cancel', act: ({ view }) => view?.setTool('select') },
  { keys: 't', what: 'Move the selected model', act: ({ view }) => view?.setTool('move') },
  { keys: 'r', what: 'Rotate it', act: ({ view }) => view?.setTool('turn') },
  { keys: 'f', what: 'Look at the selection', act: lookAtSelection },
  { keys: 'h', what: 'Reset the view', act: ({ view, stream }) => (view ?? stream)?.lookFrom('home') },
  { keys: 'm', what: 'Measure a distance', act: () => document.getElementById('measure')?.click() },
  { keys: 'delete', what: 'Remove the selected model or light', act: (context) => void removeChosen(context) },
  { keys: 'ctrl+z', what: 'Undo the last change of the world', act: (context) => void undo(context) },
  { keys: 'ctrl+shift+z', what: 'Redo it', act: (context) => void undo(context, true) },
  { keys: 'ctrl+c', what: 'Copy the selected model', act: copyChosen },
  { keys: 'ctrl+v', what: 'Paste it: click to place it', act: (context) => void paste(context) },
  { keys: 'p', what: 'Screenshot', act: (context) => void saveScreenshot(context) },
  { keys: '/', what: 'Search the entity tree', act: () => document.querySelector<HTMLElement>('.entity-tree input')?.focus() },
];

/// The notation of a key press that the list of shortcuts uses.
export function keysOf(event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>): string {
  const key = event.key === ' ' ? 'space' : event.key.toLowerCase();
  const isControl = event.ctrlKey || event.metaKey;
  // without Control, Shift is part of the character
  return `${isControl ? 'ctrl+' : ''}${event.altKey ? 'alt+' : ''}${isControl && event.shiftKey ? 'shift+' : ''}${key}`;
}

/// @param context Returns the context of the current world; null if there is none.
export function listenToShortcuts(context: () => Context | null): void {
  window.addEventListener('keydown', (event) => {
    const now = context();
    if (!now || event.defaultPrevented) return;
    // the other custom for redo
    const keys = keysOf(event).replace(/^ctrl\+y$/, 'ctrl+shift+z');
    const isUndo = /^ctrl\+(shift\+)?z$/.test(keys);
    // a value that has been entered is a change of the world
    const isEntered = isUndo && (event.target as HTMLElement).dataset?.entered !== undefined;
    if (!isEntered && isTyping(event.target, event.key)) return;
    // leaves Ctrl+C to the browser while text is selected
    if (keys === 'ctrl+c' && String(getSelection()) !== '') return;
    const shortcut = kShortcuts.find((each) => each.keys === keys);
    if (!shortcut) return;
    event.preventDefault();
    shortcut.act(now);
  });
}

export function showHelp(): void {
  const rows = kShortcuts.flatMap(({ keys, what }) => [h('dt', {}, h('kbd', {}, keys)), h('dd', {}, what)]);
  const dialog = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' },
    h('h2', { id: 'help-title' }, 'Keys'),
    h('dl', {}, ...rows),
    h('p', {}, 'While the Key publisher sends, all other keys go to the world.'),
    h('p', {}, 'View: the left button pans, the middle button or Shift with the left rotates, the wheel or the right button zooms; a click selects.'),
    h('form', { method: 'dialog' }, h('button', {}, 'Close')));
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}
