/// The left stick of a gamepad, or the right one for turning.

/// Sticks do not come back exactly to the middle: smaller deflections count as none.
const kDeadZone = 0.12;

/// A stick's deflection without its dead zone, which still reaches -1 and 1.
export function deflection(axis: number): number {
  const beyond = Math.abs(axis) - kDeadZone;
  return beyond <= 0 ? 0 : Math.sign(axis) * Math.min(1, beyond / (1 - kDeadZone));
}

/// What the sticks of the first connected gamepad ask for, in the layout that browsers call "standard": forward by the
/// left stick, to the right by either.
/// @return To the right and up, -1 to 1; null without a gamepad.
export function sticks(pads: readonly (Gamepad | null)[]): [right: number, up: number] | null {
  const pad = pads.find((each) => each?.connected);
  if (!pad) return null;
  const [x = 0, y = 0, x2 = 0] = pad.axes.map(deflection);
  return [Math.abs(x2) > Math.abs(x) ? x2 : x, y === 0 ? 0 : -y];
}

/// Reads the gamepad at the screen's rate, because browsers do not tell when a stick moves.
/// @param moved Called when the sticks have moved; with 0, 0 when the gamepad is gone.
/// @return A function that ends it.
export function followGamepad(moved: (right: number, up: number) => void): () => void {
  let last: [number, number] = [0, 0];
  let frame = 0;
  const look = (): void => {
    frame = requestAnimationFrame(look);
    const now = sticks(navigator.getGamepads()) ?? [0, 0];
    if (now[0] === last[0] && now[1] === last[1]) return;
    last = now;
    moved(...now);
  };
  frame = requestAnimationFrame(look);
  return () => cancelAnimationFrame(frame);
}
