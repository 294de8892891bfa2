/// The page's interface for its panels.
import type { Connection } from '../connection/connection.ts';
import { Emitter } from '../connection/emitter.ts';
import type { World } from '../connection/world.ts';
import type { StreamedView, View } from '../view/index.ts';
import type { History } from './history.ts';
import type { MessageLog } from './message_log.ts';

/// The selected entity of the world.
export class Selection {
  id: number | null = null;
  readonly changed = new Emitter<number | null>();

  set(id: number | null): void {
    if (id === this.id) return;
    this.id = id;
    this.changed.emit(id);
  }
}

export interface Context {
  connection: Connection;
  world: World;
  /// Null if the browser has no 3D graphics.
  view: View | null;
  /// Shows pictures of the server instead; null if there is a view.
  stream: StreamedView | null;
  selection: Selection;
  /// What the user has changed.
  history: History;
  log: MessageLog;
  /// Opens a further panel with these settings.
  openPanel(id: string, settings: Record<string, string[]>): void;
  /// Lets the server draw the world, or the browser again: opens the page anew, with the same viewpoint and panels.
  drawByServer(isOn: boolean): void;
  /// Awaits `work`, and reports a failure to the user.
  /// @return Whether it succeeded.
  attempt(what: string, work: Promise<unknown>): Promise<boolean>;
  /// Lets the user choose a pose for a model or light in the view; null if cancelled, or if there is no view.
  /// @param hint What the user is told.
  choosePlace(message: Record<string, unknown>, hint?: string): Promise<import('../view/index.ts').Pose | null>;
}

/// The settings of a panel in a world's `<gui>`: the elements in its `<plugin>`.
export type Settings = Element | null;

export interface Panel {
  element: HTMLElement;
  /// Ends its subscriptions.
  close?(): void;
  /// Its current settings, with which it can be opened again.
  settings?(): Record<string, string[]>;
}

/// Where a panel opens.
export type Dock = 'left' | 'right' | 'bottom' | 'corner-left' | 'corner-right';

export interface PanelKind {
  /// Name of Fortress's plugin: "WorldControl".
  id: string;
  /// Further plugin names for the same panel.
  also?: string[];
  title: string;
  place: Dock;
  /// Whether several of them can be open.
  isMany?: boolean;
  /// Whether all that it does changes the world, so that read-only clients can't use it.
  isForWriting?: boolean;
  open(context: Context, settings: Settings): Panel;
}

/// Functions that are called when a panel is closed, to end its subscriptions.
export class Ends {
  private readonly all: (() => void)[] = [];
  add(...ends: (() => void)[]): void {
    this.all.push(...ends);
  }
  end = (): void => {
    for (const end of this.all.splice(0)) end();
  };
}

/// Settings with these elements, as a world's `<plugin>` would have them.
export function settingsOf(values: Record<string, string[]>): Settings {
  const document = new DOMParser().parseFromString('<plugin/>', 'application/xml');
  for (const [name, texts] of Object.entries(values)) {
    for (const text of texts) document.documentElement.appendChild(document.createElement(name)).textContent = text;
  }
  return document.documentElement;
}

/// The text of the first element with this name in a panel's settings; undefined if there is none or it is empty.
export function setting(settings: Settings, name: string): string | undefined {
  return settings?.querySelector(name)?.textContent?.trim() || undefined;
}
