/// Viewpoints with names, kept by the browser for each world.
import { parseSixfold, type Sixfold } from '../connection/poses.ts';

export interface SavedView {
  name: string;
  pose: Sixfold;
}

const kMostViews = 50;
const keyOf = (world: string): string => `pongsim-views ${world}`;

/// @param text From the browser's storage, so it may be anything.
export function parseViews(text: string): SavedView[] {
  let found: unknown;
  try {
    found = JSON.parse(text);
  } catch {
    return [];
  }
  if (!Array.isArray(found)) return [];
  return found.slice(0, kMostViews).flatMap((each: unknown) => {
    const { name, pose } = (each ?? {}) as { name?: unknown; pose?: unknown };
    const numbers = Array.isArray(pose) ? parseSixfold(pose.join(' ')) : null;
    return typeof name === 'string' && name !== '' && numbers ? [{ name: name.slice(0, 60), pose: numbers }] : [];
  });
}

/// The views with another one, which replaces that of the same name.
export function withView(views: readonly SavedView[], view: SavedView): SavedView[] {
  return [...views.filter(({ name }) => name !== view.name), view].slice(-kMostViews);
}

export function savedViews(world: string): SavedView[] {
  try {
    return parseViews(localStorage.getItem(keyOf(world)) ?? '');
  } catch {
    return [];
  }
}

export function saveViews(world: string, views: readonly SavedView[]): void {
  try {
    localStorage.setItem(keyOf(world), JSON.stringify(views));
  } catch {
    // the browser does not allow storage
  }
}
