import {
  AmbientLight,
  type Box3,
  Color,
  DirectionalLight,
  Group,
  type OrthographicCamera,
  PointLight,
  Sphere,
  SpotLight,
  Vector3,
} from 'three';

import type { Placement } from '../maths/placement.ts';
import type { ColorMessage, LightMessage } from '../messages.ts';
import { lightDirection } from '../scene/content.ts';
import { attenuations, mostLamps } from './materials.ts';
import { rgbOf } from './paint.ts';

const mostShadows = 4;
const shadowEdge = 2048;
// radius of the region with shadows, around the target of the viewpoint, in larger scenes [m]
const mostShadowRadius = 25;

type Shining = DirectionalLight | PointLight | SpotLight;

interface Lamp {
  light: Shining;
  message: LightMessage;
  throwsShadow: boolean;
  /// Direction of a directional light, in world coordinates.
  direction: Vector3;
}

/// three's colour for a light. In SDF it is the colour of a white surface that faces the light; three divides by pi.
export function colorOfLight(message: LightMessage): Color {
  const intensity = message.intensity ?? 1;
  return new Color(...rgbOf(message.diffuse)).multiplyScalar(intensity * Math.PI);
}

/// The bounding sphere of everything that casts shadows, or a sphere around the target if that is too large.
export function shadowRegion(casters: Box3, target: Vector3): Sphere | null {
  if (casters.isEmpty()) return null;
  const region = casters.getBoundingSphere(new Sphere());
  return region.radius <= mostShadowRadius ? region : new Sphere(target.clone(), mostShadowRadius);
}

/// The lights of a scene.
export class Lamps {
  readonly group = new Group();
  private readonly ambient = new AmbientLight(new Color(0.4, 0.4, 0.4));
  private readonly lamps = new Map<number, Lamp>();
  private hasShadows = true;

  constructor() {
    this.group.add(this.ambient);
  }

  /// Sets the ambient light. As in Fortress, the renderer divides it by pi, because it spreads over the hemisphere.
  setAmbient(color: ColorMessage | undefined): void {
    this.ambient.color = color === undefined ? new Color(0.4, 0.4, 0.4) : new Color(...rgbOf(color));
  }

  /// Enables or disables all shadows.
  setShadows(on: boolean): void {
    this.hasShadows = on;
    for (const { light, throwsShadow } of this.lamps.values()) light.castShadow = throwsShadow && on;
  }

  set(lights: ReadonlyMap<number, LightMessage>, placeOf: (id: number) => Placement): void {
    for (const { light } of this.lamps.values()) {
      this.group.remove(light, 'target' in light ? light.target : light);
      light.dispose();
    }
    this.lamps.clear();
    let shadows = 0;
    for (const [id, message] of [...lights].slice(0, mostLamps)) {
      if ((message.intensity ?? 1) <= 0) continue;
      const lamp: Lamp = { light: shiningOf(message), message, throwsShadow: false, direction: new Vector3() };
      const number = this.lamps.size;
      attenuations.value[number]?.set(
        message.attenuationConstant ?? 1,
        message.attenuationLinear ?? 0,
        message.attenuationQuadratic ?? 0,
        message.spotFalloff ?? 0,
      );
      if (!(lamp.light instanceof DirectionalLight)) lamp.light.decay = number;
      if (message.castShadows && !(lamp.light instanceof PointLight) && shadows < mostShadows) {
        ++shadows;
        lamp.throwsShadow = true;
        prepareShadow(lamp.light, this.hasShadows);
      }
      this.lamps.set(id, lamp);
      this.group.add(lamp.light);
      if ('target' in lamp.light) this.group.add(lamp.light.target);
      this.move(id, placeOf(id));
    }
  }

  move(id: number, X_WorldLight: Placement): void {
    const lamp = this.lamps.get(id);
    if (lamp === undefined) return;
    lamp.direction = lightDirection(lamp.message).applyQuaternion(X_WorldLight.rotation);
    lamp.light.position.copy(X_WorldLight.position);
    if ('target' in lamp.light) lamp.light.target.position.copy(X_WorldLight.position).add(lamp.direction);
  }

  /// Fits the shadow cameras of directional lights to a region. The position of such a light has no other effect.
  aimShadows(region: Sphere | null): void {
    for (const { light, direction } of this.lamps.values()) {
      if (!(light instanceof DirectionalLight) || region === null) continue;
      const { radius, center } = region;
      light.target.position.copy(center);
      light.position.copy(center).addScaledVector(direction, -2 * radius - 1);
      const camera: OrthographicCamera = light.shadow.camera;
      camera.left = camera.bottom = -radius;
      camera.right = camera.top = radius;
      camera.near = 0.01;
      camera.far = 4 * radius + 2;
      camera.updateProjectionMatrix();
      light.shadow.normalBias = (4 * radius) / shadowEdge;
    }
  }
}

function shiningOf(message: LightMessage): Shining {
  const color = colorOfLight(message);
  const range = message.range ?? 0;
  if (message.type === 2) return new DirectionalLight(color);
  if (message.type !== 1) return new PointLight(color, 1, range);
  const outer = Math.min(Math.max(message.spotOuterAngle ?? 0, 0.01), 3.1);
  const inner = Math.min(message.spotInnerAngle ?? 0, outer);
  return new SpotLight(color, 1, range, outer / 2, 1 - inner / outer);
}

function prepareShadow(light: DirectionalLight | SpotLight, isOn: boolean): void {
  light.castShadow = isOn;
  light.shadow.mapSize.set(shadowEdge, shadowEdge);
  light.shadow.bias = -0.0005;
  if (light instanceof SpotLight) light.shadow.camera.near = 0.05;
}
