import { type Place, isWithin } from './content.ts';

/// Overlays that can be shown for one entity with its parts, or for all.
export type Overlay =
  | 'frames'
  | 'joints'
  | 'centres'
  | 'inertia'
  | 'collisions'
  | 'contacts'
  | 'wireframe'
  | 'transparent';

/// Which overlays are shown for which entities.
export class Shown {
  private readonly ofAll = new Set<Overlay>();
  private readonly ofEntities = new Map<Overlay, Set<number>>();

  set(overlay: Overlay, on: boolean, entity?: number): void {
    if (entity === undefined) {
      if (on) this.ofAll.add(overlay);
      else this.ofAll.delete(overlay);
      // switching an overlay off for all also switches it off for each entity
      if (!on) this.ofEntities.delete(overlay);
      return;
    }
    const entities = this.ofEntities.get(overlay) ?? new Set();
    if (on) entities.add(entity);
    else entities.delete(entity);
    this.ofEntities.set(overlay, entities);
  }

  has(overlay: Overlay, place: number, places: ReadonlyMap<number, Place>): boolean {
    if (this.ofAll.has(overlay)) return true;
    for (const entity of this.ofEntities.get(overlay) ?? []) if (isWithin(places, place, entity)) return true;
    return false;
  }
}
