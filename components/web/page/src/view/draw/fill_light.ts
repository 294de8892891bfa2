import { Color, DirectionalLight, Group, HemisphereLight, Vector3 } from 'three';

// shares of the ambient light: what all faces get, and what those that look up get in addition
const everywhere = 0.6;
const fromAbove = 0.4;
// of the ambient light, on a face that looks at the fill light
const fill = 0.5;
// how far the fill light is from opposite the sun [rad]
const aside = 0.6;

/// Light by which people see shapes that cameras see as flat: between faces without sun, which the ambient light alone
/// makes equal, edges become visible. The ground is as bright as in the cameras' images.
export class FillLight {
  readonly group = new Group();
  private readonly hemisphere = new HemisphereLight(new Color(), new Color(0, 0, 0));
  private readonly fill = new DirectionalLight();

  constructor() {
    this.hemisphere.position.set(0, 0, 1);
    this.group.add(this.hemisphere, this.fill, this.fill.target);
    this.group.visible = false;
  }

  /// @param ambient The world's ambient light.
  /// @param sun The direction of the light of the first directional light; null: there is none.
  /// @return The ambient light that remains.
  set(ambient: Color, sun: Vector3 | null): Color {
    this.hemisphere.color.copy(ambient).multiplyScalar(fromAbove);
    // three divides by pi
    this.fill.color.copy(ambient).multiplyScalar(fill * Math.PI);
    const yaw = sun && Math.hypot(sun.x, sun.y) > 1e-3 ? Math.atan2(sun.y, sun.x) : Math.PI / 4;
    // horizontal: the ground gets none of it
    this.fill.position.set(Math.cos(yaw + aside), Math.sin(yaw + aside), 0);
    this.group.visible = true;
    return ambient.clone().multiplyScalar(everywhere);
  }

  switchOff(): void {
    this.group.visible = false;
  }
}
