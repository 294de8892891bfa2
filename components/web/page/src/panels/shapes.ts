/// Models with a single shape, and lights: as SDF, and as messages for the preview.
import type { Message } from '../connection/types.ts';

export type Shape = 'box' | 'sphere' | 'cylinder' | 'capsule' | 'ellipsoid';
export type LightType = 'point' | 'spot' | 'directional';

interface ShapeValues {
  geometry: string;
  message: Message;
  /// Moments of inertia of 1 kg: xx, yy, zz [kg m^2].
  moments: [number, number, number];
}

/// The shapes of Fortress's Shapes plugin: 1 m in size, 1 kg.
const kShapes: Record<Shape, ShapeValues> = {
  box: {
    geometry: '<box><size>1 1 1</size></box>', message: { type: 0, box: { size: { x: 1, y: 1, z: 1 } } },
    moments: [1 / 6, 1 / 6, 1 / 6],
  },
  sphere: {
    geometry: '<sphere><radius>0.5</radius></sphere>', message: { type: 2, sphere: { radius: 0.5 } },
    moments: [0.1, 0.1, 0.1],
  },
  cylinder: {
    geometry: '<cylinder><radius>0.5</radius><length>1</length></cylinder>',
    message: { type: 1, cylinder: { radius: 0.5, length: 1 } }, moments: [0.145833, 0.145833, 0.125],
  },
  capsule: {
    geometry: '<capsule><radius>0.2</radius><length>0.6</length></capsule>',
    message: { type: 14, capsule: { radius: 0.2, length: 0.6 } }, moments: [0.074154, 0.074154, 0.018769],
  },
  ellipsoid: {
    geometry: '<ellipsoid><radii>0.2 0.3 0.5</radii></ellipsoid>',
    message: { type: 15, ellipsoid: { radii: { x: 0.2, y: 0.3, z: 0.5 } } }, moments: [0.068, 0.058, 0.026],
  },
};

export const kShapeNames = Object.keys(kShapes) as Shape[];

export function shapeSdf(shape: Shape): string {
  const { geometry, moments: [x, y, z] } = kShapes[shape];
  return `<?xml version="1.0"?>
<sdf version="1.9">
  <model name="${shape}">
    <link name="${shape}_link">
      <inertial><mass>1</mass><inertia><ixx>${x}</ixx><ixy>0</ixy><ixz>0</ixz><iyy>${y}</iyy><iyz>0</iyz><izz>${z}</izz></inertia></inertial>
      <collision name="${shape}_collision"><geometry>${geometry}</geometry></collision>
      <visual name="${shape}_visual">
        <geometry>${geometry}</geometry>
        <material><ambient>0.3 0.3 0.3 1</ambient><diffuse>0.7 0.7 0.7 1</diffuse><specular>1 1 1 1</specular></material>
      </visual>
    </link>
  </model>
</sdf>`;
}

/// The shape as an ignition.msgs.Model.
export function shapeMessage(shape: Shape): Message {
  const color = { r: 0.7, g: 0.7, b: 0.7, a: 1 };
  const visual = { id: 1, name: 'visual', geometry: kShapes[shape].message, material: { ambient: color, diffuse: color } };
  return { id: 0, name: shape, link: [{ id: 0, name: 'link', visual: [visual], light: [], sensor: [] }], model: [], joint: [] };
}

export function lightSdf(type: LightType): string {
  const spot = type === 'spot' ? '<spot><inner_angle>0.1</inner_angle><outer_angle>0.5</outer_angle><falloff>0.8</falloff></spot>' : '';
  return `<?xml version="1.0"?>
<sdf version="1.9">
  <light type="${type}" name="${type}">
    <cast_shadows>${type !== 'point'}</cast_shadows>
    <diffuse>1 1 1 1</diffuse>
    <specular>0.5 0.5 0.5 1</specular>
    <direction>0 0 -1</direction>
    <attenuation><range>4</range><constant>0.2</constant><linear>0.5</linear><quadratic>0.01</quadratic></attenuation>${spot}
  </light>
</sdf>`;
}
