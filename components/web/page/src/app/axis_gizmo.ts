/// The axes of the world, as they are seen from the viewpoint, in a corner of the view; each looks along itself.
import type { Direction } from '../view/index.ts';
import { h } from './dom.ts';

// length of an axis, and half the size of the gizmo [px]
const kArm = 26;
const kHalf = 38;

export interface Arm {
  /// To the right and down from the middle [px].
  x: number;
  y: number;
  /// Whether it points towards the eye.
  isNear: boolean;
}

/// Where the axes of the world are seen.
/// @param orientation x, y, z, w of the eye, which looks along x with z up.
export function armsOf([x, y, z, w]: readonly number[]): [Arm, Arm, Arm] {
  // rows of the rotation from the world to the eye
  const ahead = [1 - 2 * (y! * y! + z! * z!), 2 * (x! * y! + w! * z!), 2 * (x! * z! - w! * y!)];
  const left = [2 * (x! * y! - w! * z!), 1 - 2 * (x! * x! + z! * z!), 2 * (y! * z! + w! * x!)];
  const up = [2 * (x! * z! + w! * y!), 2 * (y! * z! - w! * x!), 1 - 2 * (x! * x! + y! * y!)];
  return [0, 1, 2].map((i) => ({ x: -kArm * left[i]!, y: -kArm * up[i]!, isNear: ahead[i]! < 0 })) as [Arm, Arm, Arm];
}

const kAxes: [name: string, color: string, from: Direction][] = [['X', '#e0443e', 'front'], ['Y', '#3a9d3a', 'left'], ['Z', '#4a7dff', 'top']];

export class AxisGizmo {
  private readonly lines = kAxes.map(([, color]) => {
    const line = document.createElementNS('http://www.w3.org/2000/svg', 'line');
    for (const [key, value] of Object.entries({ x1: 0, y1: 0, stroke: color, 'stroke-width': 2 })) line.setAttribute(key, String(value));
    return line;
  });
  private readonly buttons: HTMLButtonElement[];
  readonly element: HTMLElement;

  /// @param look Called when an axis has been chosen.
  constructor(look: (from: Direction) => void) {
    this.buttons = kAxes.map(([name, , from]) => h('button', { type: 'button', title: `Look along ${name}`, 'aria-label': `Look along ${name}`, onclick: () => look(from) }, name));
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', `${-kHalf} ${-kHalf} ${2 * kHalf} ${2 * kHalf}`);
    svg.setAttribute('aria-hidden', 'true');
    svg.append(...this.lines);
    this.element = h('div', { class: 'axis-gizmo', role: 'group', 'aria-label': 'Axes' }, svg, ...this.buttons);
  }

  show(orientation: readonly number[]): void {
    armsOf(orientation).forEach(({ x, y, isNear }, i) => {
      this.lines[i]!.setAttribute('x2', x.toFixed(1));
      this.lines[i]!.setAttribute('y2', y.toFixed(1));
      const { style } = this.buttons[i]!;
      style.left = `${(kHalf + x).toFixed(1)}px`;
      style.top = `${(kHalf + y).toFixed(1)}px`;
      style.zIndex = isNear ? '1' : '0';
    });
  }
}
