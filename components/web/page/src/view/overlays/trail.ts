import { BufferGeometry, Line, LineBasicMaterial, type Vector3 } from 'three';

import { put } from './scan.ts';

// limit of points; when it is reached, every other point of the older half is dropped
const mostPoints = 4000;
// smallest distance of two points [m]
const smallestStep = 0.01;

/// The past positions of an entity. The whole path is kept: if it is long, every other point of its older half is
/// dropped.
export class Path {
  readonly points: number[] = [];

  /// @returns Whether the position was added: it is far enough from the last one.
  add({ x, y, z }: Vector3): boolean {
    const end = this.points.length;
    const [lastX, lastY, lastZ] = this.points.slice(-3);
    if (end > 0 && Math.hypot(x - lastX!, y - lastY!, z - lastZ!) < smallestStep) return false;
    this.points.push(x, y, z);
    if (this.points.length > 3 * mostPoints) this.thin();
    return true;
  }

  private thin(): void {
    const count = this.points.length / 3;
    const kept: number[] = [];
    for (let i = 0; i < count; ++i) {
      if (i % 2 === 0 || i > count / 2) kept.push(...this.points.slice(3 * i, 3 * i + 3));
    }
    this.points.splice(0, this.points.length, ...kept);
  }
}

/// The path of an entity, drawn as a line.
export class Trail {
  readonly object: Line;
  private readonly path = new Path();

  constructor(readonly entity: number) {
    // a different hue for each entity, by steps of the golden angle
    const material = new LineBasicMaterial();
    material.color.setHSL((entity * 0.381966) % 1, 0.9, 0.5);
    this.object = new Line(new BufferGeometry(), material);
    this.object.frustumCulled = false;
  }

  add(place: Vector3): void {
    if (this.path.add(place)) put(this.object.geometry, this.path.points);
  }

  dispose(): void {
    this.object.geometry.dispose();
    (this.object.material as LineBasicMaterial).dispose();
  }
}
