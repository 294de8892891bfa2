import {
  type BufferGeometry,
  BoxGeometry,
  ConeGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  type Object3D,
  Quaternion,
  SphereGeometry,
  TorusGeometry,
  Vector3,
} from 'three';

import { inertiaBox, leadRadius } from '../maths/inertia.ts';
import { placementOf, times, vectorOf } from '../maths/placement.ts';
import { type InertialMessage, JointType } from '../messages.ts';
import type { Joint } from '../scene/content.ts';

// geometries shared by all overlays
const cube = new BoxGeometry();
const ball = new SphereGeometry(1, 24, 12);
const arrowTip = new ConeGeometry(0.08, 0.25, 16);
const ring = new TorusGeometry(0.35, 0.02, 8, 32).rotateX(Math.PI / 2);

// drawn on top of everything
const over = { depthTest: false, transparent: true } as const;
const axisColors = [0xff2020, 0x20c020, 0x3050ff].map((color) => new MeshBasicMaterial({ color, ...over }));
const axisColor = new MeshBasicMaterial({ color: 0xffe000, ...over });
const inertiaColor = new MeshLambertMaterial({ color: 0xb030d0, opacity: 0.4, transparent: true, depthWrite: false });
const centreColor = new MeshBasicMaterial({ color: 0x101010, opacity: 0.9, ...over });
const collisionColor = new MeshLambertMaterial({
  color: 0xff8010, opacity: 0.5, transparent: true, depthWrite: false, side: DoubleSide,
});

/// Three rods along the axes: x red, y green, z blue.
export function frameMark(length: number): Object3D {
  const mark = new Group();
  axisColors.forEach((color, axis) => {
    const rod = new Mesh(cube, color);
    rod.scale.setScalar(length * 0.03).setComponent(axis, length);
    rod.position.setComponent(axis, length / 2);
    rod.renderOrder = 10;
    mark.add(rod);
  });
  return mark;
}

/// The frame of a joint, and an arrow along each axis, with a ring if it is revolute.
export function jointMark(joint: Joint, length: number): Object3D {
  const mark = new Group();
  mark.add(frameMark(length * 0.5));
  const turns = joint.type !== JointType.prismatic;
  for (const axis of joint.axes) {
    const direction = vectorOf(axis.xyz);
    if (direction.lengthSq() === 0) continue;
    const arrow = new Group();
    const tip = new Mesh(arrowTip, axisColor);
    tip.position.y = 1;
    const shaft = new Mesh(cube, axisColor);
    shaft.scale.set(0.03, 1, 0.03);
    shaft.position.y = 0.5;
    arrow.add(tip, shaft);
    if (turns) arrow.add(new Mesh(ring, axisColor));
    arrow.scale.setScalar(length);
    arrow.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), direction.normalize()));
    mark.add(arrow);
  }
  mark.traverse((part) => (part.renderOrder = 10));
  mark.position.copy(joint.X_PlaceJoint.position);
  mark.quaternion.copy(joint.X_PlaceJoint.rotation);
  return mark;
}

/// A ball at the centre of mass, as large as the link's mass would be in lead.
export function centreMark(inertial: InertialMessage): Object3D {
  const mark = new Mesh(ball, centreColor);
  mark.scale.setScalar(Math.max(leadRadius(inertial.mass ?? 0), 0.005));
  mark.renderOrder = 11;
  mark.position.copy(placementOf(inertial.pose).position);
  return mark;
}

/// A box of uniform density with the link's mass and moments of inertia.
export function inertiaMark(inertial: InertialMessage): Object3D | null {
  const box = inertiaBox(inertial);
  if (box === null) return null;
  const mark = new Mesh(cube, inertiaColor);
  const { position, rotation } = times(placementOf(inertial.pose), { position: new Vector3(), rotation: box.rotation });
  mark.position.copy(position);
  mark.quaternion.copy(rotation);
  mark.scale.copy(box.size.clampScalar(1e-3, 1e4));
  return mark;
}

export function collisionMark(geometry: BufferGeometry): Object3D {
  return new Mesh(geometry, collisionColor);
}
