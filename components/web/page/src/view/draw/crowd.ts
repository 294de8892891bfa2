import {
  type BufferGeometry,
  Color,
  DynamicDrawUsage,
  Frustum,
  type Group,
  InstancedMesh,
  Matrix4,
  type PerspectiveCamera,
  Sphere,
  Vector3,
} from 'three';

import { coarseLevels } from './shapes.ts';

/// From this number of items on, each is drawn only where it is in view, and with as many triangles as can be seen.
export const crowdSize = 64;

/// Geometries of a shape for `coarseLevels`.
export const coarserOf = new WeakMap<BufferGeometry, BufferGeometry[]>();

/// What a viewpoint sees.
export interface Sight {
  frustum: Frustum;
  position: Vector3;
  /// Size of an object of 1 m at a distance of 1 m [pixels].
  pixels: number;
}

export function sightOf(camera: PerspectiveCamera, height: number): Sight {
  camera.updateMatrixWorld();
  const M_ImageWorld = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  return {
    frustum: new Frustum().setFromProjectionMatrix(M_ImageWorld),
    position: new Vector3().setFromMatrixPosition(camera.matrixWorld),
    pixels: height / (2 * Math.tan((camera.fov * Math.PI) / 360)),
  };
}

/// The level for a radius on the screen: 0 is the whole shape.
export function levelFor(radius: number): number {
  let level = 0;
  while (level < coarseLevels.length && radius < coarseLevels[level]!.radius) ++level;
  return level;
}

/// The drawn instances of a batch with many items.
export class Crowd {
  private readonly levels: InstancedMesh[];
  private readonly caster: InstancedMesh | null;
  private readonly matrix = new Matrix4();
  private readonly sphere = new Sphere();
  private readonly color = new Color();

  /// @param all The mesh with all items, which it makes invisible.
  /// @param group Where its meshes are put.
  constructor(all: InstancedMesh, private readonly group: Group) {
    const geometries = [all.geometry, ...(coarserOf.get(all.geometry) ?? [])];
    this.levels = geometries.map((geometry) => new InstancedMesh(geometry, all.material, 0));
    this.caster = all.castShadow ? new InstancedMesh(geometries[2] ?? all.geometry, all.material, 0) : null;
    for (const mesh of this.meshes) {
      mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      group.add(mesh);
    }
    if (this.caster) {
      this.caster.castShadow = true;
      this.caster.layers.mask = all.layers.mask;
      this.caster.visible = false;
    }
    all.castShadow = false;
    if (all.geometry.boundingSphere === null) all.geometry.computeBoundingSphere();
  }

  private get meshes(): InstancedMesh[] {
    return this.caster ? [...this.levels, this.caster] : this.levels;
  }

  /// Puts each item in view into the mesh of its level.
  arrange(all: InstancedMesh, sight: Sight): void {
    all.visible = false;
    all.castShadow = false;
    for (const mesh of this.levels) {
      this.reserve(mesh, all);
      mesh.count = 0;
    }
    const { matrix, sphere, color } = this;
    for (let i = 0; i < all.count; ++i) {
      all.getMatrixAt(i, matrix);
      sphere.copy(all.geometry.boundingSphere!).applyMatrix4(matrix);
      if (!sight.frustum.intersectsSphere(sphere)) continue;
      const distance = Math.max(sphere.center.distanceTo(sight.position) - sphere.radius, 1e-3);
      const mesh = this.levels[Math.min(levelFor((sphere.radius * sight.pixels) / distance), this.levels.length - 1)]!;
      mesh.setMatrixAt(mesh.count, matrix);
      if (all.instanceColor) {
        all.getColorAt(i, color);
        mesh.setColorAt(mesh.count, color);
      }
      ++mesh.count;
    }
    for (const mesh of this.levels) {
      mesh.visible = mesh.count > 0;
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /// Makes room in a mesh for all items.
  private reserve(mesh: InstancedMesh, all: InstancedMesh): void {
    if (mesh.instanceMatrix.count >= all.count) return;
    const sized = new InstancedMesh(mesh.geometry, mesh.material, all.instanceMatrix.count);
    mesh.dispose();
    mesh.instanceMatrix = sized.instanceMatrix;
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.instanceColor = null;
  }

  /// Shows all items as they cast shadows, or what `arrange` has chosen.
  showCasters(on: boolean, all: InstancedMesh): void {
    all.visible = false;
    all.castShadow = false;
    for (const mesh of this.levels) mesh.visible = !on && mesh.count > 0;
    if (!this.caster) return;
    this.caster.visible = on;
    this.caster.instanceMatrix = all.instanceMatrix;
    this.caster.count = all.count;
  }

  dispose(): void {
    for (const mesh of this.meshes) {
      this.group.remove(mesh);
      mesh.dispose();
    }
  }
}
