import { Matrix3, Matrix4, Quaternion, Vector3 } from 'three';

import type { InertialMessage } from '../messages.ts';

/// The diagonal form of a symmetric matrix: R diag(values) R^T.
export interface Principal {
  values: Vector3;
  /// R: its columns are the principal axes.
  rotation: Quaternion;
}

/// Jacobi's eigenvalue algorithm: rotates the largest off-diagonal element to zero until all are negligible.
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

/// Replaces a by R^T a R, and v by v R, where R is a rotation in the plane of p and q.
function turn(a: number[][], v: number[][], p: number, q: number, c: number, s: number): void {
  const columns = (m: number[][]) => {
    for (const row of m) [row[p], row[q]] = [c * row[p]! - s * row[q]!, s * row[p]! + c * row[q]!];
  };
  columns(a);
  for (let k = 0; k < 3; ++k) [a[p]![k], a[q]![k]] = [c * a[p]![k]! - s * a[q]![k]!, s * a[p]![k]! + c * a[q]![k]!];
  columns(v);
}

/// The box of uniform density with the same mass and moments of inertia.
export interface InertiaBox {
  size: Vector3;
  /// Orientation in the frame of the centre of mass.
  rotation: Quaternion;
}

/// @returns Null if the mass is not positive, or the moments violate the triangle inequality, as those of no body do.
export function inertiaBox(inertial: InertialMessage): InertiaBox | null {
  const { mass = 0, ixx = 0, iyy = 0, izz = 0, ixy = 0, ixz = 0, iyz = 0 } = inertial;
  if (!(mass > 0)) return null;
  const { values, rotation } = principal(ixx, iyy, izz, ixy, ixz, iyz);
  // from the moments of a box, Ixx = m / 12 (b^2 + c^2), ...: a^2 = 6 / m (Iyy + Izz - Ixx), ...
  const square = (a: number, b: number, c: number) => (6 / mass) * (b + c - a);
  const squares = [
    square(values.x, values.y, values.z),
    square(values.y, values.z, values.x),
    square(values.z, values.x, values.y),
  ];
  if (!squares.every((value) => value >= -1e-9 && Number.isFinite(value))) return null;
  return { size: new Vector3(...squares.map((value) => Math.sqrt(Math.max(value, 0)))), rotation };
}

/// Radius of a ball of this mass with the density of lead, 11,340 kg/m^3 [m].
export function leadRadius(mass: number): number {
  return Math.cbrt((0.75 * Math.max(mass, 0)) / (Math.PI * 11340));
}
