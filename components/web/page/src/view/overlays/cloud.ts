import { BufferGeometry, Float32BufferAttribute, Points, PointsMaterial } from 'three';

import type { Message } from '../messages.ts';
import { put } from './scan.ts';

// limit of displayed points, above what a screen can resolve
const mostPoints = 300_000;

// ignition.msgs.PointCloudPacked.Field.DataType
const float32 = 6;

export interface CloudPoints {
  /// Positions in the frame of the cloud [m]: x, y, z per point.
  places: Float32Array;
  /// Red, green and blue per point, from 0 to 1.
  colors: Float32Array;
}

/// The points of an ignition.msgs.PointCloudPacked with finite coordinates; every n-th one of a large cloud.
export function pointsOf(cloud: Message): CloudPoints {
  const none = { places: new Float32Array(), colors: new Float32Array() };
  const data = cloud['data'] as Uint8Array | undefined;
  const step = Number(cloud['pointStep'] ?? 0);
  const offset = (name: string): number | undefined => {
    const fields = (cloud['field'] ?? []) as { name?: string; offset?: number; datatype?: number }[];
    const field = fields.find((each) => each.name === name);
    const end = (field?.offset ?? 0) + 4;
    return field?.datatype === float32 && end <= step ? (field.offset ?? 0) : undefined;
  };
  const [x, y, z, rgb] = [offset('x'), offset('y'), offset('z'), offset('rgb')];
  if (data === undefined || step === 0 || x === undefined || y === undefined || z === undefined) return none;
  const isLittle = cloud['isBigendian'] !== true;
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const total = Math.min(Math.floor(data.byteLength / step), Number(cloud['width'] ?? 0) * Number(cloud['height'] ?? 0));
  const stride = Math.max(Math.ceil(total / mostPoints), 1);
  const places = new Float32Array(Math.ceil(total / stride) * 3);
  const colors = new Float32Array(places.length);
  let end = 0;
  for (let i = 0; i < total; i += stride) {
    const at = i * step;
    const place = [view.getFloat32(at + x, isLittle), view.getFloat32(at + y, isLittle), view.getFloat32(at + z, isLittle)];
    if (!place.every(Number.isFinite)) continue;
    places.set(place, end);
    if (rgb === undefined) colors.set(distanceColor(Math.hypot(...place)), end);
    else colors.set(packedColor(view.getUint32(at + rgb, isLittle)), end);
    end += 3;
  }
  return { places: places.subarray(0, end), colors: colors.subarray(0, end) };
}

/// Unpacks a colour as in ROS: 0x00rrggbb in the bits of a float.
function packedColor(bits: number): [number, number, number] {
  return [((bits >> 16) & 255) / 255, ((bits >> 8) & 255) / 255, (bits & 255) / 255];
}

/// A colour for a distance: from red (near) over green to blue (far), repeated every 10 m.
function distanceColor(distance: number): [number, number, number] {
  const hue = (distance / 10) % 1;
  const wave = (shift: number) => 0.5 + 0.5 * Math.cos(2 * Math.PI * (hue - shift));
  return [wave(0), wave(1 / 3), wave(2 / 3)];
}

/// A point cloud, drawn in its own frame.
export class Cloud {
  readonly object = new Points(
    new BufferGeometry(),
    new PointsMaterial({ vertexColors: true, size: 3, sizeAttenuation: false }),
  );

  constructor() {
    this.object.frustumCulled = false;
    this.object.geometry.setAttribute('position', new Float32BufferAttribute([], 3));
  }

  set(cloud: Message): void {
    const { places, colors } = pointsOf(cloud);
    put(this.object.geometry, places);
    put(this.object.geometry, colors, 'color');
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}
