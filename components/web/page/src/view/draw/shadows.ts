import { type Camera, type Vector3, type WebGLRenderer, WebGLRenderTarget } from 'three';

import type { Stage } from '../scene/stage.ts';
import { ContactShadow } from './contact_shadow.ts';

/// Renders the shadows, when they have changed.
export class Shadows {
  private readonly contact = new ContactShadow();
  private isDue = true;
  private isContactDue = true;
  private tiny: WebGLRenderTarget | null = null;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly stage: Stage,
    private readonly camera: Camera,
  ) {}

  /// To be called when the scene has changed.
  changed(): void {
    this.isDue = true;
  }

  /// In a large scene, the region with shadows follows the target.
  /// @param hasMoved Whether anything has moved since the last call.
  /// @param hasContact Whether there are shadows where bodies stand on the ground.
  renew(target: Vector3, hasMoved: boolean, hasContact: boolean): void {
    const { renderer, stage, contact } = this;
    const isNew = stage.aimShadows(target, hasMoved || this.isDue);
    if (isNew) this.isContactDue = true;
    const isContactNew = hasContact && this.isContactDue;
    if (!hasContact) {
      contact.hide();
      this.isContactDue = true;
    }
    if (!isNew && !isContactNew) return;
    // of crowds, coarse shapes cast the shadows, and the image shows others: so the shadows have a rendering of their own
    const hasCrowds = stage.batches.showCasters(true);
    if (isContactNew) {
      contact.render(renderer, stage.batches, stage.floorHeight(), stage.shadowed);
      this.isContactDue = false;
    }
    if (isNew) {
      this.isDue = false;
      renderer.shadowMap.needsUpdate = true;
      if (hasCrowds) this.renderAlone();
    }
    if (hasCrowds) stage.batches.showCasters(false);
  }

  private renderAlone(): void {
    this.tiny ??= new WebGLRenderTarget(1, 1);
    this.renderer.setRenderTarget(this.tiny);
    this.renderer.render(this.stage.root, this.camera);
    this.renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.tiny?.dispose();
    this.contact.dispose();
  }
}
