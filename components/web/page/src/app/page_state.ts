/// What the page shows: panels with their places, and the viewpoint. Saved for each world, and carried by the address.
import { parseSixfold, type Sixfold } from '../connection/poses.ts';
import type { Dock } from './context.ts';

export interface PanelState {
  /// `PanelKind.id`
  id: string;
  title: string;
  place: Dock;
  isFolded?: boolean;
  /// Elements of its settings, each with its texts.
  settings?: Record<string, string[]>;
}

export interface LayoutState {
  panels: PanelState[];
  /// Sizes of docks that the user has changed [px].
  sizes: Partial<Record<Dock, number>>;
  /// Docks that show their panels as tabs, and the number of the one that is shown.
  tabs?: Partial<Record<Dock, number>>;
}

export interface PageState {
  world?: string;
  view?: Sixfold;
  layout?: LayoutState;
  /// Whether the server shall draw the world although the browser could.
  isDrawnByServer?: boolean;
}

export const kDockPlaces: readonly Dock[] = ['left', 'right', 'bottom', 'corner-left', 'corner-right'];
/// Limits of the sizes of docks, and of what an address or a store may ask for.
export const kSmallest = 160;
export const kLargest = 2000;
const kMostPanels = 50;

/// @param address The fragment of an address: "#world=w&view=0,0,5,0,0.5,0&panels=..."; what is not understood is left out.
export function readAddress(address: string): PageState {
  const values = new URLSearchParams(address.replace(/^#/, ''));
  const view = parseSixfold((values.get('view') ?? '').replaceAll(',', ' '));
  const layout = parseLayout(values.get('panels') ?? '');
  return { ...(values.get('world') && { world: values.get('world')! }), ...(view && { view }), ...(layout && { layout }), ...(values.get('picture') === 'server' && { isDrawnByServer: true }) };
}

export function writeAddress({ world, view, layout, isDrawnByServer }: PageState): string {
  const values = new URLSearchParams();
  if (world) values.set('world', world);
  if (view) values.set('view', view.map((number) => String(Number(number.toFixed(3)))).join(','));
  if (isDrawnByServer) values.set('picture', 'server');
  if (layout) values.set('panels', JSON.stringify(layout));
  return `#${values}`;
}

/// @param text JSON of a LayoutState, from an address or a store, so it may be anything.
/// @return Null if it is none; panels that are not as they should be are left out.
export function parseLayout(text: string): LayoutState | null {
  let found: unknown;
  try {
    found = JSON.parse(text);
  } catch {
    return null;
  }
  const { panels, sizes, tabs } = (found ?? {}) as { panels?: unknown; sizes?: unknown; tabs?: unknown };
  if (!Array.isArray(panels)) return null;
  const result: LayoutState = { panels: panels.slice(0, kMostPanels).map(panelOf).filter((panel) => panel !== null), sizes: {} };
  for (const place of kDockPlaces) {
    const size = (sizes as Record<string, unknown> | undefined)?.[place];
    if (typeof size === 'number' && size >= kSmallest && size <= kLargest) result.sizes[place] = size;
    const shown = (tabs as Record<string, unknown> | undefined)?.[place];
    if (typeof shown === 'number' && shown >= 0 && shown < kMostPanels) (result.tabs ??= {})[place] = shown;
  }
  return result;
}

function panelOf(found: unknown): PanelState | null {
  const { id, title, place, isFolded, settings } = (found ?? {}) as Record<string, unknown>;
  if (typeof id !== 'string' || typeof title !== 'string' || !kDockPlaces.includes(place as Dock)) return null;
  const entries = Object.entries((settings ?? {}) as Record<string, unknown>).filter(([name, texts]) =>
    /^\w+$/.test(name) && Array.isArray(texts) && texts.every((text) => typeof text === 'string'));
  return {
    id, title: title.slice(0, 100), place: place as Dock,
    ...(isFolded === true && { isFolded }),
    ...(entries.length > 0 && { settings: Object.fromEntries(entries) as Record<string, string[]> }),
  };
}

const keyOf = (world: string): string => `pongsim-layout ${world}`;

/// The saved layout of a world; null if there is none, or the browser allows no storage.
export function savedLayout(world: string): LayoutState | null {
  try {
    return parseLayout(localStorage.getItem(keyOf(world)) ?? '');
  } catch {
    return null;
  }
}

/// @param layout Null: forgets it.
export function saveLayout(world: string, layout: LayoutState | null): void {
  try {
    if (layout) localStorage.setItem(keyOf(world), JSON.stringify(layout));
    else localStorage.removeItem(keyOf(world));
  } catch {
    // the browser does not allow storage
  }
}
