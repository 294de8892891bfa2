import type { ColorMessage, MaterialMessage } from '../messages.ts';

/// Linear colour components: red, green, blue.
export type Rgb = [number, number, number];

/// The appearance of a surface: SDF's material settings in three's terms.
export interface Paint {
  diffuse: Rgb;
  specular: Rgb;
  emissive: Rgb;
  metalness: number;
  roughness: number;
  /// 1: opaque.
  opacity: number;
  isLit: boolean;
  isDoubleSided: boolean;
  /// Addresses of textures; empty: none.
  colorMap: string;
  normalMap: string;
  roughnessMap: string;
  metalnessMap: string;
  glowMap: string;
}

/// The appearance of a visual without a material.
export const greyPaint: Readonly<Paint> = {
  diffuse: [0.7, 0.7, 0.7],
  specular: [1, 1, 1],
  emissive: [0, 0, 0],
  metalness: 0,
  roughness: 0.6,
  opacity: 1,
  isLit: true,
  isDoubleSided: false,
  colorMap: '',
  normalMap: '',
  roughnessMap: '',
  metalnessMap: '',
  glowMap: '',
};

// ignition.msgs.Material.PBR.WorkflowType
const metalWorkflow = 1;
const specularWorkflow = 2;

export function rgbOf(color: ColorMessage | undefined): Rgb {
  return [color?.r ?? 0, color?.g ?? 0, color?.b ?? 0];
}

function share(value: number): number {
  return Math.min(Math.max(Number.isFinite(value) ? value : 0, 0), 1);
}

/// Converts a material like the simulated cameras.
export function paintOf(material: MaterialMessage, transparency = 0): Paint {
  const { pbr } = material;
  const isMetal = pbr?.type === metalWorkflow;
  const isGlossy = pbr?.type === specularWorkflow;
  const glowMap = pbr?.emissiveMap ?? '';
  const emissive = rgbOf(material.emissive);
  return {
    diffuse: rgbOf(material.diffuse),
    specular: rgbOf(material.specular),
    // an emissive map without a colour is used as it is, as in Fortress
    emissive: glowMap !== '' && emissive.every((value) => value === 0) ? [1, 1, 1] : emissive,
    metalness: isMetal ? share(pbr.metalness ?? 0) : 0,
    roughness: isMetal ? share(pbr.roughness ?? 0) : isGlossy ? share(1 - (pbr.glossiness ?? 0)) : greyPaint.roughness,
    opacity: share(material.diffuse?.a ?? 1) * share(1 - transparency),
    isLit: material.lighting ?? false,
    isDoubleSided: material.doubleSided ?? false,
    colorMap: pbr?.albedoMap ?? '',
    normalMap: pbr?.normalMap ?? '',
    roughnessMap: isMetal ? (pbr.roughnessMap ?? '') : '',
    metalnessMap: isMetal ? (pbr.metalnessMap ?? '') : '',
    glowMap,
  };
}
