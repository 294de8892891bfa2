import {
  Color,
  DoubleSide,
  FrontSide,
  Material,
  MeshBasicMaterial,
  MeshPhysicalMaterial,
  NoColorSpace,
  SRGBColorSpace,
  Vector4,
  type WebGLProgramParametersWithUniforms,
} from 'three';

import { contactChunks, contactShadow } from './contact_shadow.ts';
import type { Textures } from './textures.ts';
import type { Paint } from './paint.ts';

/// Per-entity overrides of a material's appearance.
export interface Style {
  wireframe: boolean;
  transparent: boolean;
}

/// Maximum number of lights, equal to that of the simulated cameras.
export const mostLights = 16;

/// Attenuation of each light: constant, linear and quadratic factor, and the falloff of a spot. A light's `decay` is
/// its index here.
export const attenuations = { value: Array.from({ length: mostLights }, () => new Vector4(1, 0, 0, 1)) };

// replaces three's function, which has neither constant and linear factors nor a falloff
const attenuationFunction = `
uniform vec4 attenuations[${mostLights}];
float getDistanceAttenuation(const in float far, const in float range, const in float light) {
  if (range > 0.0 && far > range) return 0.0;
  vec4 shares = attenuations[int(light + 0.5)];
  return 1.0 / max(shares.x + shares.y * far + shares.z * far * far, 1e-3);
}
float getSpotAttenuation(const in float outer, const in float inner, const in float angle, const in float light) {
  float within = (angle - outer) / max(inner - outer, 1e-5);
  if (within <= 0.0) return 0.0;
  return pow(min(within, 1.0), max(attenuations[int(light + 0.5)].w, 1e-3));
}
`;

/// Colour that smooth surfaces reflect, from the horizon and from above.
export const mirroredSky = { value: new Color(0, 0, 0) };

// smooth surfaces reflect the ambient light and the background, because the scene is no environment map
const mirroring = `
{
  vec3 skyward = normalize((viewMatrix * vec4(0.0, 0.0, 1.0, 0.0)).xyz);
  float high = dot(reflect(-geometryViewDir, geometryNormal), skyward) * 0.5 + 0.5;
  vec3 mirrored = mix(ambientLightColor * (0.5 / 3.14159265), mirroredSky, smoothstep(0.35, 0.65, high));
  vec3 front = material.specularColorBlended;
  float grazing = pow(1.0 - max(dot(geometryNormal, geometryViewDir), 1e-3), 5.0);
  vec3 share = front + (max(vec3(1.0 - material.roughness), front) - front) * grazing;
  reflectedLight.indirectSpecular += share * mirrored * mix(1.0, 0.4, material.roughness);
}
`;

/// Replaces the attenuation in three's shader source by that of SDF.
export function withAttenuation(lightsChunk: string): string {
  const begin = lightsChunk.indexOf('float getDistanceAttenuation(');
  const end = lightsChunk.indexOf('#if NUM_', begin);
  const call = 'getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos )';
  if (begin < 0 || end < begin || !lightsChunk.includes(call)) {
    throw new Error('three.js has different lights than this page expects');
  }
  const text = lightsChunk.slice(0, begin) + attenuationFunction + lightsChunk.slice(end);
  return text.replace(call, call.replace('angleCos )', 'angleCos, spotLight.decay )'));
}

/// The materials in use. Surfaces that differ only in colour share one; the colour is set per instance.
export class Materials {
  private readonly materials = new Map<string, Material>();

  constructor(
    private readonly textures: Textures,
    private readonly lightsChunk: string,
  ) {}

  key(paint: Paint, style: Style): string {
    return JSON.stringify({ ...paint, diffuse: undefined, ...style });
  }

  /// @param isPlane Whether bodies may stand on it, and darken it there.
  get(paint: Paint, style: Style, isPlane = false): Material {
    const key = `${isPlane}|${this.key(paint, style)}`;
    const known = this.materials.get(key);
    if (known !== undefined) return known;
    const made = paint.isLit ? this.lit(paint, isPlane) : this.unlit(paint);
    const opacity = style.transparent ? Math.min(paint.opacity, 0.4) : paint.opacity;
    made.opacity = opacity;
    made.transparent = opacity < 1;
    made.depthWrite = opacity >= 1;
    made.side = paint.isDoubleSided || style.wireframe || style.transparent ? DoubleSide : FrontSide;
    made.wireframe = style.wireframe;
    // moves surfaces back in depth, so that lines on them, such as the grid, are visible
    made.polygonOffset = true;
    made.polygonOffsetFactor = made.polygonOffsetUnits = 1;
    this.materials.set(key, made);
    return made;
  }

  private lit(paint: Paint, isPlane: boolean): MeshPhysicalMaterial {
    const material = new MeshPhysicalMaterial({
      metalness: paint.metalness,
      roughness: Math.max(paint.roughness, 0.06),
      specularColor: new Color(...paint.specular),
      emissive: new Color(...paint.emissive),
    });
    this.textures.put(material, 'map', paint.colorMap, SRGBColorSpace);
    this.textures.put(material, 'emissiveMap', paint.glowMap, SRGBColorSpace);
    this.textures.put(material, 'normalMap', paint.normalMap, NoColorSpace);
    this.textures.put(material, 'roughnessMap', paint.roughnessMap, NoColorSpace);
    this.textures.put(material, 'metalnessMap', paint.metalnessMap, NoColorSpace);
    // discards transparent texels, for leaves and fences
    if (paint.colorMap !== '') material.alphaTest = 0.05;
    material.onBeforeCompile = (shader) => {
      shader.uniforms['attenuations'] = attenuations;
      shader.uniforms['mirroredSky'] = mirroredSky;
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <lights_pars_begin>', `uniform vec3 mirroredSky;\n${this.lightsChunk}`)
        .replace('#include <lights_fragment_end>', `#include <lights_fragment_end>\n${mirroring}`);
      if (isPlane) addContactShadow(shader);
    };
    material.customProgramCacheKey = () => String(isPlane);
    return material;
  }

  private unlit(paint: Paint): MeshBasicMaterial {
    const material = new MeshBasicMaterial();
    this.textures.put(material, 'map', paint.colorMap, SRGBColorSpace);
    return material;
  }

  dispose(): void {
    for (const material of this.materials.values()) material.dispose();
    this.materials.clear();
  }
}

function addContactShadow(shader: WebGLProgramParametersWithUniforms): void {
  Object.assign(shader.uniforms, contactShadow);
  const { vertexHead, vertex, fragmentHead, fragment } = contactChunks;
  shader.vertexShader = vertexHead + shader.vertexShader.replace('#include <project_vertex>', `#include <project_vertex>\n${vertex}`);
  shader.fragmentShader = fragmentHead + shader.fragmentShader.replace('#include <opaque_fragment>', `${fragment}#include <opaque_fragment>`);
}
