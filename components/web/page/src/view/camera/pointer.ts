import type { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

export interface PointerTarget {
  /// A drag that rotates starts; positions are fractions of the view's width and height, from its upper left corner.
  turns(x: number, y: number): void;
  /// A press and release without motion.
  click(x: number, y: number): void;
  /// The pointer moves without a button.
  hover(x: number, y: number): void;
}

// a click moves by at most this [px]
const clickSlack = 4;
// With a zoomSpeed of 1, OrbitControls multiply the distance by 0.95 per 100 pixels: this is the logarithm per pixel.
const logPerPixel = -Math.log(0.95) / 100;

/// The zoomSpeed with which the distance is multiplied by exp(pixels / 500), by at most exp(0.6) per turn of the wheel.
export function wheelSpeed(event: { deltaY: number; deltaMode: number }): number {
  const pixels = Math.abs(event.deltaY * [1, 16, 100][event.deltaMode]!);
  return (Math.min(1, 300 / pixels) / 500) / logPerPixel;
}

/// Whether OrbitControls rotate when a drag starts like this.
export function turns(event: { button: number; shiftKey: boolean; ctrlKey: boolean; metaKey: boolean; pointerType: string }): boolean {
  if (event.pointerType === 'touch' || event.button === 1) return true;
  return event.button === 0 && (event.shiftKey || event.ctrlKey || event.metaKey);
}

/// What OrbitControls don't do with the pointer: clicks, and the speeds of zooming.
export class Pointer {
  private last = { x: 0, y: 0 };
  /// Length of the pointer's path since the button was pressed; infinite: not pressed, or with several fingers [px].
  private path = Infinity;
  private readonly end = new AbortController();

  /// Create it after the handles and before the controls are connected, because listeners are called in this order.
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
    // something else uses the pointer: the handles
    if (!this.controls.enabled) return;
    this.path = event.isPrimary ? 0 : Infinity;
    this.last = { x: event.clientX, y: event.clientY };
    // fingers zoom by the ratio of their distances, a button by a factor of 20 over the height of the view
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
