import { Sphere, type Vector3, type WebGLRenderer } from 'three';

import { type Direction, OrbitCamera } from './camera/orbit_camera.ts';
import { keyMove } from './camera/keys.ts';
import { AdaptiveResolution } from './camera/adaptive_resolution.ts';
import { Pointer } from './camera/pointer.ts';
import { fillWithCanvas } from './canvas.ts';
import { hasWebGl, makeRenderer } from './draw/renderer.ts';
import { Shadows } from './draw/shadows.ts';
import { type Pose, placementOfPose, poseOf } from './maths/placement.ts';
import type { Message, SceneMessage } from './messages.ts';
import { Cloud } from './overlays/cloud.ts';
import { ContactsByKey } from './overlays/contacts.ts';
import { type Theme, gridOf } from './overlays/grid.ts';
import { Marked } from './overlays/marked.ts';
import { Markers } from './overlays/markers.ts';
import { MeasureLine } from './overlays/measure_line.ts';
import { Outline } from './overlays/outline.ts';
import { Scan } from './overlays/scan.ts';
import { Sensed } from './overlays/sensed.ts';
import { Silhouette } from './overlays/silhouette.ts';
import { Trail } from './overlays/trail.ts';
import type { Frame } from './scene/places.ts';
import { type Overlay, Shown } from './scene/shown.ts';
import { Stage } from './scene/stage.ts';
import { Drag } from './tools/drag.ts';
import { Handles, type Tool } from './tools/handles.ts';
import { pictureOf } from './tools/picture.ts';
import { Placing } from './tools/placing.ts';
import { Recorder } from './tools/recorder.ts';

export interface ViewOptions {
  /// Returns the bytes of a file (mesh, texture, material) by its address in the scene.
  asset(address: string): Promise<ArrayBuffer>;
  /// The user has selected the entity, or nothing (null).
  onPick?(entity: number | null): void;
  /// The user has dragged the model to a pose; during: the drag continues. At its end the result may be a promise. The
  /// model is shown at the pose until the promise has resolved and a new pose has arrived; it moves back at once if the
  /// promise rejects.
  onMove?(entity: number, pose: Pose, during: boolean): void | Promise<unknown>;
  /// The user has chosen a pose for the model of `showGhost`; null: cancelled.
  onPlace?(pose: Pose | null): void;
  /// The viewpoint has changed.
  onCamera?(): void;
  /// Something can't be shown; the text is for the user.
  onProblem?(text: string): void;
}

// scale of pictures that stay where graphics are emulated, which have no antialiasing there
const supersampling = 1.5;
// time without a change after which the view is rendered in full resolution [ms]
const restTime = 300;
const longestRest = 1500;

/// The 3D view. It renders only after changes.
export class View {
  readonly canvas: HTMLCanvasElement;
  private readonly renderer: WebGLRenderer;
  private readonly orbitCamera = new OrbitCamera(() => {
    this.options?.onCamera?.();
    this.invalidate();
  });
  private readonly shown = new Shown();
  private readonly stage: Stage;
  private readonly marked: Marked;
  private readonly outline = new Outline();
  private readonly silhouette = new Silhouette();
  private readonly measure = new MeasureLine();
  private readonly scans: Sensed;
  private readonly clouds: Sensed;
  private readonly contacts = new ContactsByKey();
  private readonly markers: Markers;
  private readonly trails = new Map<number, Trail>();
  private readonly handles: Handles;
  private readonly drag: Drag;
  private readonly placing: Placing;
  private readonly pointer: Pointer;
  private readonly end = new AbortController();
  private readonly sizes: ResizeObserver;
  private theme: Theme = 'light';
  private isAsCameras = false;
  private grid = gridOf('light');
  private wantsGrid: boolean | null = null;
  private wantsShadows = true;
  private sceneShadows = true;
  private selected: number | null = null;
  private followed: { entity: number; last: Vector3 | null } | null = null;
  private recorder: Recorder | null = null;
  private nextFrame: number | null = null;
  private readonly resolution = new AdaptiveResolution();
  private scale = 1;
  /// The scale of a picture that stays.
  private readonly fullScale: number;
  private frames = 0;
  private lastRender = { drawCalls: 0, triangles: 0 };
  private requestedAt = 0;
  private took = 0;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private readonly shadows: Shadows;

  /// Whether this browser supports 3D graphics (WebGL 2).
  static supported(): boolean {
    return hasWebGl();
  }

  /// @throws Error if this browser does not support WebGL 2.
  constructor(
    parent: HTMLElement,
    private readonly options: ViewOptions,
  ) {
    const { renderer, isSlow } = makeRenderer();
    this.renderer = renderer;
    this.fullScale = isSlow ? supersampling : 1;
    this.canvas = this.renderer.domElement;
    this.prepareCanvas(parent);
    this.stage = new Stage({
      asset: (address) => options.asset(address),
      changed: () => this.sceneChanged(),
      problem: (text) => options.onProblem?.(text),
      styleOf: (place) => ({ wireframe: this.has('wireframe', place), transparent: this.has('transparent', place) }),
    });
    this.shadows = new Shadows(this.renderer, this.stage, this.orbitCamera.camera);
    const invalidate = () => this.invalidate();
    this.marked = new Marked(this.stage, this.shown, invalidate);
    this.scans = new Sensed(this.stage, () => new Scan());
    this.clouds = new Sensed(this.stage, () => new Cloud());
    this.markers = new Markers(this.stage);
    this.drag = new Drag(this.stage.places, invalidate);
    this.handles = new Handles(this.orbitCamera.camera, this.canvas, this.stage.root, {
      moved: (placement, during) => this.handlesMoved(poseOf(placement), during),
      busy: (isBusy) => (this.orbitCamera.controls.enabled = !isBusy),
      changed: invalidate,
    });
    this.placing = new Placing(this.stage, this.orbitCamera, this.canvas, {
      changed: invalidate,
      placed: (pose) => options.onPlace?.(pose),
    }, this.end.signal);
    this.pointer = new Pointer(this.canvas, this.orbitCamera.controls, {
      turns: (x, y) => this.turnAround(x, y),
      click: (x, y) => this.clicked(x, y),
      hover: (x, y) => this.placing.isActive && this.placing.hover(x, y),
    });
    this.orbitCamera.controls.connect(this.canvas);
    const over = [this.marked.group, this.scans.group, this.clouds.group, this.outline.object, this.measure.group, this.contacts.group, this.markers.group];
    this.stage.root.add(this.grid, ...over);
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(parent);
    this.setScene({});
    this.resize();
  }

  private prepareCanvas(parent: HTMLElement): void {
    const { canvas } = this;
    fillWithCanvas(parent, canvas, '3D view of the world');
    const { signal } = this.end;
    const lost = () => this.options.onProblem?.('the browser has released the graphics context of the 3D view');
    canvas.addEventListener('webglcontextlost', lost, { signal });
    canvas.addEventListener('webglcontextrestored', () => this.sceneChanged(), { signal });
    canvas.addEventListener('keydown', (event) => this.moveByKey(event), { signal });
    canvas.addEventListener('pointermove', (event) => this.handles.setSnapping(event.ctrlKey), { signal });
  }

  /// Draws at once: a new size empties the canvas, and the browser shows it before the next animation frame.
  private resize(): void {
    const parent = this.canvas.parentElement;
    const [width, height] = [parent?.clientWidth ?? 0, parent?.clientHeight ?? 0];
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.setScale(this.scale);
    this.orbitCamera.resize(width, height);
    this.draw();
    this.sharpenLater();
  }

  /// Sets the resolution to this fraction of the full width and height; the browser scales the image up.
  private setScale(scale: number): void {
    this.scale = scale;
    const ratio = Math.min(window.devicePixelRatio, 2) * scale;
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
  }

  private has(overlay: Overlay, place: number): boolean {
    return this.shown.has(overlay, place, this.stage.content.places);
  }

  private sceneChanged(): void {
    this.shadows.changed();
    this.invalidate();
  }

  /// Schedules a frame, if none is scheduled.
  private invalidate(): void {
    if (this.nextFrame !== null) return;
    this.requestedAt = performance.now();
    this.nextFrame = requestAnimationFrame(() => {
      this.nextFrame = null;
      // the resolution must not change within a video
      this.took = performance.now() - this.requestedAt;
      const scale = this.recorder ? 1 : this.resolution.next(this.took);
      this.setScale(scale);
      this.draw();
      if (this.recorder) this.invalidate();
      this.sharpenLater();
    });
  }

  /// Not between two frames of a motion, however long they take.
  private sharpenLater(): void {
    clearTimeout(this.rest);
    const whole = this.resolution.isReduced ? 1 : this.fullScale;
    if (this.scale < whole) this.rest = setTimeout(() => this.drawWhole(whole), Math.min(Math.max(restTime, 4 * this.took), longestRest));
  }

  /// Renders in full resolution, when nothing moves any more.
  private drawWhole(scale: number): void {
    this.setScale(scale);
    this.draw(true);
  }

  /// @param isStill Whether the picture stays.
  private draw(isStill = false): void {
    const moved = this.stage.moveMoved();
    for (const id of moved) {
      this.marked.move(id);
      const trail = this.trails.get(id);
      const position = trail && this.stage.places.position(id);
      if (position) trail.add(position);
    }
    if (moved.length > 0) this.goAlong();
    const hasSilhouette = this.silhouette.update(this.stage, this.selected);
    this.outline.update(this.stage, hasSilhouette ? null : this.selected);
    this.handles.put(this.movable === null ? null : this.stage.places.shown(this.movable));
    if (moved.length > 0) {
      this.scans.update();
      this.clouds.update();
      this.markers.update();
    }
    const isHurried = !isStill && (this.fullScale > 1 || this.resolution.isReduced);
    const hasContact = this.wantsShadows && this.sceneShadows && !this.isAsCameras && !isHurried;
    this.shadows.renew(this.orbitCamera.target, moved.length > 0, hasContact);
    this.stage.batches.arrange(this.orbitCamera.camera, this.renderer.domElement.height);
    this.renderer.render(this.stage.root, this.orbitCamera.camera);
    ++this.frames;
    this.lastRender = { drawCalls: this.renderer.info.render.calls, triangles: this.renderer.info.render.triangles };
    this.silhouette.render(this.renderer, this.orbitCamera.camera);
  }

  /// Sets a complete ignition.msgs.Scene. Entities that it still contains keep their poses, and their files are not
  /// loaded again.
  setScene(scene: Message): void {
    const message = scene as SceneMessage;
    this.stage.setScene(message);
    this.sceneShadows = message.shadows ?? true;
    this.setShadows(this.wantsShadows);
    this.grid.visible = this.wantsGrid ?? message.grid ?? true;
    // trails of removed entities end, because the page can't end them any more
    for (const id of [...this.trails.keys()]) if (!this.stage.content.places.has(id)) this.setTrail(id, false);
    this.marked.rebuild();
    this.markers.update();
    this.sceneChanged();
  }

  /// Whether the scene contains anything that cameras see.
  get hasVisuals(): boolean {
    return this.stage.content.visuals.length > 0;
  }

  applyFrame(frame: Frame): void {
    const hasMoved = this.stage.places.apply(frame);
    this.drag.received(frame.ids);
    if (hasMoved) this.invalidate();
  }

  select(entity: number | null): void {
    this.selected = entity;
    this.invalidate();
  }

  setTool(tool: Tool): void {
    this.handles.setTool(tool);
    this.invalidate();
  }

  /// The entity that the handles move: the selected model or light of the world.
  private get movable(): number | null {
    const place = this.stage.content.places.get(this.selected ?? 0);
    return place !== undefined && place.parent === 0 ? place.id : null;
  }

  private handlesMoved(pose: Pose, during: boolean): void {
    const entity = this.movable;
    if (entity === null) return;
    const answer = this.options.onMove?.(entity, pose, during);
    this.drag.move(entity, placementOfPose(pose), during ? null : Promise.resolve(answer));
  }

  /// Moves the viewpoint with the entity, around which it then rotates and to which it zooms; null ends that.
  follow(entity: number | null): void {
    this.followed = entity === null ? null : { entity, last: this.stage.places.position(entity)?.clone() ?? null };
    this.orbitCamera.controls.zoomToCursor = entity === null;
    if (this.followed?.last) this.orbitCamera.shift(this.followed.last.clone().sub(this.orbitCamera.target));
  }

  private goAlong(): void {
    const now = this.followed && this.stage.places.position(this.followed.entity)?.clone();
    if (this.followed === null || !now) return;
    if (this.followed.last) this.orbitCamera.shift(now.clone().sub(this.followed.last));
    this.followed.last = now;
  }

  /// Moves the viewpoint so that the whole entity is visible.
  lookAt(entity: number): void {
    const { center, radius } = this.stage.boundsOf(entity).getBoundingSphere(new Sphere());
    if (radius > 0) this.orbitCamera.lookAt(center, radius);
  }

  lookFrom(direction: Direction): void {
    this.orbitCamera.lookFrom(direction);
  }

  /// Sets the viewpoint, a pose whose x axis is the line of sight, with z up.
  setCamera(pose: Pose): void {
    this.orbitCamera.placement = placementOfPose(pose);
  }

  camera(): Pose {
    return poseOf(this.orbitCamera.placement);
  }

  setOrthographic(on: boolean): void {
    this.orbitCamera.isParallel = on;
    this.invalidate();
  }

  /// Shows or hides an overlay for one entity with its parts, or for all.
  setOverlay(overlay: Overlay, on: boolean, entity?: number): void {
    this.shown.set(overlay, on, entity);
    if (overlay === 'wireframe' || overlay === 'transparent') this.stage.restyle();
    else if (overlay === 'contacts' && !on) this.contacts.clear();
    else this.marked.rebuild();
    this.sceneChanged();
  }

  setGrid(on: boolean): void {
    this.wantsGrid = on;
    this.grid.visible = on;
    this.invalidate();
  }

  setShadows(on: boolean): void {
    this.wantsShadows = on;
    this.stage.lights.setShadows(on && this.sceneShadows);
    this.sceneChanged();
  }

  setTheme(theme: Theme): void {
    const grid = gridOf(theme);
    grid.visible = this.grid.visible;
    this.stage.root.remove(this.grid);
    this.grid.geometry.dispose();
    this.grid = grid;
    this.stage.root.add(grid);
    this.theme = theme;
    this.stage.setLook(this.theme, this.isAsCameras);
  }

  /// Whether light and background are as the simulated cameras see them.
  setAsCameras(on: boolean): void {
    this.isAsCameras = on;
    this.stage.setLook(this.theme, this.isAsCameras);
  }

  /// Shows an ignition.msgs.LaserScan under a key, such as its topic; null removes it. It is in the frame of the entity
  /// (a link or sensor), or without one in the frame that the message names.
  setLidar(key: string, scan: Message | null, entity?: number): void {
    this.scans.set(key, scan, entity);
    this.invalidate();
  }

  /// Shows an ignition.msgs.PointCloudPacked under a key; null removes it. It is in the frame of the entity (a link or
  /// sensor), or without one in the frame that the message names.
  setPointCloud(key: string, cloud: Message | null, entity?: number): void {
    this.clouds.set(key, cloud, entity);
    this.invalidate();
  }

  /// Shows an ignition.msgs.Contacts under a key; null removes it.
  setContacts(key: string, contacts: Message | null): void {
    this.contacts.set(key, contacts);
    this.invalidate();
  }

  /// Shows these ignition.msgs.Marker instead of the current ones.
  setMarkers(markers: ReadonlyMap<string, Message>): void {
    this.markers.set(markers);
    this.invalidate();
  }

  setTrail(entity: number, on: boolean): void {
    const before = this.trails.get(entity);
    if (on === (before !== undefined)) return;
    if (before) {
      this.stage.root.remove(before.object);
      before.dispose();
      this.trails.delete(entity);
    } else {
      const trail = new Trail(entity);
      this.trails.set(entity, trail);
      const position = this.stage.places.position(entity);
      if (position) trail.add(position);
      this.stage.root.add(trail.object);
    }
    this.invalidate();
  }

  /// Shows a line between two points, with its ends; null removes it.
  showMeasure(ends: [Pose['position'], Pose['position']] | null): void {
    this.measure.show(ends);
    this.invalidate();
  }

  /// Shows a model or light until the user chooses its pose, by a click or by keys; null ends it.
  showGhost(model: Message | null): void {
    this.placing.show(model);
  }

  /// Sets the centre of rotation to the point under the pointer; to the followed entity, if there is one.
  private turnAround(x: number, y: number): void {
    if (this.followed) return;
    const met = this.stage.batches.meet(this.orbitCamera.rayThrough(x, y))[0];
    if (met && met.hit.distance < 200) this.orbitCamera.turnAround(met.hit.distance);
  }

  private clicked(x: number, y: number): void {
    if (this.placing.isActive) {
      this.placing.click(x, y);
      return;
    }
    const met = this.stage.batches.meet(this.orbitCamera.rayThrough(x, y))[0];
    const place = met && this.stage.content.places.get(met.item.visual.place);
    this.options.onPick?.(place ? place.model : null);
  }

  private moveByKey(event: KeyboardEvent): void {
    const move = keyMove(event);
    if (move === null) return;
    event.preventDefault();
    event.stopPropagation();
    if ('turn' in move) this.orbitCamera.turn(...move.turn);
    else this.orbitCamera.zoom(move.zoom);
  }

  /// Frames so far, the last one's fraction of the full resolution, and its draw calls and triangles without those for shadows.
  get statistics(): { frames: number; scale: number; drawCalls: number; triangles: number } {
    return { frames: this.frames, scale: this.scale, ...this.lastRender };
  }

  /// The view as a PNG file.
  screenshot(): Promise<Blob> {
    this.drawWhole(this.fullScale);
    return pictureOf(this.canvas, this.fullScale);
  }

  /// @throws Error if this browser can't record video.
  startVideo(): void {
    this.recorder ??= new Recorder(this.canvas);
    this.invalidate();
  }

  /// Ends the recording, and returns it as a WebM file.
  async stopVideo(): Promise<Blob> {
    const { recorder } = this;
    if (recorder === null) throw new Error('no video is being recorded');
    this.recorder = null;
    return await recorder.stop();
  }

  dispose(): void {
    clearTimeout(this.rest);
    this.end.abort();
    this.sizes.disconnect();
    this.pointer.dispose();
    this.orbitCamera.controls.dispose();
    this.drag.dispose();
    this.handles.dispose();
    this.silhouette.dispose();
    this.measure.dispose();
    this.shadows.dispose();
    this.scans.clear();
    this.clouds.clear();
    this.contacts.clear();
    this.markers.dispose();
    this.stage.dispose();
    this.renderer.dispose();
    this.canvas.remove();
    if (this.nextFrame !== null) cancelAnimationFrame(this.nextFrame);
  }
}
