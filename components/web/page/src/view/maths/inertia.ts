import { Matrix3, Matrix4, Quaternion, Vector3 } from 'three';

import type { InertialMessage } from '../messages.ts';

/// The diagonal form of a symmetric matrix.
export interface Principal {
  values: Vector3;
  /// Its columns are the axes.
  rotation: Quaternion;
}

/// Jacobi's method: eliminates the largest off-diagonal element until all are negligible.
export function principal(xx: number, yy: number, zz: number, xy: number, xz: number, yz: number): Principal {
  const a = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const rotation = new Matrix3();
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let round = 0; round < 50; ++round) {
    const [p, q] = largest(a);
    const scale = Math.abs(a[0]![0]!) + Math.abs(a[1]![1]!) + Math.abs(a[2]![2]!);
    if (!(Math.abs(a[p]![q]!) > 1e-14 * scale)) break;
    const angle = 0.5 * Math.atan2(2 * a[p]![q]!, a[q]![q]! - a[p]![p]!);
    turn(a, v, p, q, Math.cos(angle), Math.sin(angle));
  }
  rotation.set(v[0]![0]!, v[0]![1]!, v[0]![2]!, v[1]![0]!, v[1]![1]!, v[1]![2]!, v[2]![0]!, v[2]![1]!, v[2]![2]!);
  return {
    values: new Vector3(a[0]![0], a[1]![1], a[2]![2]),
    rotation: new Quaternion().setFromRotationMatrix(new Matrix4().setFromMatrix3(rotation)),
  };
}

function largest(a: number[][]): [number, number] {
  const pairs: [number, number][] = [
    [0, 1],
    [0, 2],
    [1, 2],
  ];
  return pairs.reduce((best, pair) => (Math.abs(a[pair[0]]![pair[1]]!) > Math.abs(a[best[0]]![best[1]]!) ? pair : best));
}

/// Replaces a by transpose(R) a R, and v by v R.
function turn(a: number[][], v: number[][], p: number, q: number, c: number, s: number): void {
  const columns = (m: number[][]) => {
    for (const row of m) [row[p], row[q]] = [c * row[p]! - s * row[q]!, s * row[p]! + c * row[q]!];
  };
  columns(a);
  for (let k = 0; k < 3; ++k) [a[p]![k], a[q]![k]] = [c * a[p]![k]! - s * a[q]![k]!, s * a[p]![k]! + c * a[q]![k]!];
  columns(v);
}

/// The box of uniform density with the same mass and moments.
export interface InertiaBox {
  size: Vector3;
  /// In the frame of the centre of mass.
  rotation: Quaternion;
}

/// @returns Null for moments that no body can have.
export function inertiaBox(inertial: InertialMessage): InertiaBox | null {
  const { mass = 0, ixx = 0, iyy = 0, izz = 0, ixy = 0, ixz = 0, iyz = 0 } = inertial;
  if (!(mass > 0)) return null;
  const { values, rotation } = principal(ixx, iyy, izz, ixy, ixz, iyz);
  // moments of a box: m / 12 * (b^2 + c^2), ...
  const square = (a: number, b: number, c: number) => (6 / mass) * (b + c - a);
  const squares = [
    square(values.x, values.y, values.z),
    square(values.y, values.z, values.x),
    square(values.z, values.x, values.y),
  ];
  if (!squares.every((value) => value >= -1e-9 && Number.isFinite(value))) return null;
  return { size: new Vector3(...squares.map((value) => Math.sqrt(Math.max(value, 0)))), rotation };
}

/// Radius of a ball of lead with that mass, which marks a centre of mass [m].
export function leadRadius(mass: number): number {
  return Math.cbrt((0.75 * Math.max(mass, 0)) / (Math.PI * 11340));
}
