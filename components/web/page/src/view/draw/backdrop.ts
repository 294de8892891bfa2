import { Color } from 'three';

import type { Theme } from '../overlays/grid.ts';
import type { SkyColors } from './sky.ts';

/// Fortress's background, which most worlds leave as it is.
const usual = [0.7, 0.7, 0.7];

/// The background of a theme: brighter at the horizon, so that up is visible.
export function backdropOf(theme: Theme): SkyColors {
  return theme === 'dark'
    ? { zenith: new Color(0x131c25), horizon: new Color(0x43525f) }
    : { zenith: new Color(0xb9cddd), horizon: new Color(0xf1f5f8) };
}

/// Whether the world has not chosen a background.
export function isUsual(rgb: readonly number[]): boolean {
  return rgb.every((value, i) => Math.abs(value - usual[i]!) < 2e-3);
}
