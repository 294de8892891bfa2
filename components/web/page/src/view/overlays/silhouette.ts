import {
  Box3,
  type BufferGeometry,
  Color,
  DoubleSide,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  type PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShaderMaterial,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

import type { Stage } from '../scene/stage.ts';

// of the two lines [pixels]: a bright one at the edge, and a dark one around it, so that it is visible on any ground
const inner = 2;
const outer = 3.5;

const vertexShader = `
varying vec2 at;
void main() {
  at = uv;
  gl_Position = vec4(position.xy * 2.0, 0.0, 1.0);
}`;

const fragmentShader = `
uniform sampler2D mask;
uniform vec2 pixel;
uniform vec3 bright;
varying vec2 at;
float around(float radius) {
  float most = 0.0;
  for (int i = 0; i < 8; ++i) {
    float angle = float(i) * 0.7853982;
    most = max(most, texture2D(mask, at + radius * pixel * vec2(cos(angle), sin(angle))).r);
  }
  return most;
}
void main() {
  if (texture2D(mask, at).r > 0.5) discard;
  if (around(${inner.toFixed(1)}) > 0.5) gl_FragColor = vec4(bright, 1.0);
  else if (around(${outer.toFixed(1)}) > 0.5) gl_FragColor = vec4(0.0, 0.0, 0.0, 0.6);
  else discard;
  #include <colorspace_fragment>
}`;

/// The part of the image that a box covers, in pixels, with a margin; null: all of it.
export function screenBox(box: Box3, camera: PerspectiveCamera, size: Vector2): { x: number; y: number; width: number; height: number } | null {
  const low = new Vector2(Infinity, Infinity);
  const high = new Vector2(-Infinity, -Infinity);
  const corner = new Vector3();
  for (let i = 0; i < 8; ++i) {
    corner.set(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z);
    // behind the camera the projection is of no use
    if (corner.clone().applyMatrix4(camera.matrixWorldInverse).z > -camera.near) return null;
    corner.project(camera);
    const place = new Vector2(((corner.x + 1) / 2) * size.x, ((corner.y + 1) / 2) * size.y);
    low.min(place);
    high.max(place);
  }
  const margin = Math.ceil(outer) + 1;
  low.floor().subScalar(margin).max(new Vector2(0, 0));
  high.ceil().addScalar(margin).min(size);
  return { x: low.x, y: low.y, width: Math.max(high.x - low.x, 0), height: Math.max(high.y - low.y, 0) };
}

/// The line around the selected entity, drawn over the image.
export class Silhouette {
  private readonly scene = new Scene();
  private readonly white = new MeshBasicMaterial({ color: 0xffffff, side: DoubleSide });
  private readonly line = new ShaderMaterial({
    vertexShader, fragmentShader, transparent: true, depthTest: false, depthWrite: false,
    uniforms: { mask: { value: null }, pixel: { value: new Vector2() }, bright: { value: new Color(0xff9a1f) } },
  });
  private readonly quad = new Mesh(new PlaneGeometry(), this.line);
  private readonly flat = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  private readonly box = new Box3();
  private target: WebGLRenderTarget | null = null;

  constructor() {
    this.quad.frustumCulled = false;
  }

  /// Moves the line to an entity with visible parts.
  /// @return Whether there is one.
  update(stage: Stage, entity: number | null): boolean {
    let count = 0;
    this.box.makeEmpty();
    for (const { geometry, M_WorldForm } of entity === null ? [] : stage.surfacesOf(entity)) {
      const mesh = this.meshAt(count++, geometry);
      mesh.matrixWorld.copy(M_WorldForm);
      if (geometry.boundingBox === null) geometry.computeBoundingBox();
      this.box.union(geometry.boundingBox!.clone().applyMatrix4(M_WorldForm));
    }
    this.scene.children.length = count;
    return count > 0;
  }

  private meshAt(index: number, geometry: BufferGeometry): Mesh {
    let mesh = this.scene.children[index] as Mesh | undefined;
    if (mesh === undefined) {
      mesh = new Mesh(geometry, this.white);
      mesh.matrixAutoUpdate = mesh.matrixWorldAutoUpdate = false;
      this.scene.children.push(mesh);
    }
    mesh.geometry = geometry;
    return mesh;
  }

  /// Draws the line over the image that has been rendered.
  render(renderer: WebGLRenderer, camera: PerspectiveCamera): void {
    if (this.scene.children.length === 0) return;
    const size = renderer.getDrawingBufferSize(new Vector2());
    this.target ??= new WebGLRenderTarget(1, 1, { depthBuffer: false });
    if (this.target.width !== size.x || this.target.height !== size.y) this.target.setSize(size.x, size.y);
    const part = screenBox(this.box, camera, size);
    if (part && (part.width === 0 || part.height === 0)) return;
    const { autoClear } = renderer;
    const ratio = renderer.getPixelRatio();
    renderer.setRenderTarget(this.target);
    this.target.scissorTest = false;
    renderer.setClearColor(0x000000, 0);
    renderer.clear();
    renderer.render(this.scene, camera);
    renderer.setRenderTarget(null);
    this.line.uniforms['mask']!.value = this.target.texture;
    (this.line.uniforms['pixel']!.value as Vector2).set(ratio / size.x, ratio / size.y);
    renderer.autoClear = false;
    if (part) {
      renderer.setScissorTest(true);
      renderer.setScissor(part.x / ratio, part.y / ratio, part.width / ratio, part.height / ratio);
    }
    renderer.render(this.quad, this.flat);
    renderer.setScissorTest(false);
    renderer.autoClear = autoClear;
  }

  dispose(): void {
    this.target?.dispose();
    this.white.dispose();
    this.line.dispose();
    this.quad.geometry.dispose();
  }
}

/// A surface and its pose in the world.
export interface Surface {
  geometry: BufferGeometry;
  M_WorldForm: Matrix4;
}
