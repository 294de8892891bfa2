/// What a panel may use.
import type { Connection } from '../connection/connection.ts';
import { Emitter } from '../connection/emitter.ts';
import type { World } from '../connection/world.ts';
import type { View } from '../view/index.ts';
import type { MessageLog } from './message_log.ts';

/// Which entity of the world is chosen.
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
  /// Null where the browser draws no 3D.
  view: View | null;
  selection: Selection;
  log: MessageLog;
  /// Tells the user, where it fails, why.
  attempt(what: string, work: Promise<unknown>): Promise<boolean>;
  /// Lets the user choose a place for a model or light; null: given up, or there is no view to choose in.
  choosePlace(message: Record<string, unknown>): Promise<import('../view/index.ts').Pose | null>;
}

/// What `<gui>` of a world says of a panel: the elements in its `<plugin>`.
export type Settings = Element | null;

export interface Panel {
  element: HTMLElement;
  /// Ends what it listens to.
  close?(): void;
}

/// Where a panel opens.
export type Place = 'left' | 'right' | 'bottom' | 'corner-left' | 'corner-right';

export interface PanelKind {
  /// As Fortress's plugin is called: "WorldControl".
  id: string;
  /// More names of plugins that stand for the same.
  also?: string[];
  title: string;
  place: Place;
  open(context: Context, settings: Settings): Panel;
}

/// Collects what has to be ended when a panel is closed.
export class Ends {
  private readonly all: (() => void)[] = [];
  add(...ends: (() => void)[]): void {
    this.all.push(...ends);
  }
  end = (): void => {
    for (const end of this.all.splice(0)) end();
  };
}

/// The text of an element in a panel's settings.
export function setting(settings: Settings, name: string): string | undefined {
  return settings?.querySelector(name)?.textContent?.trim() || undefined;
}
