/// Times of messages as numbers.
import type { Message } from './types.ts';

/// @return An ignition.msgs.Time [s]; 0 if it is not there.
export function secondsOf(time: unknown): number {
  const { sec, nsec } = (time ?? {}) as Message;
  return Number(sec ?? 0) + Number(nsec ?? 0) / 1e9;
}

/// @return An ignition.msgs.Time, to the microsecond.
export function timeMessage(seconds: number): Message {
  const micros = Math.round(seconds * 1e6);
  return { sec: BigInt(Math.floor(micros / 1e6)), nsec: (micros % 1e6) * 1000 };
}
