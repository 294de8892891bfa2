/// Gestures of a pointer that control the camera.
export type Gesture = 'turn' | 'pan' | 'zoom';

export interface PointerTarget {
  /// A drag starts; positions are fractions of the view's width and height, from its upper left corner.
  begin(gesture: Gesture, x: number, y: number): void;
  /// As fractions of the view's height.
  drag(gesture: Gesture, right: number, down: number): void;
  /// @param factor Of the distance: below 1 nearer.
  zoom(factor: number, x: number, y: number): void;
  /// A press and release without motion.
  click(x: number, y: number): void;
  /// The pointer moves without a button.
  hover(x: number, y: number): void;
}

interface Finger {
  x: number;
  y: number;
}

// a click moves by at most this [px]
const clickSlack = 4;

/// As in Fortress: left pans, middle or shift and left rotates, right and the wheel zoom.
export function gestureOf(event: { button: number; shiftKey: boolean; pointerType: string }): Gesture {
  if (event.pointerType === 'touch') return 'turn';
  if (event.button === 1 || (event.button === 0 && event.shiftKey)) return 'turn';
  return event.button === 2 ? 'zoom' : 'pan';
}

/// Zoom factor of a turn of the wheel.
export function wheelFactor(event: { deltaY: number; deltaMode: number }): number {
  const pixels = event.deltaY * [1, 16, 400][event.deltaMode]!;
  return Math.exp(Math.min(Math.max(pixels, -300), 300) / 500);
}

/// Converts events of mouse, pen and fingers on an element to gestures.
export class Pointer {
  /// No gestures while something else uses the pointer, such as the handles.
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
    // each of two fingers contributes half of the motion
    this.target.drag(this.gesture, right / count, down / count);
    if (count === 2 && spread > 0) this.target.zoom(spread / Math.max(this.spread(), 1), ...this.share(event));
  }

  /// Distance between two fingers [px].
  private spread(): number {
    const [a, b] = [...this.fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  }

  private up(event: PointerEvent): void {
    if (!this.fingers.delete(event.pointerId) || !this.isEnabled) return;
    if (this.way < clickSlack && event.button === 0) this.target.click(...this.share(event));
    // a remaining finger continues alone
    if (this.fingers.size === 1) this.gesture = 'turn';
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    if (this.isEnabled) this.target.zoom(wheelFactor(event), ...this.share(event));
  }
}
