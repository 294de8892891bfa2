/// What a pointer does to the camera.
export type Gesture = 'turn' | 'pan' | 'zoom';

export interface PointerTarget {
  /// A drag begins; places as shares of the picture's width and height, from its upper left corner.
  begin(gesture: Gesture, x: number, y: number): void;
  /// As shares of the picture's height.
  drag(gesture: Gesture, right: number, down: number): void;
  /// @param factor Of the distance: below 1 nearer.
  zoom(factor: number, x: number, y: number): void;
  /// A press and release in place.
  click(x: number, y: number): void;
  /// The pointer is there without a button.
  hover(x: number, y: number): void;
}

interface Finger {
  x: number;
  y: number;
}

// a pointer that has gone no further has clicked [px]
const clickSlack = 4;

/// As Fortress's window has it: left pans, middle or shift and left turns, right and the wheel zoom.
export function gestureOf(event: { button: number; shiftKey: boolean; pointerType: string }): Gesture {
  if (event.pointerType === 'touch') return 'turn';
  if (event.button === 1 || (event.button === 0 && event.shiftKey)) return 'turn';
  return event.button === 2 ? 'zoom' : 'pan';
}

/// How much nearer or farther a turn of the wheel goes.
export function wheelFactor(event: { deltaY: number; deltaMode: number }): number {
  const pixels = event.deltaY * [1, 16, 400][event.deltaMode]!;
  return Math.exp(Math.min(Math.max(pixels, -300), 300) / 500);
}

/// Turns the events of mouse, pen and fingers on an element into gestures.
export class Pointer {
  /// No gestures while somebody else uses the pointer, as the handles do.
  isEnabled = true;
  private readonly fingers = new Map<number, Finger>();
  private gesture: Gesture = 'pan';
  private way = 0;
  private readonly end = new AbortController();

  constructor(
    private readonly element: HTMLElement,
    private readonly target: PointerTarget,
  ) {
    const { signal } = this.end;
    element.style.touchAction = 'none';
    element.addEventListener('pointerdown', (event) => this.down(event), { signal });
    element.addEventListener('pointermove', (event) => this.move(event), { signal });
    element.addEventListener('pointerup', (event) => this.up(event), { signal });
    element.addEventListener('pointercancel', (event) => this.fingers.delete(event.pointerId), { signal });
    element.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    element.addEventListener('wheel', (event) => this.wheel(event), { signal, passive: false });
  }

  dispose(): void {
    this.end.abort();
  }

  private share(event: { clientX: number; clientY: number }): [number, number] {
    const box = this.element.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
  }

  private down(event: PointerEvent): void {
    if (!this.isEnabled) return;
    this.element.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.gesture = this.fingers.size > 1 ? 'pan' : gestureOf(event);
    this.way = this.fingers.size > 1 ? Infinity : 0;
    this.target.begin(this.gesture, ...this.share(event));
  }

  private move(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    if (finger === undefined || !this.isEnabled) {
      if (this.isEnabled) this.target.hover(...this.share(event));
      return;
    }
    const spread = this.spread();
    const count = this.fingers.size;
    const height = this.element.clientHeight || 1;
    const right = (event.clientX - finger.x) / height;
    const down = (event.clientY - finger.y) / height;
    this.way += Math.abs(event.clientX - finger.x) + Math.abs(event.clientY - finger.y);
    finger.x = event.clientX;
    finger.y = event.clientY;
    if (this.way < clickSlack) return;
    // of two fingers each moves the picture by half
    this.target.drag(this.gesture, right / count, down / count);
    if (count === 2 && spread > 0) this.target.zoom(spread / Math.max(this.spread(), 1), ...this.share(event));
  }

  /// Between two fingers [px].
  private spread(): number {
    const [a, b] = [...this.fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  private up(event: PointerEvent): void {
    if (!this.fingers.delete(event.pointerId) || !this.isEnabled) return;
    if (this.way < clickSlack && event.button === 0) this.target.click(...this.share(event));
    // a finger that stays goes on by itself
    if (this.fingers.size === 1) this.gesture = 'turn';
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    if (this.isEnabled) this.target.zoom(wheelFactor(event), ...this.share(event));
  }
}
