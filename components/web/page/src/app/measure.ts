/// Measures distances in the view.
import type { Context } from './context.ts';
import { h, iconButton } from './dom.ts';

type Point = [x: number, y: number, z: number];

/// "2.500 m (x 2.000, y -1.500, z 0.000)"
export function distanceText(from: Point, to: Point): string {
  const along = to.map((value, i) => value - from[i]!);
  const parts = along.map((value, i) => `${'xyz'[i]} ${value.toFixed(3)}`.replace('-0.000', '0.000'));
  return `${Math.hypot(...along).toFixed(3)} m (${parts.join(', ')})`;
}

/// Lets the user choose two points, and shows their distance in the view until it is closed or the next is measured.
/// @param stage Where the result is shown.
export async function measure(context: Context, stage: HTMLElement): Promise<void> {
  const { view, log } = context;
  if (!view) return log.add('info', 'There is no view to measure in');
  const result = stage.querySelector('.measured');
  result?.remove();
  view.showMeasure(null);
  const from = (await context.choosePlace(kPoint, 'Click on the first point, or move it by arrows and press Enter; Escape cancels'))?.position;
  if (!from) return;
  view.showMeasure([from, from]);
  const to = (await context.choosePlace(kPoint, 'Now the second point'))?.position;
  view.showMeasure(to ? [from, to] : null);
  if (!to) return;
  const shown = h('div', { class: 'measured', role: 'status' }, distanceText(from, to), ' ', iconButton('×', 'Close the measurement', () => {
    shown.remove();
    view.showMeasure(null);
  }));
  stage.append(shown);
}

/// Without visuals, a ball shows where it is.
const kPoint = { name: 'point' };
