import { MOUSE, PerspectiveCamera, Raycaster, Vector2, Vector3 } from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';

import { type Placement, fromRollPitchYaw } from '../maths/placement.ts';

export type Direction = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'home';

// vertical field of view [rad]
const fieldOfView = 1.05;
// largest pitch [rad], because the yaw is undefined for a vertical view
const steepest = Math.PI / 2 - 0.001;
// limits of the distance from the target [m]
const nearest = 0.05;
const farthest = 5000;
// in parallel projection [m]
const behind = 500;
/// Fortress's initial viewpoint.
const home: Placement = { position: new Vector3(-6, 0, 6), rotation: fromRollPitchYaw(0, 0.5, 0) };
// directions of sight; 'front' looks at the side of an entity that is in the direction of its x
const sides: Record<Exclude<Direction, 'home'>, [yaw: number, pitch: number]> = {
  front: [Math.PI, 0],
  back: [0, 0],
  left: [-Math.PI / 2, 0],
  right: [Math.PI / 2, 0],
  top: [0, steepest],
  bottom: [0, -steepest],
};

/// The direction for a yaw, from x towards y, and a pitch, downward [rad].
function lineOfSight(yaw: number, pitch: number): Vector3 {
  const flat = Math.cos(pitch);
  return new Vector3(flat * Math.cos(yaw), flat * Math.sin(yaw), -Math.sin(pitch));
}

function anglesOf(sight: Vector3): [yaw: number, pitch: number] {
  const yaw = Math.hypot(sight.x, sight.y) < 1e-6 ? 0 : Math.atan2(sight.y, sight.x);
  const pitch = Math.asin(Math.min(Math.max(-sight.z, -1), 1));
  return [yaw, Math.min(Math.max(pitch, -steepest), steepest)];
}

/// A camera that can project in parallel. It stays a perspective camera to OrbitControls, whose panning and zooming are
/// those of the plane of the target, which has the same size in both.
class SwitchableCamera extends PerspectiveCamera {
  /// Distance of the plane that has the same size in both projections [m]; null: perspective.
  parallel: number | null = null;

  override updateProjectionMatrix(): void {
    super.updateProjectionMatrix();
    if (!this.parallel) return;
    const up = this.parallel * Math.tan(fieldOfView / 2);
    const right = up * this.aspect;
    // what is behind the eye is visible, too
    this.projectionMatrix.makeOrthographic(-right, right, up, -up, -behind, farthest, this.coordinateSystem);
    this.projectionMatrixInverse.copy(this.projectionMatrix).invert();
  }
}

/// The camera of the view, with z up. It looks at a target, around which three's OrbitControls rotate it.
export class OrbitCamera {
  readonly camera = new SwitchableCamera((fieldOfView * 180) / Math.PI, 1, 0.02, farthest);
  readonly controls: OrbitControls;

  /// @param changed Called when the viewpoint has changed.
  constructor(changed: () => void = () => {}) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera);
    // the buttons of Fortress; with Shift, OrbitControls rotate by the button that pans
    this.controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.ROTATE, RIGHT: MOUSE.DOLLY };
    this.controls.zoomToCursor = true;
    // a drag over the height of the view rotates by pi
    this.controls.rotateSpeed = 0.5;
    this.controls.minPolarAngle = Math.PI / 2 - steepest;
    this.controls.maxPolarAngle = Math.PI / 2 + steepest;
    this.controls.minDistance = nearest;
    this.controls.maxDistance = farthest;
    this.controls.addEventListener('change', () => {
      // the depth buffer is precise only if the near plane is not much nearer than the target
      if (this.camera.parallel) this.camera.parallel = this.controls.getDistance();
      this.camera.near = Math.min(Math.max(this.controls.getDistance() / 200, 0.005), 0.5);
      this.camera.updateProjectionMatrix();
      this.camera.updateMatrixWorld();
      changed();
    });
    this.placement = home;
  }

  get isParallel(): boolean {
    return this.camera.parallel !== null;
  }

  /// Switches between parallel and perspective projection; what is at the target keeps its size.
  set isParallel(on: boolean) {
    this.camera.parallel = on ? this.controls.getDistance() : null;
    this.camera.updateProjectionMatrix();
  }

  get target(): Vector3 {
    return this.controls.target;
  }

  private get sight(): Vector3 {
    return this.camera.getWorldDirection(new Vector3());
  }

  private look(target: Vector3, sight: Vector3, distance: number): void {
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(sight, -distance);
    this.controls.update();
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  /// @param x, y Fractions of the view's width and height, from its upper left corner.
  rayThrough(x: number, y: number): Raycaster {
    const ray = new Raycaster();
    const [right, up] = [2 * x - 1, 1 - 2 * y];
    ray.setFromCamera(new Vector2(right, up), this.camera);
    if (!this.isParallel) return ray;
    const from = new Vector3(right, up, -1).unproject(this.camera);
    ray.set(from, this.sight);
    return ray;
  }

  /// Sets the target of rotations, at this distance along the line of sight [m].
  turnAround(distance: number): void {
    if (this.isParallel) return;
    this.controls.target.copy(this.camera.position).addScaledVector(this.sight, distance);
    this.controls.update();
  }

  /// @param right, down Motion of the pointer, as fractions of the view's height.
  turn(right: number, down: number): void {
    this.controls.rotateLeft(right * Math.PI);
    this.controls.rotateUp(down * Math.PI);
  }

  /// @param factor By which the distance to the target is multiplied.
  zoom(factor: number): void {
    this.controls.dollyIn(factor);
  }

  /// Moves the viewpoint by an offset, to follow an entity.
  shift(offset: Vector3): void {
    this.look(this.target.clone().add(offset), this.sight, this.controls.getDistance());
  }

  /// Looks at the same target from a side.
  lookFrom(direction: Direction): void {
    if (direction === 'home') this.placement = home;
    else this.look(this.target.clone(), lineOfSight(...sides[direction]), this.controls.getDistance());
  }

  /// Moves back or forth so that the whole sphere is visible, in the current direction.
  lookAt(middle: Vector3, radius: number): void {
    const half = Math.atan(Math.tan(fieldOfView / 2) * Math.min(this.camera.aspect, 1));
    this.look(middle, this.sight, Math.min(Math.max((1.1 * radius) / Math.sin(half), 0.3), farthest));
  }

  /// The viewpoint as a pose whose x axis is the line of sight, with z up.
  get placement(): Placement {
    const [yaw, pitch] = anglesOf(this.sight);
    return { position: this.camera.position.clone(), rotation: fromRollPitchYaw(0, pitch, yaw) };
  }

  /// The target is set to the point of the ground at which the camera looks, or 10 m ahead if that is behind or too
  /// far.
  set placement({ position, rotation }: Placement) {
    const sight = lineOfSight(...anglesOf(new Vector3(1, 0, 0).applyQuaternion(rotation)));
    const toGround = sight.z < -0.05 ? position.z / -sight.z : -1;
    const distance = toGround > nearest && toGround < 100 ? toGround : 10;
    this.look(position.clone().addScaledVector(sight, distance), sight, distance);
  }
}
