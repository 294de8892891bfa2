/// The page: connects to the server from which it was loaded, and shows one of its worlds.
import { Connection, type Socket } from '../connection/connection.ts';
import { MessageTypes } from '../connection/types.ts';
import { worldNames } from '../connection/world.ts';
import { spawnFiles } from '../panels/spawn.ts';
import { h, setChoices } from './dom.ts';
import { MessageLog } from './message_log.ts';
import { readAddress } from './page_state.ts';
import { Shell } from './shell.ts';
import { listenToShortcuts } from './shortcuts.ts';
import { currentTheme } from './theme.ts';
import { TokenForm } from './token_form.ts';

const log = new MessageLog();
const types = new MessageTypes();
let shell: Shell | null = null;

const worlds = h('select', { 'aria-label': 'World', hidden: true });
const title = h('h1', {}, 'pongsim');
const state = h('span', { class: 'state', role: 'status' }, 'connecting');
const tools = h('div', { class: 'tools-place' });
const place = h('div', { class: 'world-place' });
const toast = h('div', { class: 'toast', role: 'alert', hidden: true });

const tokenForm = new TokenForm();

/// The token for servers that are open to other machines: a parameter of the page's address, and of its requests.
function tokenQuery(): string {
  const token = new URLSearchParams(location.search).get('token');
  return token ? `?token=${encodeURIComponent(token)}` : '';
}

function socketAddress(): string {
  return `${location.protocol === 'https:' ? 'wss' : 'ws'}://${location.host}/${tokenQuery()}`;
}

async function loadTypes(): Promise<void> {
  const answer = await fetch('message_types.bin');
  if (!answer.ok) throw new Error(`the message types are missing (${answer.status})`);
  types.add(new Uint8Array(await answer.arrayBuffer()));
}

function show(name: string): void {
  if (shell?.context.world.name === name) return;
  shell?.end();
  shell = new Shell(connection, name, log);
  title.textContent = name;
  document.title = `${name} · pongsim`;
  tools.replaceChildren(shell.tools);
  place.replaceChildren(shell.layout.element);
}

function showWorlds(): void {
  const names = worldNames(connection.services.keys());
  if (names.length === 0) return;
  const isFirst = worlds.options.length === 0;
  setChoices(worlds, names);
  const { world } = readAddress(location.hash);
  if (isFirst && world && names.includes(world)) worlds.value = world;
  worlds.hidden = names.length < 2;
  title.hidden = names.length > 1;
  show(worlds.value);
}

function showState(): void {
  const { state: now, isReadOnly } = connection;
  const words = { connecting: 'connecting', open: isReadOnly ? 'connected, read-only' : 'connected', lost: 'connection lost, reconnecting' };
  state.textContent = words[now];
  state.dataset.state = now;
}

/// foxglove.Log.Level
const kLogError = 4;
let toastTimer: ReturnType<typeof setTimeout> | undefined;
function showToast(level: string, text: string): void {
  toast.textContent = text;
  toast.className = `toast ${level}`;
  toast.hidden = false;
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => (toast.hidden = true), 6000);
}

document.documentElement.dataset.theme = currentTheme();
document.body.append(h('header', { class: 'bar' }, title, worlds, state, tools), h('main', {}, tokenForm.element, place), toast);
log.changed.on(({ level, text, isQuiet }) => {
  if (!isQuiet) showToast(level, text);
});
const loaded = loadTypes().catch((fault: Error) => log.add('error', fault.message));
await loaded;
const connection = new Connection(types, {
  connect: () => new WebSocket(socketAddress(), 'pongsim.web.v1') as unknown as Socket,
  nextAnimationFrame: (callback) => void requestAnimationFrame(callback),
  later: (callback, ms) => void setTimeout(callback, ms),
});
let before = connection.state;
connection.stateChanged.on((now) => {
  showState();
  if (now === 'open') tokenForm.hide();
  // the server has not let the page in
  if (now === 'lost' && before === 'connecting') void tokenForm.check(tokenQuery());
  before = now;
  if (now === 'lost' && connection.reason) log.add('error', connection.reason);
});
connection.servicesChanged.on(showWorlds);
connection.infoReceived.on(showState);
connection.statusReceived.on(({ level, message }) => log.add((['info', 'warning', 'error'] as const)[level] ?? 'error', message));
// the server sends its last messages again on a reconnection
let warnedNs = 0n;
connection.subscribe('/foxglove/log', ({ level, name, message }, timeNs) => {
  if (timeNs <= warnedNs) return;
  warnedNs = timeNs;
  log.add(level >= kLogError ? 'error' : 'warning', `${name}: ${message}`, true);
}, true);
worlds.addEventListener('change', () => show(worlds.value));
listenToShortcuts(() => shell?.context ?? null);

// removes the focus after a mouse click, so that keys are sent to the world; after keyboard activation it stays
document.addEventListener('click', ({ detail, target }) => {
  if (detail > 0) (target as Element).closest<HTMLElement>('button, [role="treeitem"]')?.blur();
});

// the same after a choice in a list by mouse
let isByMouse = false;
document.addEventListener('pointerdown', () => (isByMouse = true), { capture: true });
document.addEventListener('keydown', () => (isByMouse = false), { capture: true });
document.addEventListener('change', ({ target }) => {
  if (isByMouse && target instanceof HTMLSelectElement) target.blur();
});

// files with models can be dropped anywhere on the page
window.addEventListener('dragover', (event) => event.preventDefault());
window.addEventListener('drop', (event) => {
  event.preventDefault();
  if (shell && event.dataTransfer) void spawnFiles(shell.context, event.dataTransfer.files);
});
