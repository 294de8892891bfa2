/// The arrangement of panels around the view: docks at its sides and below, corners above it.
import type { Context, Panel, PanelKind, Dock, Settings } from './context.ts';
import { h, iconButton } from './dom.ts';

const kDocks: [Dock, string][] = [
  ['left', 'Panels on the left'], ['right', 'Panels on the right'], ['bottom', 'Panels below'],
  ['corner-left', 'Panels at the left of the view'], ['corner-right', 'Panels at the right of the view'],
];

interface OpenPanel {
  kind: PanelKind;
  frame: HTMLElement;
  panel: Panel;
}

export class Layout {
  readonly element: HTMLElement;
  /// The element of the view.
  readonly stage = h('div', { class: 'stage', id: 'view' });
  private readonly docks = new Map<Dock, HTMLElement>();
  private open: OpenPanel[] = [];
  private nextId = 1;
  private isReadOnly = false;
  private readonly controls = new Set<HTMLFieldSetElement>();

  constructor() {
    for (const [place, name] of kDocks) {
      this.docks.set(place, h('div', { class: `dock ${place}`, role: 'region', 'aria-label': name, hidden: true }));
    }
    const dock = (place: Dock): HTMLElement => this.docks.get(place)!;
    const corners = h('div', { class: 'corners' }, dock('corner-left'), dock('corner-right'));
    const middle = h('div', { class: 'middle' }, h('div', { class: 'around' }, this.stage, corners));
    this.element = h('div', { class: 'layout' }, dock('left'), middle, dock('right'), dock('bottom'));
  }

  /// @param title Heading, if not the panel's own.
  add(kind: PanelKind, context: Context, settings: Settings = null, title = kind.title, place = kind.place): void {
    const panel = kind.open(context, settings);
    const id = `panel-${this.nextId++}`;
    const body = h('div', { class: 'body', id: `${id}-body` });
    if (kind.isForWriting) {
      const controls = h('fieldset', { class: 'controls' }, panel.element);
      this.controls.add(controls);
      controls.disabled = this.isReadOnly;
      body.append(h('p', { class: 'hint read-only', hidden: !this.isReadOnly }, 'Read-only: this page can only look'), controls);
    } else {
      body.append(panel.element);
    }
    const fold = iconButton('▾', `Fold ${title}`, () => {
      body.hidden = !body.hidden;
      fold.textContent = body.hidden ? '▸' : '▾';
      fold.setAttribute('aria-expanded', String(!body.hidden));
    }, { 'aria-expanded': 'true', 'aria-controls': body.id });
    const heading = h('h2', { id }, title);
    const frame = h('section', { class: 'panel', 'aria-labelledby': id, 'data-panel': kind.id, tabindex: -1 },
      h('header', {}, fold, heading, iconButton('×', `Close ${title}`, () => this.close(frame))), body);
    this.docks.get(place)!.append(frame);
    this.open.push({ kind, frame, panel });
    this.showDocks();
  }

  /// Switches off the panels that change the world.
  setReadOnly(isReadOnly: boolean): void {
    this.isReadOnly = isReadOnly;
    for (const controls of this.controls) {
      controls.disabled = isReadOnly;
      (controls.previousElementSibling as HTMLElement).hidden = !isReadOnly;
    }
  }

  has(kind: PanelKind): boolean {
    return this.open.some((each) => each.kind === kind);
  }

  /// Brings an open panel into view. The focus is set to the panel itself, because its fields would take the arrow
  /// keys from who drives a robot by them.
  reveal(kind: PanelKind): void {
    const frame = this.open.findLast((each) => each.kind === kind)?.frame;
    frame?.scrollIntoView({ block: 'nearest' });
    frame?.focus({ preventScroll: true });
  }

  closeAll(): void {
    for (const { frame } of [...this.open]) this.close(frame);
  }

  private close(frame: HTMLElement): void {
    const closed = this.open.find((each) => each.frame === frame);
    if (!closed) return;
    closed.panel.close?.();
    for (const controls of frame.querySelectorAll('fieldset')) this.controls.delete(controls);
    frame.remove();
    this.open = this.open.filter((each) => each !== closed);
    this.showDocks();
  }

  private showDocks(): void {
    for (const dock of this.docks.values()) dock.hidden = dock.childElementCount === 0;
  }
}
