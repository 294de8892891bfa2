import { Matrix4, Quaternion, Vector3 } from 'three';

import { type Placement, fromRollPitchYaw } from '../maths/placement.ts';

const steepest = Math.PI / 2 - 0.001;
const nearest = 0.05;
const farthest = 5000;

export type Direction = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'home';

/// A viewpoint that looks at a point, with z up.
export interface Orbit {
  /// [m]
  target: Vector3;
  /// Distance of the eye from the target [m].
  distance: number;
  /// Heading of the line of sight, from x towards y [rad].
  yaw: number;
  /// Downward angle of the line of sight [rad].
  pitch: number;
}

/// Fortress's initial viewpoint: from (-6, 0, 6), looking down by 0.5 rad.
export function homeOrbit(): Orbit {
  return orbitFrom({ position: new Vector3(-6, 0, 6), rotation: fromRollPitchYaw(0, 0.5, 0) });
}

/// Direction of the line of sight.
export function ahead(orbit: Orbit): Vector3 {
  const flat = Math.cos(orbit.pitch);
  return new Vector3(flat * Math.cos(orbit.yaw), flat * Math.sin(orbit.yaw), -Math.sin(orbit.pitch));
}

export function eyeOf(orbit: Orbit): Vector3 {
  return orbit.target.clone().addScaledVector(ahead(orbit), -orbit.distance);
}

/// The viewpoint as a pose: looks along x, z is up.
export function placementOfEye(orbit: Orbit): Placement {
  return { position: eyeOf(orbit), rotation: fromRollPitchYaw(0, orbit.pitch, orbit.yaw) };
}

/// The viewpoint for three.js: looks along -z, y is up.
export function rotationOfCamera(orbit: Orbit): Quaternion {
  const x = ahead(orbit);
  const left = new Vector3(-Math.sin(orbit.yaw), Math.cos(orbit.yaw), 0);
  const up = new Vector3().crossVectors(x, left);
  return new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(left.negate(), up, x.negate()));
}

/// A viewpoint at a pose. Its target is on the ground if that is ahead and not too far, otherwise at a point ahead.
export function orbitFrom(X_WorldEye: Placement): Orbit {
  const x = new Vector3(1, 0, 0).applyQuaternion(X_WorldEye.rotation);
  const { position } = X_WorldEye;
  const toGround = x.z < -0.05 ? position.z / -x.z : -1;
  const distance = toGround > nearest && toGround < 100 ? toGround : 10;
  return {
    target: position.clone().addScaledVector(x, distance),
    distance,
    yaw: Math.hypot(x.x, x.y) < 1e-6 ? 0 : Math.atan2(x.y, x.x),
    pitch: Math.min(Math.max(Math.asin(Math.min(Math.max(-x.z, -1), 1)), -steepest), steepest),
  };
}

/// @param right, down Motion of the pointer, as fractions of the view's height.
export function turned(orbit: Orbit, right: number, down: number): Orbit {
  const pitch = Math.min(Math.max(orbit.pitch + down * Math.PI, -steepest), steepest);
  return { ...orbit, yaw: orbit.yaw - right * Math.PI, pitch };
}

/// Pans so that a point at the target's distance follows the pointer.
/// @param fieldOfView Vertical [rad].
export function panned(orbit: Orbit, right: number, down: number, fieldOfView: number): Orbit {
  const height = 2 * orbit.distance * Math.tan(fieldOfView / 2);
  const rotation = rotationOfCamera(orbit);
  const target = orbit.target
    .clone()
    .addScaledVector(new Vector3(1, 0, 0).applyQuaternion(rotation), -right * height)
    .addScaledVector(new Vector3(0, 1, 0).applyQuaternion(rotation), down * height);
  return { ...orbit, target };
}

/// Zooms in (factor below 1) or out; the point under the pointer stays there.
/// @param direction From the eye to the point under the pointer, of any length; null: the centre of the view.
export function zoomed(orbit: Orbit, factor: number, direction: Vector3 | null): Orbit {
  const distance = Math.min(Math.max(orbit.distance * factor, nearest), farthest);
  const change = orbit.distance - distance;
  if (direction === null) return { ...orbit, distance };
  const x = ahead(orbit);
  const share = direction.dot(x);
  if (share <= 1e-3) return { ...orbit, distance };
  // both the eye and the target move sideways
  const sideways = direction.clone().multiplyScalar(change / share).addScaledVector(x, -change);
  return { ...orbit, distance, target: orbit.target.clone().add(sideways) };
}

/// Looks at a ball so that all of it is visible.
export function fitted(orbit: Orbit, middle: Vector3, radius: number, fieldOfView: number, aspect: number): Orbit {
  const half = Math.atan(Math.tan(fieldOfView / 2) * Math.min(aspect, 1));
  const distance = Math.min(Math.max((1.1 * radius) / Math.sin(half), 0.3), farthest);
  return { ...orbit, target: middle.clone(), distance };
}

/// Looks at the same target from a side: 'front' is the side that x points to.
export function from(orbit: Orbit, direction: Direction): Orbit {
  const sides: Record<Exclude<Direction, 'home'>, [yaw: number, pitch: number]> = {
    front: [Math.PI, 0],
    back: [0, 0],
    left: [-Math.PI / 2, 0],
    right: [Math.PI / 2, 0],
    top: [0, steepest],
    bottom: [0, -steepest],
  };
  if (direction === 'home') return homeOrbit();
  const [yaw, pitch] = sides[direction];
  return { ...orbit, yaw, pitch };
}
