import { Vector3 } from 'three';

import { type Placement, noPlacement, placementOf, times, vectorOf } from '../maths/placement.ts';
import type {
  AxisMessage,
  GeometryMessage,
  InertialMessage,
  LightMessage,
  LinkMessage,
  MaterialMessage,
  ModelMessage,
  SceneMessage,
  VisualMessage,
} from '../messages.ts';

/// An entity with a pose: a model, a link, a light or a sensor.
export interface Place {
  id: number;
  name: string;
  kind: 'model' | 'link' | 'light' | 'sensor';
  /// Id of the parent entity; 0 for the world.
  parent: number;
  /// Id of the top-level model that contains it or is it; 0 if there is none.
  model: number;
  X_ParentPlace: Placement;
  X_WorldPlace: Placement;
}

/// A visual or collision, in the frame of a place.
export interface Shape {
  id: number;
  name: string;
  place: number;
  X_PlaceShape: Placement;
  geometry: GeometryMessage;
}

export interface Visual extends Shape {
  material: MaterialMessage | undefined;
  castsShadows: boolean;
  /// From 0 (opaque) to 1 (invisible).
  transparency: number;
}

export interface Inertial {
  place: number;
  inertial: InertialMessage;
}

export interface Joint {
  id: number;
  name: string;
  type: number;
  /// Id of the child link, in whose frame the joint's pose is.
  place: number;
  X_PlaceJoint: Placement;
  axes: AxisMessage[];
}

/// A parsed scene message: lists by kind, with poses.
export interface Content {
  places: Map<number, Place>;
  visuals: Visual[];
  collisions: Shape[];
  inertials: Inertial[];
  joints: Joint[];
  /// Keyed by the id of the light's place.
  lights: Map<number, LightMessage>;
}

/// Parses a scene message. Entities without an id are ignored.
export function contentOf(scene: SceneMessage): Content {
  const content: Content = {
    places: new Map(),
    visuals: [],
    collisions: [],
    inertials: [],
    joints: [],
    lights: new Map(),
  };
  for (const model of scene.model ?? []) addModel(model, null, content);
  for (const light of scene.light ?? []) addLight(light, null, content);
  return content;
}

function addPlace(
  from: { id?: number; name?: string; pose?: ModelMessage['pose'] },
  kind: Place['kind'],
  parent: Place | null,
  content: Content,
): Place | null {
  const id = Number(from.id ?? 0);
  // a second entity with the same id could make the tree cyclic
  if (id === 0 || content.places.has(id)) return null;
  const X_ParentPlace = placementOf(from.pose);
  const place: Place = {
    id,
    name: from.name ?? '',
    kind,
    parent: parent?.id ?? 0,
    model: parent?.model || (kind === 'model' ? id : 0),
    X_ParentPlace,
    X_WorldPlace: times(parent?.X_WorldPlace ?? noPlacement(), X_ParentPlace),
  };
  content.places.set(id, place);
  return place;
}

function addModel(message: ModelMessage, parent: Place | null, content: Content): void {
  const model = addPlace(message, 'model', parent, content);
  if (model === null) return;
  addVisuals(message.visual, model, content);
  const links = new Map<string, number>();
  for (const inner of message.model ?? []) {
    addModel(inner, model, content);
    for (const link of inner.link ?? []) links.set(`${inner.name}::${link.name}`, Number(link.id ?? 0));
  }
  for (const link of message.link ?? []) {
    addLink(link, model, content);
    links.set(link.name ?? '', Number(link.id ?? 0));
  }
  for (const joint of message.joint ?? []) {
    const child = joint.childId || links.get(joint.child ?? '');
    if (!child) continue;
    content.joints.push({
      id: Number(joint.id ?? 0),
      name: joint.name ?? '',
      type: joint.type ?? 0,
      place: child,
      X_PlaceJoint: placementOf(joint.pose),
      axes: [joint.axis1, joint.axis2].filter((axis) => axis !== undefined),
    });
  }
}

function addLink(message: LinkMessage, model: Place, content: Content): void {
  const link = addPlace(message, 'link', model, content);
  if (link === null) return;
  addVisuals(message.visual, link, content);
  for (const collision of message.collision ?? []) {
    if (collision.geometry !== undefined) content.collisions.push(shapeOf(collision, collision.geometry, link));
  }
  if (message.inertial !== undefined) content.inertials.push({ place: link.id, inertial: message.inertial });
  for (const light of message.light ?? []) addLight(light, link, content);
  for (const sensor of message.sensor ?? []) addPlace(sensor, 'sensor', link, content);
}

function shapeOf(from: Pick<VisualMessage, 'id' | 'name' | 'pose'>, geometry: GeometryMessage, place: Place): Shape {
  return {
    id: Number(from.id ?? 0),
    name: from.name ?? '',
    place: place.id,
    X_PlaceShape: placementOf(from.pose),
    geometry,
  };
}

function addVisuals(visuals: VisualMessage[] | undefined, place: Place, content: Content): void {
  for (const visual of visuals ?? []) {
    if (visual.geometry === undefined) continue;
    content.visuals.push({
      ...shapeOf(visual, visual.geometry, place),
      material: visual.material,
      castsShadows: visual.castShadows ?? false,
      transparency: visual.transparency ?? 0,
    });
  }
}

/// Whether a light is off. Fortress stores that in the message's header, as `isLightOn`.
function isOff(light: LightMessage): boolean {
  return light.header?.data?.some(({ key, value }) => key === 'isLightOn' && value?.[0] === '0') ?? false;
}

function addLight(message: LightMessage, parent: Place | null, content: Content): void {
  const place = addPlace(message, 'light', parent, content);
  if (place !== null && !isOff(message)) content.lights.set(place.id, message);
}

/// Whether `place` is `outer`, or is contained in it.
export function isWithin(places: ReadonlyMap<number, Place>, place: number, outer: number): boolean {
  for (let id = place; id !== 0; id = places.get(id)?.parent ?? 0) if (id === outer) return true;
  return false;
}

/// The scoped name of a place, such as "pong_bot::chassis::lidar": messages use it for frames.
export function fullName(places: ReadonlyMap<number, Place>, id: number): string {
  const names: string[] = [];
  for (let place = places.get(id); place !== undefined; place = places.get(place.parent)) names.unshift(place.name);
  return names.join('::');
}

/// Direction of a light, in the light's frame.
export function lightDirection(light: LightMessage): Vector3 {
  const direction = vectorOf(light.direction);
  return direction.lengthSq() > 0 ? direction.normalize() : new Vector3(0, 0, -1);
}
