import {
  Box3,
  BufferGeometry,
  Color,
  DynamicDrawUsage,
  Group,
  InstancedMesh,
  type Intersection,
  Matrix4,
  type PerspectiveCamera,
  type Raycaster,
} from 'three';

import { GeometryType } from '../messages.ts';
import type { Visual } from '../scene/content.ts';
import { contactLayer } from './contact_shadow.ts';
import { Crowd, crowdSize, sightOf } from './crowd.ts';
import { Materials, type Style } from './materials.ts';
import type { Paint } from './paint.ts';

/// A surface with its pose. A visual has one, or several if its mesh has several parts.
export interface Item {
  visual: Visual;
  geometry: BufferGeometry;
  geometryKey: string;
  paint: Paint;
  /// Transform from the geometry, including its scale, to the frame of the place.
  M_PlaceForm: Matrix4;
  isGround: boolean;
  castsShadows: boolean;
}

/// Items with the same geometry and material, drawn in one call (InstancedMesh).
class Batch {
  readonly items: Item[] = [];
  /// All items. Those of a crowd are drawn by the crowd, and this is not visible.
  mesh: InstancedMesh;
  crowd: Crowd | null = null;

  constructor(geometry: BufferGeometry, material: InstancedMesh['material'], castsShadows: boolean, isGround: boolean) {
    this.mesh = new InstancedMesh(geometry, material, 4);
    this.mesh.castShadow = castsShadows;
    if (castsShadows && !isGround) this.mesh.layers.enable(contactLayer);
    this.prepare();
  }

  private prepare(): void {
    this.mesh.count = this.items.length;
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.receiveShadow = true;
    // three would compute the bounds once, but they change with every pose
    this.mesh.frustumCulled = false;
    this.mesh.userData['batch'] = this;
  }

  /// @returns The item's index in this batch.
  add(item: Item, group: Group): number {
    const index = this.items.push(item) - 1;
    if (index >= this.mesh.instanceMatrix.count) this.grow(group);
    this.mesh.count = this.items.length;
    this.mesh.setColorAt(index, new Color(...item.paint.diffuse));
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
    return index;
  }

  private grow(group: Group): void {
    const before = this.mesh;
    this.mesh = new InstancedMesh(before.geometry, before.material, before.instanceMatrix.count * 2);
    this.mesh.castShadow = before.castShadow;
    this.mesh.layers.mask = before.layers.mask;
    this.mesh.instanceMatrix.array.set(before.instanceMatrix.array);
    const white = new Color(1, 1, 1);
    this.mesh.setColorAt(0, white);
    if (before.instanceColor) this.mesh.instanceColor?.array.set(before.instanceColor.array);
    this.prepare();
    group.remove(before);
    group.add(this.mesh);
    before.dispose();
  }
}

interface Seat {
  batch: Batch;
  index: number;
}

/// All visible surfaces of a scene. Per frame, only moving items cost anything: a matrix each.
export class Batches {
  readonly group = new Group();
  /// The items that are planes.
  readonly planes: Item[] = [];
  private readonly batches = new Map<string, Batch>();
  private readonly seats = new Map<number, { item: Item; seat: Seat }[]>();
  private readonly casters = new Map<number, Box3>();
  private readonly matrix = new Matrix4();

  constructor(private readonly materials: Materials) {}

  clear(): void {
    for (const { mesh, crowd } of this.batches.values()) {
      mesh.dispose();
      crowd?.dispose();
    }
    this.group.clear();
    this.planes.length = 0;
    this.batches.clear();
    this.seats.clear();
    this.casters.clear();
  }

  add(item: Item, style: Style, M_WorldPlace: Matrix4): void {
    if (item.paint.opacity <= 0) return;
    const isPlane = item.visual.geometry.type === GeometryType.plane;
    if (isPlane) this.planes.push(item);
    const castsShadows = item.castsShadows && !style.transparent && !style.wireframe;
    const key = `${item.geometryKey}|${castsShadows}|${this.materials.key(item.paint, style)}`;
    let batch = this.batches.get(key);
    if (batch === undefined) {
      batch = new Batch(item.geometry, this.materials.get(item.paint, style, isPlane), castsShadows, item.isGround);
      this.batches.set(key, batch);
      this.group.add(batch.mesh);
    }
    const index = batch.add(item, this.group);
    const seats = this.seats.get(item.visual.place) ?? [];
    seats.push({ item, seat: { batch, index } });
    this.seats.set(item.visual.place, seats);
    this.casters.delete(item.visual.place);
    this.put({ batch, index }, item, M_WorldPlace);
  }

  private put(seat: Seat, item: Item, M_WorldPlace: Matrix4): void {
    const { mesh } = seat.batch;
    mesh.setMatrixAt(seat.index, this.matrix.multiplyMatrices(M_WorldPlace, item.M_PlaceForm));
    mesh.instanceMatrix.needsUpdate = true;
    mesh.boundingSphere = null;
  }

  /// Chooses what is drawn of batches with many items, for a viewpoint.
  /// @param height Of the image [pixels].
  arrange(camera: PerspectiveCamera, height: number): void {
    const sight = sightOf(camera, height);
    for (const batch of this.batches.values()) {
      if (batch.items.length < crowdSize) continue;
      batch.crowd ??= new Crowd(batch.mesh, this.group);
      batch.crowd.arrange(batch.mesh, sight);
    }
  }

  /// Shows what casts the shadows of crowds, instead of what the viewpoint sees of them.
  /// @return Whether there are crowds.
  showCasters(on: boolean): boolean {
    let hasCrowds = false;
    for (const batch of this.batches.values()) {
      if (batch.items.length < crowdSize) continue;
      batch.crowd ??= new Crowd(batch.mesh, this.group);
      batch.crowd.showCasters(on, batch.mesh);
      hasCrowds = true;
    }
    return hasCrowds;
  }

  has(place: number): boolean {
    return this.seats.has(place);
  }

  /// Moves the items of a place to its pose.
  move(place: number, M_WorldPlace: Matrix4): void {
    for (const { item, seat } of this.seats.get(place) ?? []) this.put(seat, item, M_WorldPlace);
  }

  /// The ids of all places with items.
  places(): Iterable<number> {
    return this.seats.keys();
  }

  /// The items of a place.
  itemsOf(place: number): Item[] {
    return (this.seats.get(place) ?? []).map(({ item }) => item);
  }

  /// The intersections of a ray, nearest first.
  meet(ray: Raycaster): { item: Item; hit: Intersection }[] {
    return ray.intersectObjects([...this.batches.values()].map(({ mesh }) => mesh), false).flatMap((hit) => {
      const batch = hit.object.userData['batch'] as Batch | undefined;
      const item = batch?.items[hit.instanceId ?? -1];
      return item === undefined ? [] : [{ item, hit }];
    });
  }

  /// Bounding box of the items of a place, in its frame.
  boundsInPlace(place: number): Box3 {
    return boundsOf(this.seats.get(place) ?? [], () => true);
  }

  /// Bounding box of the items of a place that cast shadows, in its frame; not to be changed.
  castersInPlace(place: number): Readonly<Box3> {
    let box = this.casters.get(place);
    if (box === undefined) {
      box = boundsOf(this.seats.get(place) ?? [], (item) => item.castsShadows && !item.isGround);
      this.casters.set(place, box);
    }
    return box;
  }
}

function boundsOf(seats: { item: Item }[], isWanted: (item: Item) => boolean): Box3 {
  const box = new Box3();
  for (const { item } of seats) {
    if (!isWanted(item)) continue;
    if (item.geometry.boundingBox === null) item.geometry.computeBoundingBox();
    if (item.geometry.boundingBox) box.union(item.geometry.boundingBox.clone().applyMatrix4(item.M_PlaceForm));
  }
  return box;
}
