import {
  Box3,
  BufferGeometry,
  Color,
  Material,
  Mesh,
  MeshPhongMaterial,
  type Object3D,
  PropertyBinding,
  Texture,
  Vector3,
} from 'three';

import { type Paint, type Rgb, greyPaint } from '../draw/paint.ts';

/// A part of a mesh file with one material.
export interface MeshPart {
  geometry: BufferGeometry;
  /// The material of the file; null if it has none.
  paint: Paint | null;
}

export interface PartOptions {
  /// Name of the only submesh to use; empty: all.
  submesh: string;
  /// Whether to move the centre of the submesh to the origin.
  isCentered: boolean;
  /// Whether the loader has converted the file's colours from sRGB. The simulator takes them as linear.
  hasScreenColors: boolean;
  /// Whether texture coordinates start at the top of the image.
  hasTexelsFromTop: boolean;
}

/// Splits the result of a three.js loader into parts, and applies the nodes' transformations.
export function partsOf(root: Object3D, options: PartOptions): MeshPart[] {
  root.updateMatrixWorld(true);
  const parts: MeshPart[] = [];
  root.traverse((node) => {
    if (!(node instanceof Mesh) || !isWanted(node, options.submesh)) return;
    const materials: Material[] = Array.isArray(node.material) ? node.material : [node.material];
    const whole = placed(node);
    materials.forEach((material, index) => {
      const geometry = materials.length === 1 ? whole : ofGroup(whole, index);
      if (geometry === null || (geometry.index ?? geometry.getAttribute('position')).count === 0) return;
      if (options.hasTexelsFromTop) turnTexels(geometry);
      parts.push({ geometry, paint: paintOfFile(material, options.hasScreenColors) });
    });
  });
  if (options.isCentered && options.submesh !== '') center(parts);
  return parts;
}

function isWanted(mesh: Mesh, submesh: string): boolean {
  if (submesh === '') return true;
  // the submesh's name as in the file, or as changed by three's loaders
  const names = [mesh.name, mesh.geometry.name, mesh.parent?.name, mesh.userData['name'] as string | undefined];
  return names.includes(submesh) || names.includes(PropertyBinding.sanitizeNodeName(submesh));
}

function placed(mesh: Mesh): BufferGeometry {
  let geometry = mesh.geometry.clone();
  if (geometry.getAttribute('normal') === undefined) {
    if (geometry.index) geometry = geometry.toNonIndexed();
    geometry.computeVertexNormals();
  }
  for (const name of Object.keys(geometry.attributes)) {
    if (!['position', 'normal', 'uv'].includes(name)) geometry.deleteAttribute(name);
  }
  geometry.morphAttributes = {};
  geometry.applyMatrix4(mesh.matrixWorld);
  return mesh.matrixWorld.determinant() < 0 ? mirrored(geometry) : geometry;
}

/// A copy whose triangles face the other way (reversed winding).
export function mirrored(geometry: BufferGeometry): BufferGeometry {
  const made = geometry.clone();
  const count = (made.index ?? made.getAttribute('position')).count;
  const corners = Array.from({ length: count }, (_, i) => made.index?.getX(i) ?? i);
  for (let i = 0; i + 2 < count; i += 3) [corners[i + 1], corners[i + 2]] = [corners[i + 2]!, corners[i + 1]!];
  made.setIndex(corners);
  return made;
}

/// The triangles of a geometry with this material index; null if there are none.
function ofGroup(geometry: BufferGeometry, material: number): BufferGeometry | null {
  const corners: number[] = [];
  for (const group of geometry.groups) {
    if (group.materialIndex !== material) continue;
    const end = Math.min(group.start + group.count, (geometry.index ?? geometry.getAttribute('position')).count);
    for (let i = group.start; i < end; ++i) corners.push(geometry.index?.getX(i) ?? i);
  }
  if (corners.length === 0) return null;
  const part = geometry.clone();
  part.clearGroups();
  part.setIndex(corners);
  return part;
}

function turnTexels(geometry: BufferGeometry): void {
  const texels = geometry.getAttribute('uv');
  for (let i = 0; texels !== undefined && i < texels.count; ++i) texels.setY(i, 1 - texels.getY(i));
}

function center(parts: MeshPart[]): void {
  const box = new Box3();
  for (const { geometry } of parts) {
    geometry.computeBoundingBox();
    if (geometry.boundingBox) box.union(geometry.boundingBox);
  }
  const middle = box.getCenter(new Vector3());
  for (const { geometry } of parts) geometry.translate(-middle.x, -middle.y, -middle.z);
}

/// A texture that is referenced in a file. It is fetched when it is drawn.
export function namedPicture(addresses: string): Texture {
  const texture = new Texture();
  texture.userData['addresses'] = addresses;
  return texture;
}

function paintOfFile(material: Material, hasScreenColors: boolean): Paint | null {
  const { color, specular, emissive, map } = material as Partial<MeshPhongMaterial>;
  // the loaders add a default material if the file has none
  if (color === undefined || material.userData['isDefault'] === true) return null;
  const share = (value: Color | undefined): Rgb => {
    if (value === undefined) return [0, 0, 0];
    const { r, g, b } = hasScreenColors ? value.clone().convertLinearToSRGB() : value;
    return [r, g, b];
  };
  const addresses = (map?.userData['addresses'] as string | undefined) ?? '';
  return {
    ...greyPaint,
    diffuse: share(color),
    specular: share(specular),
    emissive: share(emissive),
    colorMap: addresses,
  };
}
