import { PerspectiveCamera, Raycaster, Vector2, type Vector3 } from 'three';

import type { Placement } from '../maths/placement.ts';
import * as orbits from './orbit.ts';

// vertical field of view [rad]
const fieldOfView = 1.05;

/// The camera of the view, and its controls.
export class Eye {
  readonly camera = new PerspectiveCamera((fieldOfView * 180) / Math.PI, 1, 0.02, 5000);
  private orbit = orbits.homeOrbit();

  constructor() {
    this.camera.up.set(0, 0, 1);
    this.put(this.orbit);
  }

  get target(): Vector3 {
    return this.orbit.target;
  }

  private put(orbit: orbits.Orbit): void {
    this.orbit = orbit;
    this.camera.position.copy(orbits.eyeOf(orbit));
    this.camera.quaternion.copy(orbits.rotationOfCamera(orbit));
    // depth has enough precision only near the target
    this.camera.near = Math.min(Math.max(orbit.distance / 200, 0.005), 0.5);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  /// @param x, y Fractions of the view's width and height, from its upper left corner.
  rayThrough(x: number, y: number): Raycaster {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.camera);
    return ray;
  }

  /// Sets the distance of the point to rotate around.
  turnAround(distance: number): void {
    const target = orbits.eyeOf(this.orbit).addScaledVector(orbits.ahead(this.orbit), distance);
    this.put({ ...this.orbit, target, distance });
  }

  turn(right: number, down: number): void {
    this.put(orbits.turned(this.orbit, right, down));
  }

  pan(right: number, down: number): void {
    this.put(orbits.panned(this.orbit, right, down, fieldOfView));
  }

  zoom(factor: number, direction: Vector3 | null): void {
    this.put(orbits.zoomed(this.orbit, factor, direction));
  }

  /// Moves with an entity.
  shift(way: Vector3): void {
    this.put({ ...this.orbit, target: this.orbit.target.clone().add(way) });
  }

  lookFrom(direction: orbits.Direction): void {
    this.put(orbits.from(this.orbit, direction));
  }

  lookAt(middle: Vector3, radius: number): void {
    this.put(orbits.fitted(this.orbit, middle, radius, fieldOfView, this.camera.aspect));
  }

  get placement(): Placement {
    return orbits.placementOfEye(this.orbit);
  }

  set placement(X_WorldEye: Placement) {
    this.put(orbits.orbitFrom(X_WorldEye));
  }
}
