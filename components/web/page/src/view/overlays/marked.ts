import type { Object3D } from 'three';

import type { Overlay, Shown } from '../scene/shown.ts';
import type { Stage } from '../scene/stage.ts';
import { Attached } from './attached.ts';
import { centreMark, collisionMark, frameMark, inertiaMark, jointMark } from './marks.ts';

/// The overlays of entities: frames, joints, centres of mass, inertia boxes and collisions.
export class Marked {
  private readonly attached = new Attached();
  private generation = 0;

  constructor(
    private readonly stage: Stage,
    private readonly shown: Shown,
    private readonly changed: () => void,
  ) {}

  get group(): Object3D {
    return this.attached.group;
  }

  /// Moves the overlays of a place to its current pose.
  move(place: number): void {
    const matrix = this.attached.has(place) ? this.stage.places.matrix(place) : null;
    if (matrix) this.attached.move(place, matrix);
  }

  /// Creates all overlays anew.
  rebuild(): void {
    const generation = ++this.generation;
    this.attached.clear();
    const { content } = this.stage;
    for (const { id, kind } of content.places.values()) {
      if (kind !== 'light' && this.has('frames', id)) this.add(id, frameMark(this.lengthAt(id)));
    }
    for (const joint of content.joints) {
      if (this.has('joints', joint.place)) this.add(joint.place, jointMark(joint, this.lengthAt(joint.place)));
    }
    for (const { place, inertial } of content.inertials) {
      if (this.has('centres', place)) this.add(place, centreMark(inertial));
      if (this.has('inertia', place)) this.add(place, inertiaMark(inertial));
    }
    for (const collision of content.collisions) {
      if (!this.has('collisions', collision.place)) continue;
      this.stage.withShape(collision, `collision '${collision.name}'`, (geometry, M_PlaceForm) => {
        // the file may arrive after the overlays were created anew
        if (generation !== this.generation) return;
        const mark = collisionMark(geometry);
        mark.matrixAutoUpdate = false;
        mark.matrix.copy(M_PlaceForm);
        this.add(collision.place, mark);
      });
    }
  }

  private has(overlay: Overlay, place: number): boolean {
    return this.shown.has(overlay, place, this.stage.content.places);
  }

  private add(place: number, mark: Object3D | null): void {
    const matrix = this.stage.places.matrix(place);
    if (mark && matrix) this.attached.add(place, mark, matrix);
    this.changed();
  }

  /// Size of an overlay in proportion to the entity [m].
  private lengthAt(place: number): number {
    const box = this.stage.batches.boundsInPlace(place);
    if (box.isEmpty()) return 0.3;
    return Math.min(Math.max(box.max.distanceTo(box.min) * 0.6, 0.1), 2);
  }
}
