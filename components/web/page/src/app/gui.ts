/// The `<gui>` of a world: an ignition.msgs.GUI converted to panels and their places.
import type { Message } from '../connection/types.ts';
import { parseSixfold, type Sixfold } from '../connection/poses.ts';
import { setting, type PanelKind, type Dock, type Settings } from './context.ts';
import { panelFor } from './registry.ts';

export interface WantedPanel {
  kind: PanelKind;
  title: string;
  place: Dock;
  settings: Settings;
}

export interface GuiSettings {
  panels: WantedPanel[];
  /// The initial viewpoint.
  camera: Sixfold | null;
}

/// The panels of a world without `<gui>`, as in Fortress's default configuration.
const kDefaults = ['WorldControl', 'WorldStats', 'EntityTree', 'ComponentInspector'];
/// Plugins whose function the view has.
const kScenes = ['MinimalScene', 'GzScene3D', 'Scene3D'];

/// The dock for a panel: a corner if Fortress's window floats it, with these anchors, in that corner of the view.
export function placeFor(usual: Dock, state: string | undefined, anchors: readonly string[]): Dock {
  if (state !== 'floating') return usual.startsWith('corner') && state?.startsWith('docked') ? 'right' : usual;
  if (!usual.startsWith('corner')) return usual;
  return anchors.includes('right') ? 'corner-right' : anchors.includes('left') ? 'corner-left' : usual;
}

export function guiSettingsOf(message: Message | null): GuiSettings {
  const plugins = (message?.plugin ?? []) as Message[];
  if (plugins.length === 0) {
    const panels = kDefaults.map((id) => panelFor(id)!).map((kind) => ({ kind, title: kind.title, place: kind.place, settings: null }));
    return { panels, camera: null };
  }
  const gui: GuiSettings = { panels: [], camera: null };
  for (const plugin of plugins) {
    const settings = parsed(plugin.innerxml as string);
    if (kScenes.includes(plugin.filename as string)) gui.camera = parseSixfold(setting(settings, 'camera_pose') ?? '');
    const kind = panelFor(plugin.filename as string);
    // several of Fortress's plugins may be one panel here
    if (kind && (kind.isMany || !gui.panels.some((each) => each.kind === kind))) gui.panels.push(wanted(kind, settings));
  }
  return gui;
}

function wanted(kind: PanelKind, settings: Settings): WantedPanel {
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
