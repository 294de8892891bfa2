/// A key's effect on the camera: a rotation, as fractions of the view's height, or a factor for the distance.
export type KeyMove = { turn: [right: number, down: number] } | { zoom: number };

// of the view's height
const step = 0.03;

/// The effect of Shift and arrows (rotation), + and - (zoom). Arrows alone are left to panels that drive robots.
export function keyMove(event: { key: string; shiftKey: boolean; ctrlKey: boolean; altKey: boolean }): KeyMove | null {
  if (event.ctrlKey || event.altKey) return null;
  if (event.key === '+' || event.key === '=') return { zoom: 1 / 1.2 };
  if (event.key === '-') return { zoom: 1.2 };
  if (!event.shiftKey) return null;
  const turns: Record<string, [number, number]> = {
    ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step],
  };
  const turn = turns[event.key];
  return turn === undefined ? null : { turn };
}
