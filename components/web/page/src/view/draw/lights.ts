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
import { FillLight } from './fill_light.ts';
import { attenuations, mostLights } from './materials.ts';
import { rgbOf } from './paint.ts';

const mostShadows = 4;
const shadowEdge = 2048;
// blur of shadows' edges [texels]
const softShadow = 2.5;
// radius of the region with shadows, around the target of the viewpoint, in larger scenes [m]
const mostShadowRadius = 25;

type ThreeLight = DirectionalLight | PointLight | SpotLight;

interface SceneLight {
  light: ThreeLight;
  message: LightMessage;
  castsShadow: boolean;
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
export class Lights {
  readonly group = new Group();
  private readonly ambient = new AmbientLight(new Color(0.4, 0.4, 0.4));
  private readonly lights = new Map<number, SceneLight>();
  private readonly fill = new FillLight();
  private level = this.ambient.color.clone();
  private hasShadows = true;
  private isAsCameras = false;

  constructor() {
    this.group.add(this.ambient, this.fill.group);
  }

  /// Whether everything is lit as the simulated cameras see it; else with a fill light and softer shadows.
  setAsCameras(on: boolean): void {
    this.isAsCameras = on;
    this.renewAmbient();
  }

  private renewAmbient(): void {
    const lights = [...this.lights.values()];
    if (this.isAsCameras) {
      this.fill.switchOff();
      this.ambient.color.copy(this.level);
    } else {
      this.ambient.color.copy(this.fill.set(this.level, lights.find(({ light }) => light instanceof DirectionalLight)?.direction ?? null));
    }
    for (const { light } of lights) if (light.shadow) light.shadow.radius = this.isAsCameras ? 1 : softShadow;
  }

  /// Sets the ambient light. As in Fortress, the renderer divides it by pi, because it spreads over the hemisphere.
  setAmbient(color: ColorMessage | undefined): void {
    this.level = color === undefined ? new Color(0.4, 0.4, 0.4) : new Color(...rgbOf(color));
    this.renewAmbient();
  }

  /// Enables or disables all shadows.
  setShadows(on: boolean): void {
    this.hasShadows = on;
    for (const { light, castsShadow } of this.lights.values()) light.castShadow = castsShadow && on;
  }

  set(lights: ReadonlyMap<number, LightMessage>, placeOf: (id: number) => Placement): void {
    for (const { light } of this.lights.values()) {
      this.group.remove(light, 'target' in light ? light.target : light);
      light.dispose();
    }
    this.lights.clear();
    let shadows = 0;
    for (const [id, message] of [...lights].slice(0, mostLights)) {
      if ((message.intensity ?? 1) <= 0) continue;
      const entry: SceneLight = { light: threeLightOf(message), message, castsShadow: false, direction: new Vector3() };
      const number = this.lights.size;
      attenuations.value[number]?.set(
        message.attenuationConstant ?? 1,
        message.attenuationLinear ?? 0,
        message.attenuationQuadratic ?? 0,
        message.spotFalloff ?? 0,
      );
      if (!(entry.light instanceof DirectionalLight)) entry.light.decay = number;
      if (message.castShadows && !(entry.light instanceof PointLight) && shadows < mostShadows) {
        ++shadows;
        entry.castsShadow = true;
        prepareShadow(entry.light, this.hasShadows);
      }
      this.lights.set(id, entry);
      this.group.add(entry.light);
      if ('target' in entry.light) this.group.add(entry.light.target);
      this.move(id, placeOf(id));
    }
    this.renewAmbient();
  }

  move(id: number, X_WorldLight: Placement): void {
    const entry = this.lights.get(id);
    if (entry === undefined) return;
    entry.direction = lightDirection(entry.message).applyQuaternion(X_WorldLight.rotation);
    entry.light.position.copy(X_WorldLight.position);
    if ('target' in entry.light) entry.light.target.position.copy(X_WorldLight.position).add(entry.direction);
  }

  /// Fits the shadow cameras of directional lights to a region. The position of such a light has no other effect.
  aimShadows(region: Sphere | null): void {
    for (const { light, direction } of this.lights.values()) {
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

function threeLightOf(message: LightMessage): ThreeLight {
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
