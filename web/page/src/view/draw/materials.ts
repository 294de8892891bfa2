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
} from 'three';

import type { Textures } from './textures.ts';
import type { Paint } from './paint.ts';

/// How an entity is to be shown against what its material says.
export interface Style {
  wireframe: boolean;
  transparent: boolean;
}

/// The most lamps that shine at once, as with the cameras.
export const mostLamps = 16;

/// What weakens the light of each lamp: constant, linear and quadratic share, and the falloff of a spot. A lamp's `decay`
/// is its number here.
export const attenuations = { value: Array.from({ length: mostLamps }, () => new Vector4(1, 0, 0, 1)) };

// in place of three's own, which knows no constant and linear shares, and no falloff
const attenuationFunction = `
uniform vec4 attenuations[${mostLamps}];
float getDistanceAttenuation(const in float far, const in float range, const in float lamp) {
  if (range > 0.0 && far > range) return 0.0;
  vec4 shares = attenuations[int(lamp + 0.5)];
  return 1.0 / max(shares.x + shares.y * far + shares.z * far * far, 1e-3);
}
float getSpotAttenuation(const in float outer, const in float inner, const in float angle, const in float lamp) {
  float within = (angle - outer) / max(inner - outer, 1e-5);
  if (within <= 0.0) return 0.0;
  return pow(min(within, 1.0), max(attenuations[int(lamp + 0.5)].w, 1e-3));
}
`;

/// What smooth surfaces mirror at a level with the eye and above.
export const mirroredSky = { value: new Color(0, 0, 0) };

// what smooth surfaces mirror of their surroundings is taken for the ambient light and the background
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

/// Puts SDF's attenuation into the text of three's shader.
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

/// The materials in use, shared by what has the same paint but for its colour, which each instance has of its own.
export class Materials {
  private readonly materials = new Map<string, Material>();

  constructor(
    private readonly textures: Textures,
    private readonly lightsChunk: string,
  ) {}

  key(paint: Paint, style: Style): string {
    return JSON.stringify({ ...paint, diffuse: undefined, ...style });
  }

  get(paint: Paint, style: Style): Material {
    const key = this.key(paint, style);
    const known = this.materials.get(key);
    if (known !== undefined) return known;
    const made = paint.isLit ? this.lit(paint) : this.unlit(paint);
    const opacity = style.transparent ? Math.min(paint.opacity, 0.4) : paint.opacity;
    made.opacity = opacity;
    made.transparent = opacity < 1;
    made.depthWrite = opacity >= 1;
    made.side = paint.isDoubleSided || style.wireframe || style.transparent ? DoubleSide : FrontSide;
    made.wireframe = style.wireframe;
    // lines on a surface, as those of the grid, are seen
    made.polygonOffset = true;
    made.polygonOffsetFactor = made.polygonOffsetUnits = 1;
    this.materials.set(key, made);
    return made;
  }

  private lit(paint: Paint): MeshPhysicalMaterial {
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
    // pictures with holes: leaves, fences
    if (paint.colorMap !== '') material.alphaTest = 0.05;
    material.onBeforeCompile = (shader) => {
      shader.uniforms['attenuations'] = attenuations;
      shader.uniforms['mirroredSky'] = mirroredSky;
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <lights_pars_begin>', `uniform vec3 mirroredSky;\n${this.lightsChunk}`)
        .replace('#include <lights_fragment_end>', `#include <lights_fragment_end>\n${mirroring}`);
    };
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
