import {
  BufferGeometry,
  CanvasTexture,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  type Material,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  Points,
  PointsMaterial,
  Quaternion,
  Sprite,
  SpriteMaterial,
  Vector3,
} from 'three';

import { formOf } from '../draw/shapes.ts';
import { type Placement, matrixOf, noPlacement, placementOf, vectorOf } from '../maths/placement.ts';
import { type ColorMessage, type GeometryMessage, GeometryType, type Message, type VectorMessage } from '../messages.ts';
import { type Content, fullName } from '../scene/content.ts';
import type { Stage } from '../scene/stage.ts';

/// ignition.msgs.Marker.Type
enum MarkerType {
  box = 1,
  cylinder = 2,
  lineStrip = 3,
  lineList = 4,
  points = 5,
  sphere = 6,
  text = 7,
  triangleFan = 8,
  triangleList = 9,
  triangleStrip = 10,
  cone = 11,
  arrow = 12,
  axis = 13,
  capsule = 14,
  ellipsoid = 15,
}

// height of a letter in the picture of a text [pixels]
const letterPixels = 48;

/// The shapes of size 1, as the cameras draw them.
const shapes: Partial<Record<MarkerType, GeometryMessage>> = {
  [MarkerType.box]: { type: GeometryType.box, box: { size: { x: 1, y: 1, z: 1 } } },
  [MarkerType.cylinder]: { type: GeometryType.cylinder, cylinder: { radius: 0.5, length: 1 } },
  [MarkerType.sphere]: { type: GeometryType.sphere, sphere: { radius: 0.5 } },
  [MarkerType.ellipsoid]: { type: GeometryType.sphere, sphere: { radius: 0.5 } },
  [MarkerType.cone]: { type: GeometryType.cone, cone: { radius: 0.5, length: 1 } },
  [MarkerType.capsule]: { type: GeometryType.capsule, capsule: { radius: 0.5, length: 1 } },
};

/// Indices of the ends of lines, or of the corners of triangles, of `count` points. What is left over is not drawn.
export function cornersOf(type: number, count: number): number[] {
  const corners: number[] = [];
  if (type === MarkerType.lineList) for (let i = 0; i + 1 < count; i += 2) corners.push(i, i + 1);
  if (type === MarkerType.lineStrip) for (let i = 0; i + 1 < count; ++i) corners.push(i, i + 1);
  if (type === MarkerType.triangleList) for (let i = 0; i + 2 < count; i += 3) corners.push(i, i + 1, i + 2);
  if (type === MarkerType.triangleStrip) for (let i = 0; i + 2 < count; ++i) corners.push(i, i + 1, i + 2);
  if (type === MarkerType.triangleFan) for (let i = 1; i + 1 < count; ++i) corners.push(0, i, i + 1);
  return corners;
}

function lookOf(marker: Message): { color: Color; transparent: boolean; opacity: number } {
  const { r = 0, g = 0, b = 0, a = 1 } = (marker['material']?.diffuse ?? { r: 1, g: 1, b: 1 }) as ColorMessage;
  return { color: new Color(r, g, b), transparent: a < 1, opacity: a };
}

/// A mesh of a simple shape, at a place in the frame of the marker.
function shapeMesh(type: MarkerType, material: Material, place = new Matrix4()): Object3D {
  const form = formOf(shapes[type]!)!;
  const mesh = new Mesh(form.make(), material);
  mesh.matrixAutoUpdate = false;
  mesh.matrix.multiplyMatrices(place, matrixOf(form.X_ShapeForm, form.scale));
  return mesh;
}

/// Along z: a shaft 0.5 long and 0.05 thick, and a head 0.25 long and 0.1 thick.
function arrow(material: Material, rotation = new Quaternion()): Object3D[] {
  const part = (type: MarkerType, middle: number, thickness: number, length: number): Object3D => {
    const place = new Matrix4().compose(new Vector3(0, 0, middle), new Quaternion(), new Vector3(thickness, thickness, length));
    return shapeMesh(type, material, place.premultiply(new Matrix4().makeRotationFromQuaternion(rotation)));
  };
  return [part(MarkerType.cylinder, 0.25, 0.05, 0.5), part(MarkerType.cone, 0.625, 0.1, 0.25)];
}

function textSprite(marker: Message): Sprite {
  const text = (marker['text'] ?? '') as string;
  const canvas = document.createElement('canvas');
  const font = `${letterPixels}px monospace`;
  const context = canvas.getContext('2d')!;
  context.font = font;
  canvas.width = Math.max(1, Math.min(4096, Math.ceil(context.measureText(text).width)));
  canvas.height = Math.ceil(letterPixels * 1.25);
  // a new size has reset it
  context.font = font;
  context.textBaseline = 'middle';
  context.fillStyle = '#fff';
  context.fillText(text, 0, canvas.height / 2);
  const look = lookOf(marker);
  const sprite = new Sprite(new SpriteMaterial({ ...look, map: new CanvasTexture(canvas), transparent: true }));
  sprite.scale.set(canvas.width / letterPixels, canvas.height / letterPixels, 1);
  return sprite;
}

/// What is drawn of a marker, before it is scaled.
function partsOf(marker: Message): Object3D[] {
  const type = (marker['type'] ?? 0) as MarkerType;
  const look = lookOf(marker);
  const points = ((marker['point'] ?? []) as VectorMessage[]).map(vectorOf);
  if (shapes[type]) return [shapeMesh(type, new MeshBasicMaterial({ ...look, side: DoubleSide }))];
  if (type === MarkerType.text) return [textSprite(marker)];
  if (type === MarkerType.arrow) return arrow(new MeshBasicMaterial(look));
  if (type === MarkerType.axis) {
    return [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].flatMap((along) =>
      arrow(
        new MeshBasicMaterial({ ...look, color: new Color(along.x, along.y, along.z) }),
        new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), along),
      ),
    );
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(points.flatMap((point) => point.toArray()), 3));
  if (type === MarkerType.points) return [new Points(geometry, new PointsMaterial({ ...look, size: 3, sizeAttenuation: false }))];
  geometry.setIndex(cornersOf(type, points.length));
  const isLine = type === MarkerType.lineList || type === MarkerType.lineStrip;
  if (isLine) return [new LineSegments(geometry, new LineBasicMaterial(look))];
  return [new Mesh(geometry, new MeshBasicMaterial({ ...look, side: DoubleSide }))];
}

function dispose(object: Object3D): void {
  object.traverse((part) => {
    const { geometry, material } = part as Partial<Mesh>;
    geometry?.dispose();
    const own = material as (Material & { map?: CanvasTexture | null }) | undefined;
    own?.map?.dispose();
    own?.dispose();
  });
}

/// A frame in which markers may be: of a place, or of a visual in it.
interface Parent {
  place: number;
  X_PlaceParent: Placement;
}

/// By full names. A place hides a visual of the same name, and the first of several hides the others.
function parentsOf({ places, visuals }: Content): Map<string, Parent> {
  const parents = new Map<string, Parent>();
  const names = new Map<number, string>();
  const add = (name: string, parent: Parent) => void (parents.has(name) || parents.set(name, parent));
  for (const id of places.keys()) {
    const name = fullName(places, id);
    names.set(id, name);
    add(name, { place: id, X_PlaceParent: noPlacement() });
  }
  for (const { name, place, X_PlaceShape } of visuals) add(`${names.get(place)}::${name}`, { place, X_PlaceParent: X_PlaceShape });
  return parents;
}

function parentOf(marker: Message): string {
  return (marker['parent'] ?? '') as string;
}

/// Markers (ignition.msgs.Marker), in the world or in the frame of their parents.
export class Markers {
  readonly group = new Group();
  private all = new Map<string, { marker: Message; object: Group }>();
  /// Those of the scene in which they were last looked up.
  private parents: { content: Content; byName: Map<string, Parent> } | null = null;

  constructor(private readonly stage: Stage) {}

  /// Shows these markers instead of the current ones.
  set(markers: ReadonlyMap<string, Message>): void {
    const before = this.all;
    this.all = new Map();
    for (const [key, marker] of markers) {
      const known = before.get(key);
      if (known?.marker === marker) {
        this.all.set(key, known);
        before.delete(key);
      } else {
        this.all.set(key, { marker, object: this.make(marker) });
      }
    }
    for (const { object } of before.values()) {
      this.group.remove(object);
      dispose(object);
    }
  }

  /// Moves them with their parents.
  update(): void {
    for (const { marker, object } of this.all.values()) if (parentOf(marker) !== '') this.place(marker, object);
  }

  dispose(): void {
    this.set(new Map());
  }

  private make(marker: Message): Group {
    const object = new Group();
    object.matrixAutoUpdate = false;
    const parts = partsOf(marker);
    if (parts.length > 0) object.add(...parts);
    this.group.add(object);
    this.place(marker, object);
    return object;
  }

  private place(marker: Message, object: Group): void {
    const parent = this.matrixOfParent(parentOf(marker));
    object.visible = parent !== null;
    if (parent === null) return;
    const scale = marker['scale'] === undefined ? new Vector3(1, 1, 1) : vectorOf(marker['scale']);
    object.matrix.multiplyMatrices(parent, matrixOf(placementOf(marker['pose']), scale));
    object.updateMatrixWorld(true);
  }

  /// Null if there is no such model, link or visual.
  private matrixOfParent(name: string): Matrix4 | null {
    if (name === '') return new Matrix4();
    const { content } = this.stage;
    if (this.parents?.content !== content) this.parents = { content, byName: parentsOf(content) };
    const parent = this.parents.byName.get(name);
    const matrix = parent && this.stage.places.matrix(parent.place);
    return matrix ? matrix.multiply(matrixOf(parent.X_PlaceParent)) : null;
  }
}
