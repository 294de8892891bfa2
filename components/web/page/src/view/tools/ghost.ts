import { type Box3, DoubleSide, Group, Matrix4, Mesh, MeshLambertMaterial, Plane, type Raycaster, SphereGeometry, Vector3 } from 'three';

import { type Placement, matrixOf, noPlacement } from '../maths/placement.ts';
import type { ModelMessage } from '../messages.ts';
import { contentOf } from '../scene/content.ts';
import type { Stage } from '../scene/stage.ts';

/// The first intersection of a ray with the scene, or with the plane z = 0; null if there is none, or it is too far
/// away.
export function groundUnder(ray: Raycaster, met: Vector3 | null): Vector3 | null {
  const point = met ?? ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), 0), new Vector3());
  return point === null || point.distanceTo(ray.ray.origin) > 500 ? null : point;
}

/// Height of an object's origin above its lowest point [m].
export function heightAbove(bounds: Box3): number {
  return bounds.isEmpty() ? 0 : Math.max(-bounds.min.z, 0);
}

/// A preview of a model that will be inserted: transparent, at the position of the pointer.
export class Ghost {
  readonly object = new Group();
  private readonly material = new MeshLambertMaterial({
    color: 0x60b0ff, opacity: 0.5, transparent: true, depthWrite: false, side: DoubleSide,
  });
  private readonly rotation: Placement['rotation'];
  private height = 0;

  constructor(stage: Stage, model: ModelMessage, changed: () => void) {
    // the model does not exist yet, so its parts have no ids
    const content = contentOf({ model: [withIds(model)] });
    const [root] = content.places.values();
    const X_WorldModel = root?.X_WorldPlace ?? noPlacement();
    this.rotation = X_WorldModel.rotation;
    const M_ModelWorld = matrixOf(X_WorldModel).invert();
    const inner = new Group();
    this.object.add(inner);
    this.object.visible = false;
    // a ball marks the position of objects without visuals, such as lights
    if (content.visuals.length === 0) inner.add(new Mesh(new SphereGeometry(0.1), this.material));
    for (const visual of content.visuals) {
      const place = content.places.get(visual.place);
      if (place === undefined) continue;
      const M_ModelPlace = new Matrix4().multiplyMatrices(M_ModelWorld, matrixOf(place.X_WorldPlace));
      stage.withShape(visual, 'what is to be placed', (geometry, M_PlaceForm) => {
        const mesh = new Mesh(geometry, this.material);
        mesh.matrixAutoUpdate = false;
        mesh.matrix.multiplyMatrices(M_ModelPlace, M_PlaceForm);
        if (geometry.boundingBox === null) geometry.computeBoundingBox();
        const box = geometry.boundingBox?.clone().applyMatrix4(mesh.matrix);
        if (box) this.height = Math.max(this.height, heightAbove(box));
        inner.add(mesh);
        changed();
      });
    }
  }

  /// Moves the preview so that it stands on a point; null hides it.
  put(point: Vector3 | null): void {
    this.object.visible = point !== null;
    if (point === null) return;
    this.object.position.copy(point).add(new Vector3(0, 0, this.height));
    this.object.quaternion.copy(this.rotation);
  }

  /// Its current pose; null if it is hidden.
  get placement(): Placement | null {
    if (!this.object.visible) return null;
    return { position: this.object.position.clone(), rotation: this.object.quaternion.clone() };
  }

  dispose(): void {
    this.material.dispose();
  }
}

/// A copy of a model in which all parts have ids, because `Place`s are identified by id.
function withIds(model: ModelMessage, next = { id: 1 }): ModelMessage {
  return {
    ...model,
    id: next.id++,
    link: (model.link ?? []).map((link) => ({ ...link, id: next.id++ })),
    model: (model.model ?? []).map((inner) => withIds(inner, next)),
  };
}
