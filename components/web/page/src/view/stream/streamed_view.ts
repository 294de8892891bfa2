import { MathUtils, Vector3 } from 'three';

import { type Direction, OrbitCamera } from '../camera/orbit_camera.ts';
import { keyMove } from '../camera/keys.ts';
import { Pointer } from '../camera/pointer.ts';
import { fillWithCanvas } from '../canvas.ts';
import { type Pose, placementOfPose, poseOf } from '../maths/placement.ts';
import { pictureSize, StreamScale } from './stream_scale.ts';

/// What the server is asked to draw.
export interface PictureWish {
  /// x, y, z and the quaternion x, y, z, w of the eye, which looks along x with z up.
  pose: number[];
  /// Vertical angle [rad].
  fieldOfView: number;
  width: number;
  height: number;
  grid: boolean;
}

export interface StreamOptions {
  /// Asks the server for a picture, instead of one that was asked for before.
  ask(wish: PictureWish): void;
  /// The viewpoint has changed.
  onCamera?(): void;
  /// The server can't draw; the text is for the user.
  onProblem?(text: string): void;
}

// time without a motion after which a picture has the full resolution [ms]
const restTime = 300;

/// The world in pictures that the server draws, for browsers without WebGL 2 and for slow connections. It asks for the
/// next picture when it has one, and for none while the page is hidden.
export class StreamedView {
  readonly canvas = document.createElement('canvas');
  private readonly orbitCamera = new OrbitCamera(() => this.moved());
  private readonly pointer: Pointer;
  private readonly end = new AbortController();
  private readonly sizes: ResizeObserver;
  private readonly scale = new StreamScale();
  private nextFrame: number | null = null;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private isMoving = false;
  /// When the picture was asked for that has not arrived yet [ms].
  private askedAt: number | null = null;
  private wantsGrid = true;
  private pictures = 0;

  constructor(private readonly parent: HTMLElement, private readonly options: StreamOptions) {
    const { canvas } = this;
    fillWithCanvas(parent, canvas, 'Picture of the world, drawn by the server');
    const { signal } = this.end;
    canvas.addEventListener('keydown', (event) => this.moveByKey(event), { signal });
    document.addEventListener('visibilitychange', () => this.askSoon(), { signal });
    this.pointer = new Pointer(canvas, this.orbitCamera.controls, { turns: () => {}, click: () => {}, hover: () => {} });
    this.orbitCamera.controls.connect(canvas);
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(parent);
    this.resize();
  }

  /// Asks again, because the connection is another.
  again(): void {
    this.askedAt = null;
    this.askSoon();
  }

  /// A message of the server: a JPEG file, or why there is none.
  async receive(payload: Uint8Array): Promise<void> {
    const asked = this.askedAt;
    this.askedAt = null;
    if (payload[0] !== 0xff) {
      this.options.onProblem?.(new TextDecoder().decode(payload));
      return;
    }
    if (asked !== null && this.isMoving) this.scale.arrived(performance.now() - asked);
    this.askSoon();
    const picture = await createImageBitmap(new Blob([payload as Uint8Array<ArrayBuffer>], { type: 'image/jpeg' }));
    const { canvas } = this;
    if (canvas.width !== picture.width || canvas.height !== picture.height) {
      canvas.width = picture.width;
      canvas.height = picture.height;
    }
    canvas.getContext('2d')!.drawImage(picture, 0, 0);
    picture.close();
    ++this.pictures;
  }

  /// Pictures so far, and the size of the last one.
  get statistics(): { pictures: number; width: number; height: number } {
    return { pictures: this.pictures, width: this.canvas.width, height: this.canvas.height };
  }

  lookFrom(direction: Direction): void {
    this.orbitCamera.lookFrom(direction);
  }

  /// Looks at a place from 2 m.
  lookAt(x: number, y: number, z: number): void {
    this.orbitCamera.lookAt(new Vector3(x, y, z), 1);
  }

  setCamera(pose: Pose): void {
    this.orbitCamera.placement = placementOfPose(pose);
  }

  camera(): Pose {
    return poseOf(this.orbitCamera.placement);
  }

  setGrid(on: boolean): void {
    this.wantsGrid = on;
    this.askSoon();
  }

  /// The last picture as a PNG file.
  screenshot(): Promise<Blob> {
    return new Promise((resolve, reject) =>
      this.canvas.toBlob((file) => (file ? resolve(file) : reject(new Error('the browser makes no PNG')))));
  }

  dispose(): void {
    clearTimeout(this.rest);
    if (this.nextFrame !== null) cancelAnimationFrame(this.nextFrame);
    this.end.abort();
    this.sizes.disconnect();
    this.pointer.dispose();
    this.orbitCamera.controls.dispose();
    this.canvas.remove();
  }

  private resize(): void {
    this.orbitCamera.resize(this.parent.clientWidth, this.parent.clientHeight);
    this.askSoon();
  }

  private moved(): void {
    // the camera is placed while this is being made
    if (!this.options) return;
    this.options.onCamera?.();
    this.isMoving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => {
      this.isMoving = false;
      this.askSoon();
    }, restTime);
    this.askSoon();
  }

  private askSoon(): void {
    this.nextFrame ??= requestAnimationFrame(() => {
      this.nextFrame = null;
      this.ask();
    });
  }

  private ask(): void {
    const { clientWidth, clientHeight } = this.parent;
    if (document.hidden || clientWidth === 0 || clientHeight === 0) return;
    const [width, height] = pictureSize(clientWidth, clientHeight, this.scale.now(this.isMoving));
    const { position, orientation } = this.camera();
    this.askedAt ??= performance.now();
    this.options.ask({
      pose: [...position, ...orientation], width, height, grid: this.wantsGrid,
      fieldOfView: MathUtils.degToRad(this.orbitCamera.camera.fov),
    });
  }

  private moveByKey(event: KeyboardEvent): void {
    const move = keyMove(event);
    if (move === null) return;
    event.preventDefault();
    event.stopPropagation();
    if ('turn' in move) this.orbitCamera.turn(...move.turn);
    else this.orbitCamera.zoom(move.zoom);
  }
}
