import { type Camera, Object3D, type Scene } from 'three';
import { TransformControls } from 'three/examples/jsm/controls/TransformControls.js';

import type { Placement } from '../maths/placement.ts';

export type Tool = 'select' | 'move' | 'turn';

// [m], [rad]
const snapLength = 1;
const snapAngle = Math.PI / 4;

export interface HandlesOptions {
  /// Called when the handles have been dragged; during: the drag continues.
  moved(X_WorldHandles: Placement, during: boolean): void;
  /// Called when the handles start or stop using the pointer.
  busy(isBusy: boolean): void;
  changed(): void;
}

/// Arrows to move and rings to rotate the selected entity (TransformControls).
export class Handles {
  private readonly controls: TransformControls;
  private readonly carrier = new Object3D();
  private tool: Tool = 'select';
  private isWanted = false;

  /// Must be created before other listeners of the element are added, so that the handles get pointer events first.
  constructor(camera: Camera, element: HTMLElement, root: Scene, options: HandlesOptions) {
    this.controls = new TransformControls(camera, element);
    this.controls.setSize(0.8);
    // not the pure red, green and blue that robots are painted in
    this.controls.setColors(0xff7a50, 0xa4d93f, 0x58b4ff, 0xffe14d);
    root.add(this.carrier, this.controls.getHelper());
    this.controls.addEventListener('change', () => options.changed());
    this.controls.addEventListener('dragging-changed', ({ value }) => options.busy(value === true));
    this.controls.addEventListener('objectChange', () => options.moved(this.placement, true));
    this.controls.addEventListener('mouseUp', () => options.moved(this.placement, false));
  }

  get isDragged(): boolean {
    return this.controls.dragging;
  }

  private get placement(): Placement {
    return { position: this.carrier.position.clone(), rotation: this.carrier.quaternion.clone() };
  }

  /// Whether the handles snap to whole metres and eighths of a turn, like those of Fortress.
  setSnapping(isOn: boolean): void {
    this.controls.setTranslationSnap(isOn ? snapLength : null);
    this.controls.setRotationSnap(isOn ? snapAngle : null);
  }

  setTool(tool: Tool): void {
    this.tool = tool;
    this.show();
  }

  /// Moves the handles to a pose; null hides them. While the user drags them, other poses are ignored.
  put(X_WorldHandles: Placement | null): void {
    if (this.isDragged && X_WorldHandles !== null) return;
    this.isWanted = X_WorldHandles !== null;
    if (X_WorldHandles) {
      this.carrier.position.copy(X_WorldHandles.position);
      this.carrier.quaternion.copy(X_WorldHandles.rotation);
      this.carrier.updateMatrixWorld(true);
    }
    this.show();
  }

  private show(): void {
    if (!this.isWanted || this.tool === 'select') {
      if (this.controls.object) this.controls.detach();
      return;
    }
    const mode = this.tool === 'move' ? 'translate' : 'rotate';
    if (this.controls.mode !== mode) this.controls.setMode(mode);
    if (!this.controls.object) this.controls.attach(this.carrier);
  }

  dispose(): void {
    this.controls.dispose();
  }
}
