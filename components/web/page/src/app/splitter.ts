/// A line between a dock and the view, which is dragged or moved by arrow keys.
import { h } from './dom.ts';
import { kLargest, kSmallest } from './page_state.ts';

export interface SplitterOptions {
  name: string;
  /// The side of the page on which the dock is.
  side: 'left' | 'right' | 'bottom';
  size(): number;
  resize(size: number): void;
}

const kStep = 20;

export function splitter({ name, side, size, resize }: SplitterOptions): HTMLElement {
  const isFlat = side === 'bottom';
  const line = h('div', {
    class: `splitter ${side}`, role: 'separator', tabindex: 0, 'aria-label': name, hidden: true,
    'aria-orientation': isFlat ? 'horizontal' : 'vertical', 'aria-valuemin': kSmallest, 'aria-valuemax': kLargest, 'aria-valuenow': kSmallest,
  });
  const set = (wanted: number): void => {
    // the view keeps a part of the window
    const most = 0.7 * (isFlat ? innerHeight : innerWidth);
    const now = Math.round(Math.min(Math.max(wanted, kSmallest), Math.max(most, kSmallest)));
    line.setAttribute('aria-valuenow', String(now));
    resize(now);
  };
  // towards the view is larger
  const sign = side === 'left' ? 1 : -1;
  let from: { at: number; size: number } | null = null;
  line.addEventListener('pointerdown', (event) => {
    from = { at: isFlat ? event.clientY : event.clientX, size: size() };
    line.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  line.addEventListener('pointermove', (event) => {
    if (from) set(from.size + sign * ((isFlat ? event.clientY : event.clientX) - from.at));
  });
  line.addEventListener('lostpointercapture', () => (from = null));
  line.addEventListener('focus', () => line.setAttribute('aria-valuenow', String(Math.round(size()))));
  line.addEventListener('keydown', (event) => {
    const steps: Record<string, number> = isFlat ? { ArrowUp: 1, ArrowDown: -1 } : { ArrowRight: sign, ArrowLeft: -sign };
    const step = steps[event.key];
    if (step === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    set(size() + step * kStep);
  });
  return line;
}
