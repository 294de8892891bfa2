import { BufferGeometry, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';

import type { Message, VectorMessage } from '../messages.ts';
import { put } from './scan.ts';

// length of the line for a normal [m]
const normalLength = 0.2;
// length of the line for a force [m/N], and the longest one [m]
const forceLength = 0.01;
const longestForce = 2;

export interface ContactMarks {
  /// Contact points in world coordinates [m]: x, y, z each.
  points: number[];
  /// End points of the lines along the normals.
  normals: number[];
  /// End points of the lines for the forces on the first of the two bodies; none where no force is told.
  forces: number[];
}

interface ContactMessage {
  position?: VectorMessage[];
  normal?: VectorMessage[];
  wrench?: { body1Wrench?: { force?: VectorMessage } }[];
}

/// @param contacts An ignition.msgs.Contacts.
export function contactMarks(contacts: Message): ContactMarks {
  const marks: ContactMarks = { points: [], normals: [], forces: [] };
  for (const contact of (contacts['contact'] ?? []) as ContactMessage[]) {
    contact.position?.forEach(({ x = 0, y = 0, z = 0 }, i) => {
      const normal = contact.normal?.[i] ?? {};
      marks.points.push(x, y, z);
      marks.normals.push(
        x, y, z,
        x + normalLength * (normal.x ?? 0), y + normalLength * (normal.y ?? 0), z + normalLength * (normal.z ?? 0),
      );
      const { x: fx = 0, y: fy = 0, z: fz = 0 } = contact.wrench?.[i]?.body1Wrench?.force ?? {};
      const force = Math.hypot(fx, fy, fz);
      if (force === 0) return;
      const scale = Math.min(forceLength, longestForce / force);
      marks.forces.push(x, y, z, x + scale * fx, y + scale * fy, z + scale * fz);
    });
  }
  return marks;
}

/// Contact points, normals and forces, drawn on top of everything.
export class Contacts {
  readonly object = new Group();
  private readonly points = new Points(
    new BufferGeometry(),
    new PointsMaterial({ color: 0x10e0e0, size: 9, sizeAttenuation: false, depthTest: false, transparent: true }),
  );
  private readonly normals = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0x10ff40, depthTest: false, transparent: true }),
  );

  private readonly forces = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0xff40ff, depthTest: false, transparent: true }),
  );

  constructor() {
    this.object.add(this.normals, this.forces, this.points);
    for (const part of this.object.children) {
      part.frustumCulled = false;
      part.renderOrder = 12;
    }
  }

  set(contacts: Message): void {
    const marks = contactMarks(contacts);
    put(this.points.geometry, marks.points);
    put(this.normals.geometry, marks.normals);
    put(this.forces.geometry, marks.forces);
  }

  dispose(): void {
    for (const { geometry, material } of [this.points, this.normals, this.forces]) {
      geometry.dispose();
      material.dispose();
    }
  }
}

/// Contacts under keys, such as the topics of sensors.
export class ContactsByKey {
  readonly group = new Group();
  private readonly all = new Map<string, Contacts>();

  /// @param contacts An ignition.msgs.Contacts; null removes those of the key.
  set(key: string, contacts: Message | null): void {
    let shape = this.all.get(key);
    if (contacts === null) {
      if (shape) this.group.remove(shape.object);
      shape?.dispose();
      this.all.delete(key);
      return;
    }
    if (shape === undefined) {
      shape = new Contacts();
      this.all.set(key, shape);
      this.group.add(shape.object);
    }
    shape.set(contacts);
  }

  clear(): void {
    for (const key of [...this.all.keys()]) this.set(key, null);
  }
}
