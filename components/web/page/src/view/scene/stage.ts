import { Box3, Color, Matrix4, type Mesh, SRGBColorSpace, Scene, ShaderChunk, type Sphere, Vector3 } from 'three';

import { groundGeometry, grayPictureOf } from '../assets/heightmap.ts';
import { Meshes } from '../assets/meshes.ts';
import { type MeshPart, mirrored } from '../assets/mesh_parts.ts';
import { Batches, type Item } from '../draw/batches.ts';
import { coarserOf } from '../draw/crowd.ts';
import { backdropOf, isUsual } from '../draw/backdrop.ts';
import { Lights, shadowRegion } from '../draw/lights.ts';
import { Materials, type Style, mirroredSky, withAttenuation } from '../draw/materials.ts';
import { type Paint, greyPaint, paintOf, rgbOf } from '../draw/paint.ts';
import { type Form, formOf } from '../draw/shapes.ts';
import { skyColors, skyDome } from '../draw/sky.ts';
import { type FetchAsset, Textures, words } from '../draw/textures.ts';
import { matrixOf, noPlacement, times, vectorOf } from '../maths/placement.ts';
import { type GeometryMessage, GeometryType, type SceneMessage } from '../messages.ts';
import type { Theme } from '../overlays/grid.ts';
import type { Surface } from '../overlays/silhouette.ts';
import { type Content, type Shape, type Visual, contentOf, isWithin } from './content.ts';
import { Places } from './places.ts';

// of the angle to the horizontal up to which a plane is ground on which bodies stand: half a degree
const levelCosine = 0.99996;

export interface StageOptions {
  asset: FetchAsset;
  /// Called when a new frame has to be drawn.
  changed(): void;
  problem(text: string): void;
  /// Returns the style of the visuals of a place.
  styleOf(place: number): Style;
}

/// The three.js scene: everything that is visible to cameras.
export class Stage {
  readonly root = new Scene();
  readonly places = new Places();
  readonly batches: Batches;
  readonly lights = new Lights();
  content: Content = contentOf({});
  private readonly textures: Textures;
  private readonly materials: Materials;
  private readonly meshes: Meshes;
  private readonly grounds = new Map<string, Promise<MeshPart[]>>();
  private readonly geometries = new Map<string, Mesh['geometry']>();
  private readonly reported = new Set<string>();
  private sky: Mesh | null = null;
  private surroundings: SceneMessage = {};
  private theme: Theme = 'light';
  private isAsCameras = false;
  private generation = 0;
  private casters = new Box3();
  private region: Sphere | null = null;
  private readonly matrix = new Matrix4();

  constructor(private readonly options: StageOptions) {
    this.textures = new Textures(options.asset, options.changed, (text) => this.report(text));
    this.materials = new Materials(this.textures, withAttenuation(ShaderChunk.lights_pars_begin));
    this.meshes = new Meshes(options.asset, (address, bytes) => this.textures.embed(address, bytes));
    this.batches = new Batches(this.materials);
    this.root.add(this.batches.group, this.lights.group);
  }

  dispose(): void {
    this.batches.clear();
    this.materials.dispose();
    this.textures.dispose();
    for (const geometry of this.geometries.values()) geometry.dispose();
  }

  /// Reports a problem, each text only once.
  private report(text: string): void {
    if (this.reported.has(text)) return;
    this.reported.add(text);
    this.options.problem(text);
  }

  setScene(scene: SceneMessage): void {
    this.content = contentOf(scene);
    this.meshes.retry();
    this.places.set(this.content.places);
    this.lights.setAmbient(scene.ambient);
    this.lights.set(this.content.lights, (id) => this.places.shown(id) ?? noPlacement());
    this.surroundings = scene;
    this.setSurroundings();
    this.restyle();
  }

  /// Sets the background of worlds that have none of their own, and whether everything is as the simulated cameras see it.
  setLook(theme: Theme, isAsCameras: boolean): void {
    this.theme = theme;
    this.isAsCameras = isAsCameras;
    this.lights.setAsCameras(isAsCameras);
    this.setSurroundings();
    this.options.changed();
  }

  private setSurroundings(): void {
    const { background: wanted, sky } = this.surroundings;
    // without a background, the grey of Fortress
    const rgb = wanted === undefined ? [0.7, 0.7, 0.7] : rgbOf(wanted);
    const [red = 0, green = 0, blue = 0] = rgb;
    const background = new Color().setRGB(red, green, blue, SRGBColorSpace);
    this.root.background = background;
    if (this.sky) this.root.remove(this.sky);
    this.sky?.geometry.dispose();
    const colors = sky ? skyColors(sky) : !this.isAsCameras && isUsual(rgb) ? backdropOf(this.theme) : null;
    this.sky = colors && skyDome(colors);
    mirroredSky.value.copy(sky === undefined ? background : skyColors(sky).horizon);
    if (this.sky) this.root.add(this.sky);
  }

  /// Creates all visuals anew, with their current styles.
  restyle(): void {
    ++this.generation;
    this.batches.clear();
    for (const visual of this.content.visuals) this.addVisual(visual);
    this.options.changed();
  }

  private addVisual(visual: Visual): void {
    const wanted = visual.material && paintOf(visual.material, visual.transparency);
    const { generation } = this;
    const add = (parts: MeshPart[]) => {
      if (generation !== this.generation) return;
      parts.forEach((part, i) => this.addPart(visual, part, i, wanted ?? fromFile(part.paint, visual.transparency)));
    };
    this.withParts(visual, `visual '${visual.name}'`, add, (form) => {
      const geometry = this.geometryOf(form);
      this.addItem(visual, geometry, form.key, form, wanted ?? fromFile(null, visual.transparency));
    });
  }

  private addPart(visual: Visual, part: MeshPart, index: number, paint: Paint): void {
    const { mesh } = visual.geometry;
    const scale = mesh?.scale === undefined ? new Vector3(1, 1, 1) : vectorOf(mesh.scale);
    const isMirrored = scale.x * scale.y * scale.z < 0;
    const key = `${fileKey(visual.geometry)}|${index}|${isMirrored}`;
    let geometry = this.geometries.get(key);
    if (geometry === undefined) {
      geometry = isMirrored ? mirrored(part.geometry) : part.geometry;
      this.geometries.set(key, geometry);
    }
    const isGround = visual.geometry.type === GeometryType.heightmap;
    this.addItem(visual, geometry, key, { scale, X_ShapeForm: noPlacement(), isGround }, paint);
  }

  private addItem(
    visual: Visual,
    geometry: Mesh['geometry'],
    geometryKey: string,
    form: Pick<Form, 'scale' | 'X_ShapeForm' | 'isGround'>,
    paint: Paint,
  ): void {
    const item: Item = {
      visual,
      geometry,
      geometryKey,
      paint,
      M_PlaceForm: matrixOf(times(visual.X_PlaceShape, form.X_ShapeForm), form.scale),
      isGround: form.isGround,
      castsShadows: visual.castsShadows,
    };
    const matrix = this.places.matrix(visual.place);
    if (matrix) this.batches.add(item, this.options.styleOf(visual.place), matrix);
    this.options.changed();
  }

  private geometryOf(form: Form): Mesh['geometry'] {
    let geometry = this.geometries.get(form.key);
    if (geometry === undefined) {
      geometry = form.make();
      if (form.makeCoarse) coarserOf.set(geometry, form.makeCoarse.map((make) => make()));
      this.geometries.set(form.key, geometry);
    }
    return geometry;
  }

  /// Calls `add` with the parts of a shape's file, at once or when it has been loaded, or `addForm` for other shapes.
  private withParts(shape: Shape, owner: string, add: (parts: MeshPart[]) => void, addForm: (form: Form) => void): void {
    const { geometry } = shape;
    const form = formOf(geometry);
    if (form !== null) {
      addForm(form);
      return;
    }
    const filename = geometry.mesh?.filename ?? geometry.heightmap?.filename ?? '';
    if (filename === '') return;
    const request = meshRequest(geometry);
    const known = request && this.meshes.known(request);
    if (known) {
      add(known);
      return;
    }
    (request ? this.meshes.get(request) : this.ground(geometry)).then(add, (error: unknown) => {
      this.report(`'${filename}' of ${owner} can't be shown: ${words(error)}`);
    });
  }

  private ground(geometry: GeometryMessage): Promise<MeshPart[]> {
    const key = fileKey(geometry);
    let known = this.grounds.get(key);
    if (known === undefined) {
      const { filename = '', size, origin } = geometry.heightmap ?? {};
      known = this.options
        .asset(filename)
        .then(grayPictureOf)
        .then((picture) => [{ geometry: groundGeometry(picture, vectorOf(size), vectorOf(origin)), paint: null }]);
      this.grounds.set(key, known);
    }
    return known;
  }

  /// Calls `add` with the geometry of a shape and its pose in the link's frame, for overlays.
  withShape(shape: Shape, owner: string, add: (geometry: Mesh['geometry'], M_PlaceForm: Matrix4) => void): void {
    const scale = shape.geometry.mesh?.scale;
    const M_PlaceShape = matrixOf(shape.X_PlaceShape, scale === undefined ? undefined : vectorOf(scale));
    const addAll = (parts: MeshPart[]) => parts.forEach(({ geometry }) => add(geometry, M_PlaceShape));
    this.withParts(shape, owner, addAll, (form) => {
      add(this.geometryOf(form), matrixOf(times(shape.X_PlaceShape, form.X_ShapeForm), form.scale));
    });
  }

  /// Moves all objects to their current poses.
  /// @returns The ids of places that have moved.
  moveMoved(): number[] {
    const ids = this.places.takeMoved();
    for (const id of ids) {
      const matrix = this.batches.has(id) ? this.places.matrix(id, this.matrix) : null;
      if (matrix) this.batches.move(id, matrix);
      const light = this.content.lights.has(id) ? this.places.shown(id) : null;
      if (light) this.lights.move(id, light);
    }
    return ids;
  }

  /// Fits the shadows to what casts them.
  /// @param hasMoved Whether anything has moved since the last call.
  /// @return Whether they have to be rendered again.
  aimShadows(target: Vector3, hasMoved: boolean): boolean {
    if (hasMoved) this.casters = this.boundsOfCasters();
    const region = shadowRegion(this.casters, target);
    const { region: before } = this;
    if (!hasMoved && (region === before || (region && before && region.equals(before)))) return false;
    this.region = region;
    this.lights.aimShadows(region);
    return true;
  }

  /// Where there are shadows; null: nowhere.
  get shadowed(): Sphere | null {
    return this.region;
  }

  /// The height of the largest horizontal plane; null: there is none.
  floorHeight(): number | null {
    let largest = 0;
    let height: number | null = null;
    for (const item of this.batches.planes) {
      const M_WorldPlace = this.places.matrix(item.visual.place, this.matrix);
      if (!M_WorldPlace) continue;
      const M_WorldForm = M_WorldPlace.multiply(item.M_PlaceForm);
      const [x, y, z] = [0, 1, 2].map((axis) => new Vector3().setFromMatrixColumn(M_WorldForm, axis)) as [Vector3, Vector3, Vector3];
      const area = x.cross(y).length();
      if (area <= largest || z.normalize().z < levelCosine) continue;
      largest = area;
      height = M_WorldForm.elements[14]!;
    }
    return height;
  }

  private boundsOfCasters(): Box3 {
    const casters = new Box3();
    const box = new Box3();
    for (const place of this.batches.places()) {
      const inPlace = this.batches.castersInPlace(place);
      const matrix = inPlace.isEmpty() ? null : this.places.matrix(place, this.matrix);
      if (matrix) casters.union(box.copy(inPlace).applyMatrix4(matrix));
    }
    return casters;
  }

  /// The visible surfaces of an entity with its parts.
  surfacesOf(entity: number): Surface[] {
    return [...this.batches.places()]
      .filter((place) => isWithin(this.content.places, place, entity))
      .flatMap((place) => this.batches.itemsOf(place).map(({ geometry, M_PlaceForm }) => {
        const M_WorldPlace = this.places.matrix(place) ?? new Matrix4();
        return { geometry, M_WorldForm: new Matrix4().multiplyMatrices(M_WorldPlace, M_PlaceForm) };
      }));
  }

  /// Bounding box of the visible parts of an entity, in the given frame; a small box if it has none.
  boundsOf(entity: number, X_WorldFrame = noPlacement()): Box3 {
    const M_FrameWorld = matrixOf(X_WorldFrame).invert();
    const box = new Box3();
    for (const place of this.batches.places()) {
      if (!isWithin(this.content.places, place, entity)) continue;
      const matrix = this.places.matrix(place);
      const inPlace = this.batches.boundsInPlace(place);
      if (matrix && !inPlace.isEmpty()) box.union(inPlace.applyMatrix4(matrix.premultiply(M_FrameWorld)));
    }
    const position = this.places.position(entity)?.clone();
    if (box.isEmpty() && position) {
      box.setFromCenterAndSize(position.applyMatrix4(M_FrameWorld), new Vector3(0.2, 0.2, 0.2));
    }
    return box;
  }
}

/// The appearance of a part of a mesh file.
function fromFile(paint: Paint | null, transparency: number): Paint {
  const base = paint ?? greyPaint;
  return { ...base, opacity: base.opacity * Math.min(Math.max(1 - transparency, 0), 1) };
}

function meshRequest(geometry: GeometryMessage): { filename: string; submesh: string; isCentered: boolean } | null {
  if (geometry.type !== GeometryType.mesh) return null;
  const { filename = '', submesh = '', centerSubmesh = false } = geometry.mesh ?? {};
  return { filename, submesh, isCentered: centerSubmesh };
}

/// A key that is equal for shapes with the same geometry from files.
function fileKey(geometry: GeometryMessage): string {
  const request = meshRequest(geometry);
  return request ? Meshes.key(request) : JSON.stringify(geometry.heightmap);
}
