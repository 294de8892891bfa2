import { BoxGeometry, EdgesGeometry, LineBasicMaterial, LineSegments, Vector3 } from 'three';

import type { Stage } from '../scene/stage.ts';

/// The edges of the bounding box of a selected entity that has nothing visible.
export class Outline {
  readonly object = new LineSegments(
    new EdgesGeometry(new BoxGeometry()),
    new LineBasicMaterial({ color: 0xff9a1f }),
  );

  constructor() {
    this.object.matrixAutoUpdate = false;
    this.object.visible = false;
    this.object.frustumCulled = false;
  }

  /// Moves the box to the entity's current pose. Null hides it.
  update(stage: Stage, entity: number | null): void {
    const shown = entity === null ? null : stage.places.shown(entity);
    this.object.visible = shown !== null;
    if (entity === null || shown === null) return;
    const box = stage.boundsOf(entity, shown);
    // slightly larger, so that the edges are not hidden by the entity's faces
    const size = box.getSize(new Vector3()).multiplyScalar(1.02).addScalar(0.004);
    const middle = box.getCenter(new Vector3());
    const { position, rotation } = shown;
    this.object.matrix.compose(middle.applyQuaternion(rotation).add(position), rotation, size);
    this.object.updateMatrixWorld(true);
  }
}
