import { Group, type Matrix4, Object3D } from 'three';

/// Objects that are shown at the poses of places in the scene.
export class Attached {
  readonly group = new Group();
  private readonly anchors = new Map<number, Group>();

  /// @param object In the frame of the place.
  add(place: number, object: Object3D, M_WorldPlace: Matrix4): void {
    let anchor = this.anchors.get(place);
    if (anchor === undefined) {
      anchor = new Group();
      anchor.matrixAutoUpdate = false;
      this.anchors.set(place, anchor);
      this.group.add(anchor);
      this.put(anchor, M_WorldPlace);
    }
    anchor.add(object);
    object.updateMatrixWorld(true);
  }

  has(place: number): boolean {
    return this.anchors.has(place);
  }

  move(place: number, M_WorldPlace: Matrix4): void {
    const anchor = this.anchors.get(place);
    if (anchor) this.put(anchor, M_WorldPlace);
  }

  private put(anchor: Group, M_WorldPlace: Matrix4): void {
    anchor.matrix.copy(M_WorldPlace);
    anchor.updateMatrixWorld(true);
  }

  clear(): void {
    this.group.clear();
    this.anchors.clear();
  }
}
