/// A pose as a table whose numbers keep their places while they change, and can be changed.
import { h, isEditing, onEntered } from '../app/dom.ts';
import type { Sixfold } from '../connection/poses.ts';

const kNames = ['x', 'y', 'z', 'roll', 'pitch', 'yaw'];

/// A number with three decimals: millimetres, and a twentieth of a degree.
export function fixedNumber(value: number): string {
  const text = value.toFixed(3);
  return Number(text) === 0 ? '0.000' : text;
}

export class PoseTable {
  private pose: readonly number[] = [];
  private readonly cells = kNames.map((name, i) => h('input', {
    type: 'number', step: 'any', class: 'number', 'aria-label': name, onblur: () => this.write(i),
  }));
  private readonly frame = h('span', { class: 'hint' });
  readonly element = h('div', { class: 'pose', id: 'inspector-pose' },
    ...kNames.map((name, i) => h('span', {}, h('span', { class: 'axis' }, name), this.cells[i])), this.frame);

  /// @param change Called when a number has been entered, with what makes the new pose of the present one: the other
  /// numbers keep all their digits, and may have been entered just before.
  constructor(private readonly change: (enter: (now: Sixfold) => Sixfold) => void) {
    this.cells.forEach((cell, i) => onEntered(cell, () => this.enter(i)));
  }

  /// @param pose x, y, z [m], roll, pitch, yaw [rad]; empty if it is not known.
  /// @param frame "in the world"
  show(pose: readonly number[], frame: string, isFixed = true): void {
    this.pose = pose;
    this.cells.forEach((cell, i) => {
      cell.readOnly = isFixed || pose.length !== 6;
      // what is being typed stays
      if (cell.readOnly || !isEditing(cell)) this.write(i);
    });
    this.frame.textContent = `${frame} [m, rad]`;
    // all digits, to copy
    this.element.title = pose.join(' ');
  }

  private write(i: number): void {
    this.cells[i]!.value = this.pose[i] === undefined ? '' : fixedNumber(this.pose[i]);
  }

  private enter(i: number): void {
    const entered = this.cells[i]!.valueAsNumber;
    if (Number.isFinite(entered)) this.change((now) => now.map((number, k) => (k === i ? entered : number)) as Sixfold);
  }
}
