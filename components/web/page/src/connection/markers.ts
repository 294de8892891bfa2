/// The markers of a world: shapes that programs add to what people see. See docs/sensors.md.
import type { Connection } from './connection.ts';
import type { Message } from './types.ts';

const kList = '/marker/list';
const kChanges = '/marker';

/// ignition.msgs.Marker.Action
const kDelete = 1;
const kDeleteAll = 2;

/// The world whose markers they are: the services have the same names in all worlds.
function worldOf(message: Message): string | undefined {
  const data = (message['header']?.data ?? []) as { key?: string; value?: string[] }[];
  return data.find(({ key }) => key === 'world')?.value?.[0];
}

function keyOf(marker: Message): string {
  return `${marker['ns'] ?? ''}\n${marker['id'] ?? 0}`;
}

/// What the keys of a name space begin with; DELETE_ALL without a name space is for all.
function beginningOf(space: string): string {
  return space === '' ? '' : `${space}\n`;
}

export class MarkerFeed {
  private readonly all = new Map<string, Message>();
  private readonly ends: (() => void)[] = [];
  private isAsked = false;
  private isScheduled = false;
  private isEnded = false;
  /// While the list is awaited: keys, and beginnings of keys, that have changed since it was asked for.
  private changed: Set<string> | null = null;

  /// @param show Called with all markers, by their name spaces and numbers, in the next animation frame after changes.
  constructor(
    private readonly connection: Connection,
    private readonly world: string,
    private readonly show: (markers: ReadonlyMap<string, Message>) => void,
  ) {
    this.ends.push(
      connection.subscribe(kChanges, (change) => this.apply(change), true),
      connection.servicesChanged.on(() => void this.ask()),
      connection.stateChanged.on((state) => {
        if (state !== 'lost') return;
        this.isAsked = false;
        this.changed = null;
        this.all.clear();
        this.showLater();
      }),
    );
    void this.ask();
  }

  end(): void {
    this.isEnded = true;
    this.changed = null;
    for (const end of this.ends.splice(0)) end();
  }

  private async ask(): Promise<void> {
    if (this.isAsked || !this.connection.services.has(kList)) return;
    this.isAsked = true;
    const changed = new Set<string>();
    this.changed = changed;
    // if this fails or the connection breaks, it is asked again when services change
    const list = await this.connection.call(kList).catch(() => null);
    if (this.changed !== changed) return;
    this.changed = null;
    this.isAsked = list !== null;
    if (list === null || worldOf(list) !== this.world) return;
    for (const marker of (list['marker'] ?? []) as Message[]) {
      // changes may overtake the list, which is then older than they are
      const names = ['', beginningOf((marker['ns'] ?? '') as string), keyOf(marker)];
      if (!names.some((name) => changed.has(name))) this.all.set(keyOf(marker), marker);
    }
    this.showLater();
  }

  /// Many markers may change between two frames.
  private showLater(): void {
    if (this.isScheduled) return;
    this.isScheduled = true;
    this.connection.nextAnimationFrame(() => {
      this.isScheduled = false;
      if (!this.isEnded) this.show(this.all);
    });
  }

  /// @param change An ignition.msgs.Marker with all its fields.
  private apply(change: Message): void {
    if (worldOf(change) !== this.world) return;
    const isAll = change['action'] === kDeleteAll;
    const name = isAll ? beginningOf((change['ns'] ?? '') as string) : keyOf(change);
    this.changed?.add(name);
    if (isAll) {
      for (const key of [...this.all.keys()]) if (key.startsWith(name)) this.all.delete(key);
    } else if (change['action'] === kDelete) {
      this.all.delete(name);
    } else {
      this.all.set(name, change);
    }
    this.showLater();
  }
}
