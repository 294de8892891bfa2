/// What a key does to the camera: a turn, as shares of the picture's height, or a factor of the distance.
export type KeyMove = { turn: [right: number, down: number] } | { zoom: number };

// of the picture's height
const step = 0.03;

/// Shift and arrows turn, + and - go nearer and away. Arrows by themselves are left to those who drive robots with them.
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
