import {
  DoubleSide,
  LinearFilter,
  Mesh,
  OrthographicCamera,
  PlaneGeometry,
  RedFormat,
  Scene,
  ShaderMaterial,
  type Sphere,
  type Texture,
  Vector2,
  Vector3,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

import type { Batches } from './batches.ts';

/// What stands on the ground, and so darkens it.
export const contactLayer = 1;

// of the picture from below [pixels]
const edge = 512;
// least blur: standard deviation [pixels], and in the world [m]
const leastBlur = 2;
const blur = 0.1;
// how far above the ground bodies darken it [m]
const reach = 0.4;
// how far below the ground the picture begins: wheels and feet go into it, and what is deeper is hidden [m]
const depth = 0.2;
const darkness = 0.7;

const undersideVertices = `
varying float height;
void main() {
  vec4 at = vec4(position, 1.0);
  #ifdef USE_INSTANCING
    at = instanceMatrix * at;
  #endif
  at = modelMatrix * at;
  height = at.z;
  gl_Position = projectionMatrix * viewMatrix * at;
}`;

const undersideFragments = `
uniform float ground;
varying float height;
void main() {
  float near = clamp(1.0 - (height - ground) / ${reach.toFixed(2)}, 0.0, 1.0);
  gl_FragColor = vec4(near * near, 0.0, 0.0, 1.0);
}`;

const flatVertices = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}`;

// a Gaussian along one axis, of which the samples reach to twice its standard deviation
const blurFragments = `
uniform sampler2D picture;
uniform vec2 deviation;
varying vec2 at;
void main() {
  float sum = 0.0;
  float weights = 0.0;
  for (int i = -4; i <= 4; ++i) {
    float far = float(i) * 0.5;
    float weight = exp(-0.5 * far * far);
    sum += weight * texture2D(picture, at + far * deviation).r;
    weights += weight;
  }
  gl_FragColor = vec4(sum / weights, 0.0, 0.0, 1.0);
}`;

/// What planes need to know: the picture, and where it is (x and y of its middle, half its width, height). A width of 0: there
/// is no shadow.
export const contactShadow = {
  contactPicture: { value: null as Texture | null },
  contactPlace: { value: new Vector4() },
};

/// To be added to the shaders of planes: before `main`, and inside.
export const contactChunks = {
  vertexHead: 'varying vec3 contactAt;\n',
  vertex: `
{
  vec4 at = vec4(transformed, 1.0);
  #ifdef USE_INSTANCING
    at = instanceMatrix * at;
  #endif
  contactAt = (modelMatrix * at).xyz;
}`,
  fragmentHead: 'varying vec3 contactAt;\nuniform sampler2D contactPicture;\nuniform vec4 contactPlace;\n',
  // it fades at the picture's border
  fragment: `
if (contactPlace.z > 0.0 && abs(contactAt.z - contactPlace.w) < 0.01) {
  vec2 at = (contactAt.xy - contactPlace.xy) / contactPlace.z;
  float fade = 1.0 - smoothstep(0.9, 1.0, max(abs(at.x), abs(at.y)));
  // from below, the picture is mirrored
  float light = 1.0 - ${darkness.toFixed(2)} * fade * texture2D(contactPicture, 0.5 + 0.5 * vec2(-at.x, at.y)).r;
  outgoingLight *= light * light;
}
`,
};

/// The dark spot under each body where it stands on a plane: there, little of the ambient light arrives, which has no
/// shadows of its own. It is a picture of all bodies from below, darker the nearer they are, and blurred, as in three's example
/// webgl_shadow_contact.
export class ContactShadow {
  private readonly bodies = new Scene();
  private readonly underside = new ShaderMaterial({
    vertexShader: undersideVertices, fragmentShader: undersideFragments, side: DoubleSide, uniforms: { ground: { value: 0 } },
  });
  private readonly smooth = new ShaderMaterial({
    vertexShader: flatVertices, fragmentShader: blurFragments, depthTest: false, depthWrite: false,
    uniforms: { picture: { value: null }, deviation: { value: new Vector2() } },
  });
  private readonly quad = new Mesh(new PlaneGeometry(2, 2), this.smooth);
  private readonly camera = new OrthographicCamera();
  private readonly flat = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  private targets: [WebGLRenderTarget, WebGLRenderTarget] | null = null;

  constructor() {
    this.bodies.overrideMaterial = this.underside;
    this.quad.frustumCulled = false;
    this.camera.layers.set(contactLayer);
  }

  /// Renders the shadow of what stands on the ground; there is none without ground.
  /// @param ground Its height.
  /// @param region Where there are bodies.
  render(renderer: WebGLRenderer, batches: Batches, ground: number | null, region: Sphere | null): void {
    this.hide();
    if (ground === null || region === null) return;
    this.targets ??= [pictureTarget(true), pictureTarget(false)];
    const [first, second] = this.targets;
    const half = region.radius + 4 * blur;
    this.look(new Vector3(region.center.x, region.center.y, ground), half);
    this.underside.uniforms['ground']!.value = ground;
    // rendering does not need to be their parent
    this.bodies.children = [batches.group];
    renderer.setClearColor(0x000000, 0);
    renderer.setRenderTarget(first);
    renderer.clear();
    renderer.render(this.bodies, this.camera);
    const deviation = Math.max(leastBlur / edge, blur / (2 * half));
    this.blur(renderer, first.texture, second, deviation, 0);
    this.blur(renderer, second.texture, first, 0, deviation);
    renderer.setRenderTarget(null);
    contactShadow.contactPicture.value = first.texture;
    contactShadow.contactPlace.value.set(region.center.x, region.center.y, half, ground);
  }

  hide(): void {
    contactShadow.contactPlace.value.setZ(0);
  }

  private look(center: Vector3, half: number): void {
    const { camera } = this;
    camera.left = camera.bottom = -half;
    camera.right = camera.top = half;
    camera.near = 0;
    camera.far = depth + reach;
    camera.position.copy(center).setZ(center.z - depth);
    camera.lookAt(center);
    camera.updateProjectionMatrix();
  }

  private blur(renderer: WebGLRenderer, from: Texture, to: WebGLRenderTarget, x: number, y: number): void {
    this.smooth.uniforms['picture']!.value = from;
    (this.smooth.uniforms['deviation']!.value as Vector2).set(x, y);
    renderer.setRenderTarget(to);
    renderer.render(this.quad, this.flat);
  }

  dispose(): void {
    for (const target of this.targets ?? []) target.dispose();
    for (const material of [this.underside, this.smooth]) material.dispose();
    this.quad.geometry.dispose();
  }
}

function pictureTarget(depthBuffer: boolean): WebGLRenderTarget {
  return new WebGLRenderTarget(edge, edge, { format: RedFormat, depthBuffer, minFilter: LinearFilter, magFilter: LinearFilter });
}
