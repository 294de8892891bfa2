/// A round pad with a knob that is dragged by finger or mouse, for two values at once.
import { h } from '../app/dom.ts';

/// The knob's place on the pad.
/// @param x, y Of the pointer, from the middle, as fractions of the radius; y downward.
/// @return To the right and up, -1 to 1, in the unit circle.
export function knobAt(x: number, y: number): [right: number, up: number] {
  const length = Math.max(1, Math.hypot(x, y));
  return [x / length, -y / length];
}

/// @param moved Called with the knob's place; with 0, 0 when it is released.
export function joystick(moved: (right: number, up: number) => void): HTMLElement {
  const knob = h('div', { class: 'knob' });
  // hidden from screen readers and keys, which have the sliders and buttons
  const pad = h('div', { class: 'joystick', 'aria-hidden': 'true', title: 'Drag to drive; it stops when released' }, knob);
  const put = (right: number, up: number): void => {
    knob.style.left = `${50 + 50 * right}%`;
    knob.style.top = `${50 - 50 * up}%`;
    moved(right, up);
  };
  const follow = (event: PointerEvent): void => {
    const { left, top, width, height } = pad.getBoundingClientRect();
    put(...knobAt((event.clientX - left) / (width / 2) - 1, (event.clientY - top) / (height / 2) - 1));
  };
  let held: number | null = null;
  pad.addEventListener('pointerdown', (event) => {
    if (held !== null) return;
    held = event.pointerId;
    pad.setPointerCapture(held);
    follow(event);
  });
  pad.addEventListener('pointermove', (event) => {
    if (event.pointerId === held) follow(event);
  });
  // also when the browser takes the pointer away, as for a call
  pad.addEventListener('lostpointercapture', (event) => {
    if (event.pointerId !== held) return;
    held = null;
    put(0, 0);
  });
  return pad;
}
