/// Poses as numbers, as messages and as text.
import type { Message } from './types.ts';

/// x, y, z [m], roll, pitch, yaw [rad], as in SDF.
export type Sixfold = [number, number, number, number, number, number];

/// x, y, z, w
export type Quaternion = [number, number, number, number];

export function quaternionOf(roll: number, pitch: number, yaw: number): Quaternion {
  const [cr, sr] = [Math.cos(roll / 2), Math.sin(roll / 2)];
  const [cp, sp] = [Math.cos(pitch / 2), Math.sin(pitch / 2)];
  const [cy, sy] = [Math.cos(yaw / 2), Math.sin(yaw / 2)];
  return [
    sr * cp * cy - cr * sp * sy,
    cr * sp * cy + sr * cp * sy,
    cr * cp * sy - sr * sp * cy,
    cr * cp * cy + sr * sp * sy,
  ];
}

export function rollPitchYawOf([x, y, z, w]: Quaternion): [number, number, number] {
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - z * x)));
  return [
    Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
    Math.asin(sine),
    Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
  ];
}

/// The pose as an ignition.msgs.Pose.
export function poseMessage([x, y, z, roll, pitch, yaw]: Sixfold): Message {
  const [qx, qy, qz, qw] = quaternionOf(roll, pitch, yaw);
  return { position: { x, y, z }, orientation: { x: qx, y: qy, z: qz, w: qw } };
}

/// The pose of a message. Unset positions are 0, an unset rotation is the identity.
export function sixfoldOf(pose: Message | undefined): Sixfold {
  const { x = 0, y = 0, z = 0 } = (pose?.position ?? {}) as Message;
  const { x: qx = 0, y: qy = 0, z: qz = 0, w: qw = 1 } = (pose?.orientation ?? {}) as Message;
  return [x, y, z, ...rollPitchYawOf([qx, qy, qz, qw])];
}

/// Parses six numbers separated by blanks; null for any other text.
export function parseSixfold(text: string): Sixfold | null {
  const numbers = text.trim().split(/\s+/).map(Number);
  return numbers.length === 6 && numbers.every(Number.isFinite) ? (numbers as Sixfold) : null;
}

/// The number with as few digits as necessary, rounded to 1e-9.
export function shortest(value: number): string {
  const rounded = Math.round(value * 1e9) / 1e9;
  return String(Number.isFinite(rounded) ? rounded + 0 : value);
}
