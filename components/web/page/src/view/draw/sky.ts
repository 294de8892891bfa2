import { BackSide, Color, Mesh, ShaderMaterial, SphereGeometry } from 'three';

import type { SkyMessage } from '../messages.ts';

export interface SkyColors {
  zenith: Color;
  horizon: Color;
}

/// The colours of the sky at a time of day, as for the simulated cameras: bright during the day, dark from about an
/// hour after sunset.
export function skyColors(sky: SkyMessage): SkyColors {
  const { time = 0, sunrise = 0, sunset = 0 } = sky;
  const length = sunset - sunrise;
  const sun = length > 0 ? Math.sin((Math.PI * (time - sunrise)) / length) : 1;
  const daylight = Math.min(Math.max(0.5 + 3 * sun, 0.05), 1);
  return {
    zenith: new Color(0.09, 0.24, 0.6).multiplyScalar(daylight),
    horizon: new Color(0.55, 0.7, 0.85).multiplyScalar(daylight),
  };
}

const vertexShader = `
varying vec3 direction;
void main() {
  direction = position;
  // always centred on the camera, behind everything
  gl_Position = (projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0)).xyww;
}`;

const fragmentShader = `
uniform vec3 zenith;
uniform vec3 horizon;
varying vec3 direction;
void main() {
  gl_FragColor = vec4(mix(horizon, zenith, pow(max(normalize(direction).z, 0.0), 0.5)), 1.0);
  #include <colorspace_fragment>
}`;

/// A dome around the viewpoint.
export function skyDome({ zenith, horizon }: SkyColors): Mesh {
  const uniforms = { zenith: { value: zenith }, horizon: { value: horizon } };
  const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms, side: BackSide, depthWrite: false });
  const dome = new Mesh(new SphereGeometry(1, 32, 32), material);
  dome.frustumCulled = false;
  dome.renderOrder = -1;
  return dome;
}
