import type { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

export interface PointerTarget {
  /// A drag that rotates starts at this position, as fractions of the view's width and height from its upper left
  /// corner.
  turns(x: number, y: number): void;
  /// A button was pressed and released without motion.
  click(x: number, y: number): void;
  /// The pointer has moved while no button was pressed.
  hover(x: number, y: number): void;
}

// largest motion of a click [px]
const clickSlack = 4;
// OrbitControls with a zoomSpeed of 1 multiply the distance by 0.95 per 100 pixels: the logarithm per pixel.
const logPerPixel = -Math.log(0.95) / 100;

/// The zoomSpeed for a wheel event: the distance is multiplied by exp(pixels / 500), at most by exp(0.6).
export function wheelSpeed(event: { deltaY: number; deltaMode: number }): number {
  const pixels = Math.abs(event.deltaY * [1, 16, 100][event.deltaMode]!);
  return (Math.min(1, 300 / pixels) / 500) / logPerPixel;
}

/// Whether OrbitControls rotate in a drag that starts with this event.
export function turns(event: { button: number; shiftKey: boolean; ctrlKey: boolean; metaKey: boolean; pointerType: string }): boolean {
  if (event.pointerType === 'touch' || event.button === 1) return true;
  return event.button === 0 && (event.shiftKey || event.ctrlKey || event.metaKey);
}

/// Pointer input beside OrbitControls: clicks, and zoom speeds.
export class Pointer {
  private last = { x: 0, y: 0 };
  /// Length of the pointer's path since the press [px]; infinite if no button or several fingers are pressed.
  private path = Infinity;
  private readonly end = new AbortController();

  /// Must be created after the handles and before the controls are connected, because listeners are called in this
  /// order.
  constructor(
    private readonly element: HTMLElement,
    private readonly controls: OrbitControls,
    private readonly target: PointerTarget,
  ) {
    const { signal } = this.end;
    element.addEventListener('pointerdown', (event) => this.down(event), { signal });
    element.addEventListener('pointermove', (event) => this.move(event), { signal });
    element.addEventListener('pointerup', (event) => this.up(event), { signal });
    element.addEventListener('wheel', (event) => (this.controls.zoomSpeed = wheelSpeed(event)), { signal, passive: true });
  }

  dispose(): void {
    this.end.abort();
  }

  private share(event: PointerEvent): [number, number] {
    const box = this.element.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  private down(event: PointerEvent): void {
    // the handles use the pointer
    if (!this.controls.enabled) return;
    this.path = event.isPrimary ? 0 : Infinity;
    this.last = { x: event.clientX, y: event.clientY };
    // two fingers zoom by the ratio of their distances; a drag by a button over the view's height by exp(3) = 20
    this.controls.zoomSpeed = event.pointerType === 'touch' ? 1 : 3 / logPerPixel / (this.element.clientHeight || 1);
    if (event.isPrimary && turns(event)) this.target.turns(...this.share(event));
  }

  private move(event: PointerEvent): void {
    this.path += Math.hypot(event.clientX - this.last.x, event.clientY - this.last.y);
    this.last = { x: event.clientX, y: event.clientY };
    if (this.controls.enabled && event.buttons === 0) this.target.hover(...this.share(event));
  }

  private up(event: PointerEvent): void {
    if (this.controls.enabled && this.path < clickSlack && event.button === 0) this.target.click(...this.share(event));
    this.path = Infinity;
  }
}
