import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Points, PointsMaterial } from 'three';

import type { Message } from '../messages.ts';

/// The beams of a scan, in the frame of the sensor [m].
export interface Beams {
  /// Positions of the hits: x, y, z each.
  hits: Float32Array;
  /// Start and end points of beams with a hit.
  hitLines: Float32Array;
  /// Start and end points of beams without a hit.
  missLines: Float32Array;
}

/// @param scan An ignition.msgs.LaserScan.
export function beamsOf(scan: Message): Beams {
  const { angleMin = 0, angleStep = 0, rangeMin = 0, rangeMax = 0, ranges = [] } = scan;
  const values = ranges as ArrayLike<number>;
  const rows = Math.max(Number(scan['verticalCount'] ?? 1), 1);
  const columns = Math.max(Number(scan['count'] ?? values.length), 1);
  const count = Math.min(rows * columns, values.length);
  const beams = {
    hits: new Float32Array(3 * count),
    hitLines: new Float32Array(6 * count),
    missLines: new Float32Array(6 * count),
  };
  let hits = 0;
  for (let i = 0; i < count; ++i) {
    const yaw = angleMin + (i % columns) * angleStep;
    const pitch = (scan['verticalAngleMin'] ?? 0) + Math.floor(i / columns) * (scan['verticalAngleStep'] ?? 0);
    const [x, y, z] = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
    const range = values[i]!;
    const isHit = Number.isFinite(range) && range >= rangeMin && range < rangeMax;
    // up to 10 m if the sensor has no maximum range
    const end = isHit ? range : Math.min(Number.isFinite(rangeMax) ? rangeMax : 10, 1000);
    const lines = isHit ? beams.hitLines : beams.missLines;
    lines.set([x * rangeMin, y * rangeMin, z * rangeMin, x * end, y * end, z * end], 6 * (isHit ? hits : i - hits));
    if (isHit) beams.hits.set([x * end, y * end, z * end], 3 * hits++);
  }
  return {
    hits: beams.hits.subarray(0, 3 * hits),
    hitLines: beams.hitLines.subarray(0, 6 * hits),
    missLines: beams.missLines.subarray(0, 6 * (count - hits)),
  };
}

/// The beams and hits of a lidar, drawn in the frame of the sensor.
export class Scan {
  readonly object = new Group();
  private readonly rays = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0x3060ff, transparent: true, opacity: 0.5, depthWrite: false }),
  );
  private readonly misses = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0x9090ff, transparent: true, opacity: 0.12, depthWrite: false }),
  );
  private readonly hits = new Points(
    new BufferGeometry(),
    new PointsMaterial({ color: 0xff2020, size: 5, sizeAttenuation: false }),
  );

  constructor() {
    this.object.add(this.misses, this.rays, this.hits);
    for (const part of this.object.children) part.frustumCulled = false;
  }

  set(scan: Message): void {
    const beams = beamsOf(scan);
    put(this.rays.geometry, beams.hitLines);
    put(this.misses.geometry, beams.missLines);
    put(this.hits.geometry, beams.hits);
    // the more beams, the more transparent, so that they do not hide the scene
    this.rays.material.opacity = Math.min(Math.max(100 / (beams.hits.length / 3), 0.08), 0.5);
  }

  dispose(): void {
    for (const { geometry, material } of [this.rays, this.misses, this.hits]) {
      geometry.dispose();
      material.dispose();
    }
  }
}

/// Overwrites a geometry's attribute; allocates a larger one if the values do not fit.
export function put(geometry: BufferGeometry, places: ArrayLike<number>, name = 'position'): void {
  const before = geometry.getAttribute(name);
  const count = places.length / 3;
  if (before !== undefined && before.array.length >= places.length) {
    (before.array as Float32Array).set(places);
    before.needsUpdate = true;
  } else {
    if (before !== undefined) geometry.dispose();
    // half as large again, for further growth
    const room = before === undefined ? places.length : 3 * Math.ceil(places.length / 2);
    const made = new Float32Array(room);
    made.set(places);
    geometry.setAttribute(name, new Float32BufferAttribute(made, 3));
  }
  geometry.setDrawRange(0, count);
}
