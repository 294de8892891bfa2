import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';

import { type Placement, noPlacement, vectorOf } from '../maths/placement.ts';
import { type GeometryMessage, GeometryType } from '../messages.ts';
import { polylineGeometry } from './polyline.ts';

// number of segments: the deviation from a circle is at most 1 - cos(pi / 48) = 0.2 % of the radius
const sectors = 48;
/// Numbers of segments for shapes that are small on the screen. The deviation is a third of a pixel where the radius is at
/// most that many pixels.
export const coarseLevels = [
  { sectors: 24, radius: 40 },
  { sectors: 12, radius: 10 },
  { sectors: 8, radius: 4 },
];

/// A shape to draw: a geometry, shared by equal shapes, and its transformation.
export interface Form {
  /// Equal for shapes with the same geometry.
  key: string;
  make(): BufferGeometry;
  /// The geometries for `coarseLevels`; none if it has few triangles anyway.
  makeCoarse?: (() => BufferGeometry)[];
  /// Scale along the axes of the geometry, applied before the rotation.
  scale: Vector3;
  X_ShapeForm: Placement;
  /// Whether it is ground, on which other objects stand.
  isGround: boolean;
}

function form(key: string, make: () => BufferGeometry, scale = new Vector3(1, 1, 1)): Form {
  return { key, make, scale, X_ShapeForm: noPlacement(), isGround: false };
}

/// A shape whose geometry has a number of segments around z.
function round(key: string, scale: Vector3, make: (sectors: number) => BufferGeometry): Form {
  const upright = (count: number) => make(count).rotateX(Math.PI / 2);
  return { ...form(key, () => upright(sectors), scale), makeCoarse: coarseLevels.map((level) => () => upright(level.sectors)) };
}

/// @returns Null for shapes from files (mesh, heightmap), for empty ones, and for images, which the cameras do not
/// render.
export function formOf(geometry: GeometryMessage): Form | null {
  switch (geometry.type ?? GeometryType.box) {
    case GeometryType.box:
      return form('box', () => new BoxGeometry(), vectorOf(geometry.box?.size));
    case GeometryType.sphere: {
      const radius = geometry.sphere?.radius ?? 0;
      return round('sphere', new Vector3(radius, radius, radius), unitSphere);
    }
    case GeometryType.ellipsoid:
      return round('sphere', vectorOf(geometry.ellipsoid?.radii), unitSphere);
    case GeometryType.cylinder: {
      const { radius = 0, length = 0 } = geometry.cylinder ?? {};
      return round('cylinder', new Vector3(radius, radius, length), (count) => new CylinderGeometry(1, 1, 1, count));
    }
    case GeometryType.cone: {
      const { radius = 0, length = 0 } = geometry.cone ?? {};
      return round('cone', new Vector3(radius, radius, length), (count) => new ConeGeometry(1, 1, count));
    }
    case GeometryType.capsule: {
      const { radius = 0, length = 0 } = geometry.capsule ?? {};
      const make = (count: number) => new CapsuleGeometry(radius, length, count / 4, count);
      return round(`capsule ${radius} ${length}`, new Vector3(1, 1, 1), make);
    }
    case GeometryType.plane:
      return plane(geometry);
    case GeometryType.polyline: {
      const lines = geometry.polyline ?? [];
      return lines.length === 0 ? null : form(`polyline ${JSON.stringify(lines)}`, () => polylineGeometry(lines));
    }
    default:
      return null;
  }
}

function unitSphere(count: number): BufferGeometry {
  return new SphereGeometry(1, count, count / 2);
}

function plane(geometry: GeometryMessage): Form {
  const normal = vectorOf(geometry.plane?.normal);
  if (normal.lengthSq() === 0) normal.set(0, 0, 1);
  const size = geometry.plane?.size ?? {};
  const rotation = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), normal.normalize());
  return {
    key: 'plane',
    make: () => new PlaneGeometry(),
    scale: new Vector3(Math.abs(size.x ?? 1), Math.abs(size.y ?? 1), 1),
    X_ShapeForm: { position: new Vector3(), rotation },
    isGround: true,
  };
}
