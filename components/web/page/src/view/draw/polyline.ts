import { BufferGeometry, ExtrudeGeometry, Path, Shape, ShapeUtils, Vector2 } from 'three';

type Line = { height?: number; point?: { x?: number; y?: number }[] };

/// The points of a closed line, without equal consecutive ones.
function pointsOf(line: Line): Vector2[] {
  const points = (line.point ?? []).map(({ x = 0, y = 0 }) => new Vector2(x, y));
  const last = points.at(-1);
  if (points.length > 1 && last !== undefined && points[0]?.equals(last)) points.pop();
  return points;
}

function holds(outline: Vector2[], { x, y }: Vector2): boolean {
  let isIn = false;
  outline.forEach((a, i) => {
    const b = outline[(i + 1) % outline.length]!;
    if (a.y > y !== b.y > y && x < ((b.x - a.x) * (y - a.y)) / (b.y - a.y) + a.x) isIn = !isIn;
  });
  return isIn;
}

/// The extrusion of closed lines from z = 0 upward. A line inside an odd number of others is a hole.
export function polylineGeometry(lines: Line[]): BufferGeometry {
  const outlines = lines.map(pointsOf).filter((points) => points.length > 2);
  const within = outlines.map((points) => outlines.filter((other) => other !== points && holds(other, points[0]!)));
  const shapes: Shape[] = [];
  outlines.forEach((points, i) => {
    if (within[i]!.length % 2 !== 0) return;
    const shape = new Shape(ShapeUtils.isClockWise(points) ? [...points].reverse() : points);
    outlines.forEach((hole, k) => {
      if (within[k]!.length === within[i]!.length + 1 && within[k]!.includes(points)) shape.holes.push(new Path(hole));
    });
    shapes.push(shape);
  });
  return new ExtrudeGeometry(shapes, { depth: lines[0]?.height ?? 1, bevelEnabled: false, curveSegments: 1 });
}
