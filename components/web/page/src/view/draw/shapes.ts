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
const rings = 24;

/// A shape to draw: a geometry, shared by equal shapes, and its transformation.
export interface Form {
  /// Equal for shapes with the same geometry.
  key: string;
  make(): BufferGeometry;
  /// Scale along the axes of the geometry, applied before the rotation.
  scale: Vector3;
  X_ShapeForm: Placement;
  /// Whether it is ground, on which other objects stand.
  isGround: boolean;
}

function form(key: string, make: () => BufferGeometry, scale = new Vector3(1, 1, 1)): Form {
  return { key, make, scale, X_ShapeForm: noPlacement(), isGround: false };
}

function round(key: string, radius: number, length: number, make: () => BufferGeometry): Form {
  return form(key, () => make().rotateX(Math.PI / 2), new Vector3(radius, radius, length));
}

/// @returns Null for shapes from files (mesh, heightmap), for empty ones, and for images, which the cameras do not
/// render.
export function formOf(geometry: GeometryMessage): Form | null {
  switch (geometry.type ?? GeometryType.box) {
    case GeometryType.box:
      return form('box', () => new BoxGeometry(), vectorOf(geometry.box?.size));
    case GeometryType.sphere: {
      const radius = geometry.sphere?.radius ?? 0;
      return form('sphere', unitSphere, new Vector3(radius, radius, radius));
    }
    case GeometryType.ellipsoid:
      return form('sphere', unitSphere, vectorOf(geometry.ellipsoid?.radii));
    case GeometryType.cylinder: {
      const { radius = 0, length = 0 } = geometry.cylinder ?? {};
      return round('cylinder', radius, length, () => new CylinderGeometry(1, 1, 1, sectors));
    }
    case GeometryType.cone: {
      const { radius = 0, length = 0 } = geometry.cone ?? {};
      return round('cone', radius, length, () => new ConeGeometry(1, 1, sectors));
    }
    case GeometryType.capsule: {
      const { radius = 0, length = 0 } = geometry.capsule ?? {};
      const make = () => new CapsuleGeometry(radius, length, rings / 2, sectors).rotateX(Math.PI / 2);
      return form(`capsule ${radius} ${length}`, make);
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

function unitSphere(): BufferGeometry {
  return new SphereGeometry(1, sectors, rings).rotateX(Math.PI / 2);
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
