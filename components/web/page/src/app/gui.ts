/// The `<gui>` of a world: an ignition.msgs.GUI converted to panels and their places.
import type { Message } from '../connection/types.ts';
import { parseSixfold, type Sixfold } from '../connection/poses.ts';
import { setting, type PanelKind, type Place, type Settings } from './context.ts';
import { panelFor } from './registry.ts';

export interface Wanted {
  kind: PanelKind;
  title: string;
  place: Place;
  settings: Settings;
}

export interface GuiWishes {
  panels: Wanted[];
  /// The initial viewpoint.
  camera: Sixfold | null;
}

/// The default panels, as in Fortress's own settings.
const kDefaults = ['WorldControl', 'WorldStats', 'EntityTree', 'ComponentInspector'];
/// Plugins that are part of the view.
const kScenes = ['MinimalScene', 'GzScene3D', 'Scene3D'];

/// Place of a panel that Fortress's window docks, or floats at a corner of the view.
export function placeFor(usual: Place, state: string | undefined, anchors: readonly string[]): Place {
  if (state !== 'floating') return usual.startsWith('corner') && state?.startsWith('docked') ? 'right' : usual;
  if (!usual.startsWith('corner')) return usual;
  return anchors.includes('right') ? 'corner-right' : anchors.includes('left') ? 'corner-left' : usual;
}

export function wishesOf(gui: Message | null): GuiWishes {
  const plugins = (gui?.plugin ?? []) as Message[];
  if (plugins.length === 0) {
    const panels = kDefaults.map((id) => panelFor(id)!).map((kind) => ({ kind, title: kind.title, place: kind.place, settings: null }));
    return { panels, camera: null };
  }
  const wishes: GuiWishes = { panels: [], camera: null };
  for (const plugin of plugins) {
    const settings = parsed(plugin.innerxml as string);
    if (kScenes.includes(plugin.filename as string)) wishes.camera = parseSixfold(setting(settings, 'camera_pose') ?? '');
    const kind = panelFor(plugin.filename as string);
    if (kind && (kind.id !== 'ViewAngle' || !wishes.panels.some((each) => each.kind === kind))) wishes.panels.push(wanted(kind, settings));
  }
  return wishes;
}

function wanted(kind: PanelKind, settings: Settings): Wanted {
  const look = settings?.querySelector('ignition-gui, gz-gui');
  const property = (key: string): string | undefined => look?.querySelector(`property[key="${key}"]`)?.textContent?.trim();
  const anchors = [...(look?.querySelectorAll('anchors line') ?? [])].map((line) => line.getAttribute('own') ?? '');
  const title = look?.querySelector('title')?.textContent?.trim() || kind.title;
  return { kind, title, place: placeFor(kind.place, property('state'), anchors), settings };
}

function parsed(innerxml: string): Settings {
  const document = new DOMParser().parseFromString(`<plugin>${innerxml}</plugin>`, 'application/xml');
  return document.querySelector('parsererror') ? null : document.documentElement;
}
