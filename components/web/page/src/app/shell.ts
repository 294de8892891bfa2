/// One world on the page: its context, panels and view. Created anew when another world is selected.
import type { Connection } from '../connection/connection.ts';
import { MarkerFeed } from '../connection/markers.ts';
import type { Sixfold } from '../connection/poses.ts';
import { quaternionOf, rollPitchYawOf } from '../connection/poses.ts';
import type { Message } from '../connection/types.ts';
import { World } from '../connection/world.ts';
import { StreamedView, View, type Pose } from '../view/index.ts';
import { AxisGizmo } from './axis_gizmo.ts';
import { Ends, Selection, settingsOf, type Context } from './context.ts';
import { h } from './dom.ts';
import { move } from './edits.ts';
import { guiSettingsOf, type GuiSettings } from './gui.ts';
import { History } from './history.ts';
import { Layout } from './layout.ts';
import type { MessageLog } from './message_log.ts';
import { readAddress, savedLayout, saveLayout, writeAddress, type LayoutState } from './page_state.ts';
import { panelFor } from './registry.ts';
import { currentTheme } from './theme.ts';
import { toolbar } from './toolbar.ts';

// after the last change [ms]
const kNoteMs = 400;

export class Shell {
  readonly context: Context;
  readonly layout = new Layout();
  readonly tools: HTMLElement;
  private readonly ends = new Ends();
  private readonly nothing = h('p', { class: 'nothing', role: 'status', hidden: true }, 'Nothing in this world has a <visual>, so there is nothing to see');
  private readonly gizmo = new AxisGizmo((from) => this.sight?.lookFrom(from));
  private gui: GuiSettings = { panels: [], camera: null };
  private isOpen = false;
  private isEnded = false;
  private noted: ReturnType<typeof setTimeout> | undefined;
  /// The layout of the world's `<gui>`, if it has been shown, and the one that was saved last.
  private usual: string | undefined;
  private saved = '';
  private placed: ((pose: Pose | null) => void) | null = null;

  constructor(connection: Connection, name: string, log: MessageLog) {
    const world = new World(connection, name);
    const selection = new Selection();
    this.context = {
      connection, world, selection, log,
      history: new History(),
      view: null,
      stream: null,
      attempt: async (what, work) => {
        try {
          await work;
          return true;
        } catch (fault) {
          log.add('error', `${what}: ${(fault as Error).message}`);
          return false;
        }
      },
      openPanel: (id, settings) => {
        const kind = panelFor(id);
        if (!kind) return;
        this.layout.add(kind, this.context, settingsOf(settings));
        this.layout.reveal(kind);
      },
      drawByServer: (isOn) => {
        clearTimeout(this.noted);
        this.writeState(isOn);
        window.location.reload();
      },
      choosePlace: (message, hint) => this.choosePlace(message, hint),
    };
    this.context.view = this.makeView();
    if (!this.context.view) this.context.stream = this.makeStream();
    this.ends.add(world.restarted.on(() => this.context.history.clear()));
    this.ends.add(connection.infoReceived.on(() => this.layout.setReadOnly(connection.isReadOnly)));
    this.layout.setReadOnly(connection.isReadOnly);
    this.tools = toolbar(this.context, this.layout, this.ends, { themed: () => this.showTheme(), resetLayout: () => this.resetLayout() });
    this.connectView();
    this.layout.stage.append(this.gizmo.element);
    this.showTheme();
    void this.openPanels();
  }

  end(): void {
    this.isEnded = true;
    this.ends.end();
    this.layout.closeAll();
    this.context.view?.dispose();
    this.context.stream?.dispose();
    this.context.world.end();
  }

  showTheme(): void {
    document.documentElement.dataset.theme = currentTheme();
    this.context.view?.setTheme(currentTheme());
  }

  private makeView(): View | null {
    const { stage } = this.layout;
    stage.append(this.nothing);
    const { connection, world, selection, log } = this.context;
    if (readAddress(location.hash).isDrawnByServer || !View.supported()) return null;
    return new View(stage, {
      asset: (address) => connection.asset(address),
      onPick: (entity) => selection.set(entity),
      onMove: (entity, pose, during) => {
        const moved = world.entities.get(entity);
        if (during || !moved) return undefined;
        const request = move(this.context, moved, () => poseFields(pose));
        void this.context.attempt('Move', request);
        return request;
      },
      onPlace: (pose) => {
        this.placed?.(pose);
        this.placed = null;
      },
      onCamera: () => this.cameraMoved(),
      onProblem: (text) => log.add('warning', text),
    });
  }

  /// Shows pictures that the server draws.
  private makeStream(): StreamedView {
    const { connection, world, log } = this.context;
    const topic = world.path('picture');
    const why = h('p', { class: 'no-view', role: 'status' }, View.supported() ? 'The server draws the world'
      : 'This browser has no WebGL 2 or it is switched off: the server draws the world');
    const stream = new StreamedView(this.layout.stage, {
      ask: (wish) => connection.ask(topic, { ...wish }),
      onCamera: () => this.cameraMoved(),
      onProblem: (text) => log.add('warning', `The server can't draw the world: ${text}`),
    });
    this.layout.stage.append(why);
    const receive = (picture: Uint8Array): void => void stream.receive(picture).catch((fault: Error) => log.add('error', fault.message));
    this.ends.add(connection.subscribeBytes(topic, receive), connection.channelsChanged.on(() => stream.again()));
    return stream;
  }

  private connectView(): void {
    const { connection, view, world, selection } = this.context;
    if (!view) return;
    const markers = new MarkerFeed(connection, world.name, (all) => view.setMarkers(all));
    this.ends.add(
      () => markers.end(),
      world.changed.on(() => {
        if (!world.scene) return;
        view.setScene(world.scene);
        this.nothing.hidden = view.hasVisuals;
        // frames contain only entities that move, so poses of the others have to be applied again
        view.applyFrame(world.allPoses());
      }),
      world.framed.on((frame) => view.applyFrame(frame)),
      selection.changed.on((id) => view.select(id)),
    );
  }

  /// Opens the panels of the address, else those that were open last, else those of the world's `<gui>`, and sets the
  /// initial viewpoint.
  private async openPanels(): Promise<void> {
    const { world } = this.context;
    const message = await world.ask('gui/info').catch(() => null);
    if (this.isEnded) return;
    this.gui = guiSettingsOf(message);
    const wanted = readAddress(location.hash);
    const isForThis = wanted.world === undefined || wanted.world === world.name;
    const layout = (isForThis ? wanted.layout : undefined) ?? savedLayout(world.name);
    this.showLayout(layout);
    const camera = (isForThis ? wanted.view : undefined) ?? this.gui.camera;
    if (camera) this.sight?.setCamera(poseOf(camera));
    this.cameraMoved();
    this.ends.add(this.layout.changed.on(() => this.noteState()), () => clearTimeout(this.noted));
    await this.noteOpened(layout === null);
    this.isOpen = true;
  }

  /// Shows a layout; null: that of the world's `<gui>`.
  private showLayout(state: LayoutState | null): void {
    this.layout.closeAll();
    this.layout.setSizes(state?.sizes ?? {});
    this.layout.setTabs({});
    if (!state) {
      for (const { kind, settings, title, place } of this.gui.panels) this.layout.add(kind, this.context, settings, title, place);
      return;
    }
    for (const { id, title, place, isFolded, settings } of state.panels) {
      const kind = panelFor(id);
      if (kind) this.layout.add(kind, this.context, settings ? settingsOf(settings) : null, title, place, isFolded);
    }
    this.layout.setTabs(state.tabs ?? {});
  }

  /// Forgets the saved layout.
  resetLayout(): void {
    this.showLayout(null);
    saveLayout(this.context.world.name, null);
    void this.noteOpened(true);
  }

  /// @param isUsual Whether the layout is that of the world's `<gui>`.
  private async noteOpened(isUsual: boolean): Promise<void> {
    // panels have their topics in the next microtask
    await Promise.resolve();
    this.saved = JSON.stringify(this.layout.state);
    if (isUsual) this.usual = this.saved;
  }

  private cameraMoved(): void {
    const camera = this.sight?.camera();
    if (camera) this.gizmo.show(camera.orientation);
    this.noteState();
  }

  /// What has a viewpoint.
  private get sight(): View | StreamedView | null {
    return this.context.view ?? this.context.stream;
  }

  /// Saves the layout and puts it and the viewpoint into the address, once nothing has changed for a while.
  private noteState(): void {
    if (!this.isOpen) return;
    clearTimeout(this.noted);
    this.noted = setTimeout(() => this.writeState(this.context.stream !== null && View.supported()), kNoteMs);
  }

  private writeState(isDrawnByServer: boolean): void {
    const { world } = this.context;
    const layout = this.layout.state;
    const text = JSON.stringify(layout);
    // only what the user has changed is saved, so that a world that asks for others gets them
    if (text !== this.saved) saveLayout(world.name, text === this.usual ? null : layout);
    this.saved = text;
    const camera = this.sight?.camera();
    const pose = camera && ([...camera.position, ...rollPitchYawOf(camera.orientation)] as Sixfold);
    window.history.replaceState(null, '', writeAddress({ world: world.name, ...(pose && { view: pose }), layout, isDrawnByServer }));
  }

  private choosePlace(message: Message, hint = 'Click in the view to place it, or move it by arrows and press Enter; Escape cancels'): Promise<Pose | null> {
    const { view, log } = this.context;
    if (!view) return Promise.resolve({ position: [0, 0, 0.5], orientation: [0, 0, 0, 1] });
    this.placed?.(null);
    log.add('info', hint);
    view.showGhost(message);
    return new Promise((resolve) => (this.placed = resolve));
  }
}

function poseOf([x, y, z, roll, pitch, yaw]: Sixfold): Pose {
  return { position: [x, y, z], orientation: quaternionOf(roll, pitch, yaw) };
}

function poseFields({ position: [x, y, z], orientation: [qx, qy, qz, qw] }: Pose): Message {
  return { position: { x, y, z }, orientation: { x: qx, y: qy, z: qz, w: qw } };
}
