import { Matrix4, Quaternion, Vector3 } from 'three';

import type { PoseMessage, VectorMessage } from '../messages.ts';

/// Pose of a frame in another one: X_AB is the pose of B in A.
export interface Placement {
  /// [m]
  position: Vector3;
  rotation: Quaternion;
}

export interface Pose {
  /// [m]
  position: [number, number, number];
  /// x, y, z, w
  orientation: [number, number, number, number];
}

export function noPlacement(): Placement {
  return { position: new Vector3(), rotation: new Quaternion() };
}

/// The vector of a message; missing values, infinities and NaN are 0.
export function vectorOf(message: VectorMessage | undefined): Vector3 {
  const finite = (value = 0) => (Number.isFinite(value) ? value : 0);
  return new Vector3(finite(message?.x), finite(message?.y), finite(message?.z));
}

/// A missing or invalid quaternion gives the identity.
function rotationOf(x: number, y: number, z: number, w: number): Quaternion {
  const rotation = new Quaternion(x, y, z, w);
  const length = rotation.length();
  return length > 1e-9 && Number.isFinite(length) ? rotation.normalize() : new Quaternion();
}

export function placementOf(message: PoseMessage | undefined): Placement {
  const q = message?.orientation;
  return { position: vectorOf(message?.position), rotation: rotationOf(q?.x ?? 0, q?.y ?? 0, q?.z ?? 0, q?.w ?? 0) };
}

export function placementOfPose(pose: Pose): Placement {
  return { position: new Vector3(...pose.position), rotation: rotationOf(...pose.orientation) };
}

export function poseOf(placement: Placement): Pose {
  const { position: p, rotation: q } = placement;
  return { position: [p.x, p.y, p.z], orientation: [q.x, q.y, q.z, q.w] };
}

/// X_AC = X_AB X_BC.
export function times(X_AB: Placement, X_BC: Placement): Placement {
  return {
    position: X_BC.position.clone().applyQuaternion(X_AB.rotation).add(X_AB.position),
    rotation: X_AB.rotation.clone().multiply(X_BC.rotation),
  };
}

/// X_BA, the inverse of X_AB.
export function inverse(X_AB: Placement): Placement {
  const rotation = X_AB.rotation.clone().invert();
  return { position: X_AB.position.clone().negate().applyQuaternion(rotation), rotation };
}

/// The transformation matrix of a pose, after a scaling along the axes.
export function matrixOf(placement: Placement, scale = new Vector3(1, 1, 1)): Matrix4 {
  return new Matrix4().compose(placement.position, placement.rotation, scale);
}

/// SDF's fixed-axis rotation: about x, then y, then z of the outer frame [rad].
export function fromRollPitchYaw(roll: number, pitch: number, yaw: number): Quaternion {
  const about = (x: number, y: number, z: number, angle: number) =>
    new Quaternion().setFromAxisAngle(new Vector3(x, y, z), angle);
  return about(0, 0, 1, yaw).multiply(about(0, 1, 0, pitch)).multiply(about(1, 0, 0, roll));
}
