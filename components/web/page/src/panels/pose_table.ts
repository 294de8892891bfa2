/// A pose as a table whose numbers keep their places while they change.
import { h } from '../app/dom.ts';

const kNames = ['x', 'y', 'z', 'roll', 'pitch', 'yaw'];

/// A number with three decimals: millimetres, and a twentieth of a degree.
export function fixedNumber(value: number): string {
  const text = value.toFixed(3);
  return Number(text) === 0 ? '0.000' : text;
}

export class PoseTable {
  private readonly cells = kNames.map(() => h('span', { class: 'number' }));
  private readonly frame = h('span', { class: 'hint' });
  readonly element = h('div', { class: 'pose', id: 'inspector-pose' },
    ...kNames.map((name, i) => h('span', {}, h('span', { class: 'axis' }, name), this.cells[i])), this.frame);

  /// @param pose x, y, z [m], roll, pitch, yaw [rad]; empty if it is not known.
  /// @param frame "in the world"
  show(pose: readonly number[], frame: string): void {
    this.cells.forEach((cell, i) => (cell.textContent = pose[i] === undefined ? '–' : fixedNumber(pose[i])));
    this.frame.textContent = `${frame} [m, rad]`;
    // all digits, to copy
    this.element.title = pose.join(' ');
  }
}
