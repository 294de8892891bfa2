import { PCFShadowMap, WebGLRenderer } from 'three';

/// The canvas of the test for WebGL 2. The next renderer uses it where graphics are emulated, because there creating a
/// context takes a while.
let tried: HTMLCanvasElement | undefined;

/// A context without antialiasing, which doubles the time of each frame where graphics are emulated.
function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext | null {
  return canvas.getContext('webgl2', { antialias: false }) as WebGL2RenderingContext | null;
}

/// Whether this browser has WebGL 2.
export function hasWebGl(): boolean {
  try {
    tried ??= document.createElement('canvas');
    return contextOf(tried) !== null;
  } catch {
    return false;
  }
}

/// Whether WebGL is emulated by the processor, from the name of the renderer.
export function isEmulated(name: string): boolean {
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

function nameOf(gl: WebGL2RenderingContext): string {
  const details = gl.getExtension('WEBGL_debug_renderer_info');
  return String(gl.getParameter(details ? details.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
}

/// @return The renderer, and whether graphics are emulated.
/// @throws Error if this browser does not have WebGL 2.
export function makeRenderer(): { renderer: WebGLRenderer; isSlow: boolean } {
  const gl = hasWebGl() && tried ? contextOf(tried) : null;
  const isSlow = gl !== null && isEmulated(nameOf(gl));
  const renderer = new WebGLRenderer({ antialias: !isSlow, ...(isSlow && tried && { canvas: tried }) });
  tried = undefined;
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  renderer.shadowMap.autoUpdate = false;
  return { renderer, isSlow };
}
