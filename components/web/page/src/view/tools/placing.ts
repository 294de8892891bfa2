import { Raycaster, Vector3 } from 'three';

import type { OrbitCamera } from '../camera/orbit_camera.ts';
import { type Pose, poseOf } from '../maths/placement.ts';
import type { Message, ModelMessage } from '../messages.ts';
import type { Stage } from '../scene/stage.ts';
import { Ghost, groundUnder } from './ghost.ts';

// what an arrow key moves, without and with Shift [m]
const step = 0.1;
const largeStep = 1;
// surfaces up to this height above the current one are reached by keys [m]
const climb = 2;

/// The horizontal offset of an arrow key: along the axis of the world that is nearest to its direction on the screen;
/// null for other keys.
export function arrowOffset(event: { key: string; shiftKey: boolean }, sight: { x: number; y: number }): [x: number, y: number] | null {
  const turns = ['ArrowUp', 'ArrowLeft', 'ArrowDown', 'ArrowRight'].indexOf(event.key);
  if (turns < 0) return null;
  const quarter = Math.round(Math.atan2(sight.y, sight.x) / (Math.PI / 2)) + turns;
  const length = event.shiftKey ? largeStep : step;
  const along = (value: number): number => (Math.round(value) || 0) * length;
  return [along(Math.cos((quarter * Math.PI) / 2)), along(Math.sin((quarter * Math.PI) / 2))];
}

export interface PlacingOptions {
  changed(): void;
  /// The user has chosen a pose; null: cancelled.
  placed(pose: Pose | null): void;
}

/// Lets the user place a model: its preview follows the pointer until a click, or arrow keys until Enter; Escape cancels.
export class Placing {
  private ghost: Ghost | null = null;
  private point: Vector3 | null = null;
  /// What had the keyboard focus before.
  private focused: HTMLElement | null = null;

  /// @param signal Ends it.
  constructor(
    private readonly stage: Stage,
    private readonly orbitCamera: OrbitCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly options: PlacingOptions,
    signal: AbortSignal,
  ) {
    // capture: before panels that send keys to the world
    window.addEventListener('keydown', (event) => this.press(event), { signal, capture: true });
  }

  get isActive(): boolean {
    return this.ghost !== null;
  }

  /// Shows the preview in the middle of the view; null ends it.
  show(model: Message | null): void {
    if (this.ghost) this.stage.root.remove(this.ghost.object);
    else if (model) this.takeFocus();
    this.ghost?.dispose();
    this.ghost = model === null ? null : new Ghost(this.stage, model as ModelMessage, () => {
      this.ghost?.put(this.point);
      this.options.changed();
    });
    this.canvas.style.cursor = this.ghost ? 'copy' : '';
    if (this.ghost) {
      this.stage.root.add(this.ghost.object);
      this.hover(0.5, 0.5);
    } else {
      this.returnFocus();
    }
    this.options.changed();
  }

  /// @param x, y Fractions of the view's width and height, from its upper left corner.
  hover(x: number, y: number): void {
    this.put(this.orbitCamera.rayThrough(x, y));
  }

  click(x: number, y: number): void {
    this.hover(x, y);
    this.finish();
  }

  private put(ray: Raycaster): void {
    this.point = groundUnder(ray, this.stage.batches.meet(ray)[0]?.hit.point ?? null);
    this.ghost?.put(this.point);
    this.options.changed();
  }

  private finish(): void {
    const placement = this.ghost?.placement;
    if (!placement) return;
    this.show(null);
    this.options.placed(poseOf(placement));
  }

  private press(event: KeyboardEvent): void {
    if (!this.isActive || event.ctrlKey || event.altKey || event.metaKey) return;
    const offset = arrowOffset(event, this.orbitCamera.camera.getWorldDirection(new Vector3()));
    if (event.key !== 'Escape' && event.key !== 'Enter' && offset === null) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    if (event.key === 'Escape') {
      this.show(null);
      this.options.placed(null);
    } else if (offset === null) {
      this.finish();
    } else {
      const from = (this.point ?? this.orbitCamera.target).clone().add(new Vector3(...offset, climb));
      this.put(new Raycaster(from, new Vector3(0, 0, -1)));
    }
  }

  /// The keys are for the preview, not for the button that was pressed by a key.
  private takeFocus(): void {
    const active = document.activeElement;
    this.focused = active instanceof HTMLElement && active.matches(':focus-visible') ? active : null;
    this.canvas.focus({ preventScroll: true });
  }

  private returnFocus(): void {
    if (document.activeElement === this.canvas) this.focused?.focus();
    this.focused = null;
  }
}
