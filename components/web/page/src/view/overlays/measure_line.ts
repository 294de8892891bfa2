import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';

type Point = [x: number, y: number, z: number];

/// The lines of a measurement: between its ends, and from one to the other along x, y and z.
export function measureLines(from: Point, to: Point): number[] {
  const [, y0, z0] = from;
  const [x1, y1] = to;
  const corners: Point[] = [from, [x1, y0, z0], [x1, y1, z0], to];
  return [...from, ...to, ...corners.slice(1).flatMap((corner, i) => [...corners[i]!, ...corner])];
}

/// A measured distance: a bright line with its ends, and its parts along the axes. It is visible through everything.
export class MeasureLine {
  readonly group = new Group();
  private readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ vertexColors: true, depthTest: false, transparent: true }));
  private readonly ends = new Points(new BufferGeometry(), new PointsMaterial({ color: 0xff9a1f, size: 9, sizeAttenuation: false, depthTest: false, transparent: true }));

  constructor() {
    this.group.add(this.lines, this.ends);
    for (const object of [this.lines, this.ends]) {
      object.frustumCulled = false;
      object.renderOrder = 10;
    }
    this.group.visible = false;
  }

  show(ends: [Point, Point] | null): void {
    this.group.visible = ends !== null;
    if (ends === null) return;
    this.lines.geometry.setAttribute('position', new Float32BufferAttribute(measureLines(...ends), 3));
    // the line itself, then x, y, z in the colours of the handles
    const colors = [[1, 0.33, 0.014], [1, 0.19, 0.08], [0.37, 0.69, 0.05], [0.1, 0.46, 1]];
    this.lines.geometry.setAttribute('color', new Float32BufferAttribute(colors.flatMap((color) => [...color, ...color]), 3));
    this.ends.geometry.setAttribute('position', new Float32BufferAttribute(ends.flat(), 3));
  }

  dispose(): void {
    for (const { geometry, material } of [this.lines, this.ends]) {
      geometry.dispose();
      material.dispose();
    }
  }
}
