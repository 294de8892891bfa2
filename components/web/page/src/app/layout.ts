/// The arrangement of panels around the view: docks at its sides and below, corners above it.
import { Emitter } from '../connection/emitter.ts';
import type { Context, Panel, PanelKind, Dock, Settings } from './context.ts';
import { h, iconButton } from './dom.ts';
import { icon } from './icons.ts';
import type { LayoutState } from './page_state.ts';
import { splitter } from './splitter.ts';

const kDocks: [Dock, string][] = [
  ['left', 'Panels on the left'], ['right', 'Panels on the right'], ['bottom', 'Panels below'],
  ['corner-left', 'Panels at the left of the view'], ['corner-right', 'Panels at the right of the view'],
];

interface OpenPanel {
  kind: PanelKind;
  title: string;
  place: Dock;
  frame: HTMLElement;
  body: HTMLElement;
  /// The button that shows the panels of its dock as tabs.
  stack: HTMLElement;
  panel: Panel;
}

// where the button of a panel moves it next
const kNext: Record<Dock, [Dock, string]> = {
  left: ['bottom', 'below the view'], bottom: ['right', 'to the right'], right: ['corner-right', 'over the view'],
  'corner-right': ['corner-left', 'to the left over the view'], 'corner-left': ['left', 'to the left'],
};

export class Layout {
  readonly element: HTMLElement;
  /// The element of the view.
  readonly stage = h('div', { class: 'stage', id: 'view' });
  private readonly docks = new Map<Dock, HTMLElement>();
  private open: OpenPanel[] = [];
  private nextId = 1;
  /// Called when panels or sizes may have changed.
  readonly changed = new Emitter<void>();
  private readonly sizes: LayoutState['sizes'] = {};
  private readonly lines = new Map<Dock, HTMLElement>();
  /// Docks that show their panels as tabs, and the panel that is shown.
  private readonly tabbed = new Map<Dock, OpenPanel | undefined>();
  /// Tabs of the docks that can have them.
  private readonly strips = new Map<Dock, HTMLElement>();
  private isReadOnly = false;
  private readonly controls = new Set<HTMLFieldSetElement>();

  constructor() {
    for (const [place, name] of kDocks) {
      this.docks.set(place, h('div', { class: `dock ${place}`, role: 'region', 'aria-label': name, hidden: true }));
    }
    const dock = (place: Dock): HTMLElement => this.docks.get(place)!;
    for (const place of ['left', 'right', 'bottom'] as const) {
      const strip = h('div', { class: 'tabs', role: 'tablist', 'aria-label': dock(place).getAttribute('aria-label')!, hidden: true });
      strip.addEventListener('keydown', (event) => this.moveInTabs(place, event));
      dock(place).append(strip);
      this.strips.set(place, strip);
    }
    const corners = h('div', { class: 'corners' }, dock('corner-left'), dock('corner-right'));
    const middle = h('div', { class: 'middle' }, h('div', { class: 'around' }, this.stage, corners));
    const lines = (['left', 'right', 'bottom'] as const).map((side) => {
      const line = splitter({
        side, name: `Size of the ${kDocks.find(([place]) => place === side)![1].toLowerCase()}`,
        size: () => this.sizes[side] ?? dock(side)[side === 'bottom' ? 'offsetHeight' : 'offsetWidth'],
        resize: (size) => this.resize(side, size),
      });
      this.lines.set(side, line);
      return line;
    });
    this.element = h('div', { class: 'layout' }, dock('left'), middle, dock('right'), dock('bottom'), ...lines);
    // panels change their settings by these events
    for (const event of ['change', 'click']) this.element.addEventListener(event, () => this.changed.emit());
  }

  /// What is open, and where.
  get state(): LayoutState {
    const panels = kDocks.flatMap(([dock]) => this.panelsIn(dock).map(({ kind, title, place, body, panel }) => {
      const settings = panel.settings?.();
      return { id: kind.id, title, place, ...(body.hidden && { isFolded: true }), ...(settings && { settings }) };
    }));
    const tabs: NonNullable<LayoutState['tabs']> = {};
    for (const [place, shown] of this.tabbed) tabs[place] = Math.max(this.panelsIn(place).findIndex((each) => each === shown), 0);
    return { panels, sizes: { ...this.sizes }, ...(this.tabbed.size > 0 && { tabs }) };
  }

  /// The panels of a dock in their order.
  private panelsIn(place: Dock): OpenPanel[] {
    return [...this.docks.get(place)!.children].flatMap((frame) => this.open.find((each) => each.frame === frame) ?? []);
  }

  /// Shows the panels of these docks as tabs, and those of the others below each other.
  setTabs(tabs: NonNullable<LayoutState['tabs']>): void {
    this.tabbed.clear();
    for (const place of this.strips.keys()) {
      const shown = tabs[place];
      if (shown !== undefined) this.tabbed.set(place, this.panelsIn(place)[shown]);
    }
    this.showDocks();
  }

  private showTab(panel: OpenPanel): void {
    if (!this.tabbed.has(panel.place)) return;
    this.tabbed.set(panel.place, panel);
    this.showTabs(panel.place);
    this.changed.emit();
  }

  private moveInTabs(place: Dock, event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const panels = this.panelsIn(place);
    const next = (panels.findIndex((each) => each === this.tabbed.get(place)) + step + panels.length) % panels.length;
    this.showTab(panels[next]!);
    this.strips.get(place)!.querySelector<HTMLElement>('[aria-selected="true"]')?.focus();
  }

  private showTabs(place: Dock): void {
    const strip = this.strips.get(place);
    const panels = this.panelsIn(place);
    const isTabbed = this.tabbed.has(place) && panels.length > 1;
    const shown = panels.find((each) => each === this.tabbed.get(place)) ?? panels[0];
    for (const each of panels) {
      each.stack.hidden = !strip || panels.length < 2;
      each.stack.setAttribute('aria-pressed', String(isTabbed));
      each.frame.hidden = isTabbed && each !== shown;
    }
    if (!strip) return;
    strip.hidden = !isTabbed;
    if (isTabbed) this.tabbed.set(place, shown);
    strip.replaceChildren(...(isTabbed ? panels : []).map((each) => h('button', {
      type: 'button', role: 'tab', 'aria-selected': String(each === shown), 'aria-controls': each.frame.id,
      tabindex: each === shown ? 0 : -1, onclick: () => this.showTab(each),
    }, each.title)));
  }

  private resize(place: Dock, size: number): void {
    this.sizes[place] = size;
    this.element.style.setProperty(`--${place}`, `${size}px`);
    this.changed.emit();
  }

  /// Sets the sizes of docks; those that are not given have their usual ones.
  setSizes(sizes: LayoutState['sizes']): void {
    for (const place of ['left', 'right', 'bottom'] as const) {
      delete this.sizes[place];
      this.element.style.removeProperty(`--${place}`);
      if (sizes[place]) this.resize(place, sizes[place]);
    }
  }

  /// @param title Heading, if not the panel's own.
  add(kind: PanelKind, context: Context, settings: Settings = null, title = kind.title, place = kind.place, isFolded = false): void {
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
    const foldTo = (isHidden: boolean): void => {
      body.hidden = isHidden;
      fold.textContent = body.hidden ? '▸' : '▾';
      fold.setAttribute('aria-expanded', String(!body.hidden));
    };
    const fold = iconButton('▾', `Fold ${title}`, () => foldTo(!body.hidden), { 'aria-expanded': 'true', 'aria-controls': body.id });
    const stack = iconButton(icon('tabs'), 'Show the panels of this side as tabs', () => {
      if (!this.tabbed.delete(opened.place)) this.tabbed.set(opened.place, opened);
      this.showDocks();
      this.changed.emit();
      stack.focus();
    });
    const move = iconButton(icon('move'), '', () => {
      opened.place = kNext[opened.place][0];
      this.docks.get(opened.place)!.append(frame);
      if (this.tabbed.has(opened.place)) this.tabbed.set(opened.place, opened);
      showMove();
      this.showDocks();
      move.focus();
      frame.scrollIntoView({ block: 'nearest' });
    });
    const showMove = (): void => {
      move.title = `Move ${title} ${kNext[opened.place][1]}`;
      move.setAttribute('aria-label', move.title);
    };
    const heading = h('h2', { id }, title);
    const frame = h('section', { class: 'panel', id: `${id}-frame`, 'aria-labelledby': id, 'data-panel': kind.id, tabindex: -1 },
      h('header', {}, fold, heading, stack, move, iconButton('×', `Close ${title}`, () => this.close(frame))), body);
    const opened: OpenPanel = { kind, title, place, frame, body, stack, panel };
    this.docks.get(place)!.append(frame);
    if (this.tabbed.has(place)) this.tabbed.set(place, opened);
    this.open.push(opened);
    showMove();
    foldTo(isFolded);
    this.showDocks();
    this.changed.emit();
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
    const opened = this.open.findLast((each) => each.kind === kind);
    if (opened) this.showTab(opened);
    const frame = opened?.frame;
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
    this.changed.emit();
  }

  private showDocks(): void {
    for (const [place, dock] of this.docks) {
      dock.hidden = this.panelsIn(place).length === 0;
      this.showTabs(place);
      const line = this.lines.get(place);
      if (line) line.hidden = dock.hidden;
    }
  }
}
