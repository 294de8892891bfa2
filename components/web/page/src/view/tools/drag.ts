import type { Placement } from '../maths/placement.ts';
import type { Places } from '../scene/places.ts';

// time after the release within which a new pose should arrive; for a light there is none [ms]
const settleTime = 700;

/// Shows a model at the pose of its handles until the simulation has moved it there.
export class Drag {
  private entity: number | null = null;
  private isLeft = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(
    private readonly places: Places,
    private readonly changed: () => void,
  ) {}

  /// @param left Settles when the simulation has responded; null while the model is still dragged.
  move(entity: number, X_WorldModel: Placement, left: Promise<unknown> | null): void {
    clearTimeout(this.timer);
    this.entity = entity;
    this.isLeft = false;
    this.places.hold(entity, X_WorldModel);
    this.changed();
    if (left === null) return;
    const refused = () => this.end(entity);
    left.then(() => {
      if (this.entity !== entity) return;
      this.isLeft = true;
      this.timer = setTimeout(() => {
        this.places.settle();
        this.end(entity);
      }, settleTime);
    }, refused);
  }

  /// To be called when a frame with poses of these entities has arrived.
  received(ids: Uint32Array): void {
    if (this.isLeft && this.entity !== null && ids.includes(this.entity)) this.end(this.entity);
  }

  private end(entity: number): void {
    if (this.entity !== entity) return;
    clearTimeout(this.timer);
    this.entity = null;
    this.isLeft = false;
    this.places.hold(entity, null);
    this.changed();
  }

  dispose(): void {
    clearTimeout(this.timer);
  }
}
