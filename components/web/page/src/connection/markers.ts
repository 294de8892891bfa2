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

export class MarkerFeed {
  private readonly all = new Map<string, Message>();
  private readonly ends: (() => void)[] = [];
  private isAsked = false;

  /// @param show Called with all markers after each change, by their name spaces and numbers.
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
        this.all.clear();
        this.show(this.all);
      }),
    );
    void this.ask();
  }

  end(): void {
    for (const end of this.ends.splice(0)) end();
  }

  private async ask(): Promise<void> {
    if (this.isAsked || !this.connection.services.has(kList)) return;
    this.isAsked = true;
    // if the connection breaks, it is asked again when there is another
    const list = await this.connection.call(kList).catch(() => null);
    if (list === null || worldOf(list) !== this.world) return;
    for (const marker of (list['marker'] ?? []) as Message[]) this.put(marker);
    this.show(this.all);
  }

  private put(marker: Message): void {
    this.all.set(`${marker['ns'] ?? ''}\n${marker['id'] ?? 0}`, marker);
  }

  /// @param change An ignition.msgs.Marker with all its fields.
  private apply(change: Message): void {
    if (worldOf(change) !== this.world) return;
    const space = (change['ns'] ?? '') as string;
    if (change['action'] === kDelete) {
      this.all.delete(`${space}\n${change['id'] ?? 0}`);
    } else if (change['action'] === kDeleteAll) {
      for (const key of [...this.all.keys()]) if (space === '' || key.startsWith(`${space}\n`)) this.all.delete(key);
    } else {
      this.put(change);
    }
    this.show(this.all);
  }
}
