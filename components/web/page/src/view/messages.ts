/// The message fields that the view reads. Any of them may be missing: the decoder omits unset messages, and returns 0
/// for unset numbers.

/// A message as decoded by the connection (@bufbuild/protobuf, by reflection): fields in camelCase, 64-bit numbers as
/// bigint, enums as numbers, bytes as Uint8Array, repeated fields as arrays; unset messages are undefined.
// eslint-disable-next-line @typescript-eslint/no-explicit-any
export type Message = Record<string, any>;

export interface VectorMessage {
  x?: number;
  y?: number;
  z?: number;
}

export interface PoseMessage {
  position?: VectorMessage;
  orientation?: VectorMessage & { w?: number };
}

export interface ColorMessage {
  r?: number;
  g?: number;
  b?: number;
  a?: number;
}

/// ignition.msgs.Geometry.Type
export enum GeometryType {
  box = 0,
  cylinder = 1,
  sphere = 2,
  plane = 3,
  image = 4,
  heightmap = 5,
  mesh = 6,
  polyline = 9,
  cone = 10,
  empty = 11,
  capsule = 14,
  ellipsoid = 15,
}

export interface GeometryMessage {
  type?: number;
  box?: { size?: VectorMessage };
  cylinder?: { radius?: number; length?: number };
  cone?: { radius?: number; length?: number };
  capsule?: { radius?: number; length?: number };
  sphere?: { radius?: number };
  ellipsoid?: { radii?: VectorMessage };
  plane?: { normal?: VectorMessage; size?: { x?: number; y?: number } };
  mesh?: { filename?: string; scale?: VectorMessage; submesh?: string; centerSubmesh?: boolean };
  heightmap?: { filename?: string; size?: VectorMessage; origin?: VectorMessage };
  polyline?: { height?: number; point?: { x?: number; y?: number }[] }[];
}

export interface MaterialMessage {
  ambient?: ColorMessage;
  diffuse?: ColorMessage;
  specular?: ColorMessage;
  emissive?: ColorMessage;
  lighting?: boolean;
  doubleSided?: boolean;
  pbr?: {
    type?: number;
    albedoMap?: string;
    normalMap?: string;
    metalness?: number;
    metalnessMap?: string;
    roughness?: number;
    roughnessMap?: string;
    glossiness?: number;
    emissiveMap?: string;
  };
}

export interface VisualMessage {
  id?: number;
  name?: string;
  pose?: PoseMessage;
  geometry?: GeometryMessage;
  material?: MaterialMessage;
  castShadows?: boolean;
  transparency?: number;
}

export interface InertialMessage {
  mass?: number;
  pose?: PoseMessage;
  ixx?: number;
  ixy?: number;
  ixz?: number;
  iyy?: number;
  iyz?: number;
  izz?: number;
}

export interface LightMessage {
  id?: number;
  name?: string;
  parentId?: number;
  /// 0 point, 1 spot, 2 directional
  type?: number;
  pose?: PoseMessage;
  diffuse?: ColorMessage;
  direction?: VectorMessage;
  attenuationConstant?: number;
  attenuationLinear?: number;
  attenuationQuadratic?: number;
  range?: number;
  castShadows?: boolean;
  spotInnerAngle?: number;
  spotOuterAngle?: number;
  spotFalloff?: number;
  intensity?: number;
  header?: { data?: { key?: string; value?: string[] }[] };
}

export interface LinkMessage {
  id?: number;
  name?: string;
  pose?: PoseMessage;
  visual?: VisualMessage[];
  collision?: { id?: number; name?: string; pose?: PoseMessage; geometry?: GeometryMessage }[];
  inertial?: InertialMessage;
  light?: LightMessage[];
  sensor?: { id?: number; name?: string; pose?: PoseMessage }[];
}

/// ignition.msgs.Joint.Type
export enum JointType {
  revolute = 0,
  revolute2 = 1,
  prismatic = 2,
  universal = 3,
  ball = 4,
  screw = 5,
  gearbox = 6,
  fixed = 7,
}

export interface AxisMessage {
  xyz?: VectorMessage;
  limitLower?: number;
  limitUpper?: number;
}

export interface JointMessage {
  id?: number;
  name?: string;
  type?: number;
  /// Names of the links, in the model that contains the joint.
  parent?: string;
  child?: string;
  childId?: number;
  /// Pose in the frame of the child link.
  pose?: PoseMessage;
  axis1?: AxisMessage;
  axis2?: AxisMessage;
}

export interface ModelMessage {
  id?: number;
  name?: string;
  isStatic?: boolean;
  pose?: PoseMessage;
  link?: LinkMessage[];
  /// Visuals of a model without links, such as an actor.
  visual?: VisualMessage[];
  joint?: JointMessage[];
  model?: ModelMessage[];
}

export interface SkyMessage {
  time?: number;
  sunrise?: number;
  sunset?: number;
}

export interface SceneMessage {
  name?: string;
  ambient?: ColorMessage;
  background?: ColorMessage;
  sky?: SkyMessage;
  shadows?: boolean;
  grid?: boolean;
  model?: ModelMessage[];
  light?: LightMessage[];
}
