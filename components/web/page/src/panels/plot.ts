/// Plots numbers of any topics over simulated time. Drag to zoom, double click to show all; with pause and CSV export.
import uPlot from 'uplot';
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { download, h, labelled, numberField, setChoices, shortNumber } from '../app/dom.ts';
import { numberReader, numbersIn } from '../connection/fields.ts';
import { secondsOf } from '../connection/time.ts';
import type { Message } from '../connection/types.ts';
import { tickTexts } from './plot_axis.ts';
import { columnsOf, csvOf, Curve } from './plot_data.ts';
import { topicChooser } from './topics.ts';

/// Colours that most people can distinguish, with enough contrast on a dark and on a light background.
const kColors = ['#2f8fd8', '#d9680a', '#1f9d6b', '#c2459c', '#8a7a00', '#7a63e0', '#d0392f', '#5f7380'];

/// The simulated time of a message [s]: the stamp in its header, else the time at which the server sent it.
export function timeOf(message: Message, sentNs: bigint): number {
  const stamp = (message.header?.stamp ?? message.simTime) as Message | undefined;
  return stamp ? secondsOf(stamp) : Number(sentNs) / 1e9;
}

/// A curve, and the end of its subscription.
class Plotted extends Curve {
  stop = (): void => {};
}

/// The topics and paths of the curves in settings: `<curve>/topic field.path</curve>`.
function curvesIn(settings: Settings): [topic: string, path: string][] {
  const names = [...(settings?.querySelectorAll('curve') ?? [])].map((curve) => curve.textContent ?? '');
  return names.map((name) => [name.slice(0, name.lastIndexOf(' ')), name.slice(name.lastIndexOf(' ') + 1)]);
}

export function openPlot(context: Context, settings: Settings): Panel {
  const { connection, log } = context;
  const ends = new Ends();
  const curves: Plotted[] = [];
  const chart = new Chart((values) => legend.querySelectorAll('output').forEach((output, i) => {
    const value = values[i];
    output.textContent = value === undefined || value === null ? '' : shortNumber(value);
  }));
  const span = numberField(Number(setting(settings, 'seconds')) || 30, { min: 1, class: 'short', title: 'Seconds shown' });
  const isPaused = h('input', { type: 'checkbox', id: 'plot-paused' });
  let isScheduled = false;
  const draw = (): void => {
    if (isScheduled || isPaused.checked) return;
    isScheduled = true;
    requestAnimationFrame(() => {
      isScheduled = false;
      if (isPaused.checked) return;
      const last = Math.max(0, ...curves.map((curve) => curve.last ?? 0));
      const first = Math.min(...curves.map((curve) => curve.times[0] ?? last));
      chart.show(curves, Math.max(first, last - (span.valueAsNumber || 30)), last);
      thinned.hidden = !curves.some(({ isThinned }) => isThinned);
    });
  };
  const legend = h('ul', { class: 'legend' });
  const thinned = h('p', { class: 'hint', hidden: true }, 'Of older values, those between the smallest and the largest of four are left out');
  const listCurves = (): void => {
    legend.replaceChildren(...curves.map((curve, i) => h('li', {},
      h('span', { class: 'dot', 'data-color': i % kColors.length }), curve.name, ' ', h('output', { 'aria-live': 'off' }), ' ',
      h('button', { type: 'button', class: 'link', 'aria-label': `Remove ${curve.name}`, onclick: () => remove(curve) }, '×'))));
    legend.querySelectorAll<HTMLElement>('.dot').forEach((dot, i) => (dot.style.background = kColors[i % kColors.length]!));
  };
  const remove = (curve: Plotted): void => {
    curve.stop();
    curves.splice(curves.indexOf(curve), 1);
    listCurves();
    chart.rebuild(curves);
    draw();
  };
  const plot = (topic: string, path: string): void => {
    if (!topic || !path || curves.some(({ name }) => name === `${topic} ${path}`)) return;
    const curve = new Plotted(`${topic} ${path}`);
    let read: ((message: Message) => number) | null = null;
    curve.stop = connection.subscribe(topic, (message, sentNs, type) => {
      try {
        read ??= numberReader(connection.types.get(type), path);
      } catch (fault) {
        log.add('error', `Plot: ${(fault as Error).message}`);
        curve.stop();
        return;
      }
      if (isPaused.checked) return;
      curve.add(timeOf(message, sentNs), read(message));
      draw();
    }, true);
    curves.push(curve);
    listCurves();
    chart.rebuild(curves);
  };
  isPaused.addEventListener('change', draw);
  const save = h('button', { type: 'button', onclick: () => download('plot.csv', new Blob([csvOf(curves)], { type: 'text/csv' })) }, 'CSV');
  const element = h('div', { class: 'plot' }, fieldChooser(context, settings, ends, plot), chart.element, legend, thinned,
    h('div', { class: 'row' }, isPaused, h('label', { for: 'plot-paused' }, 'Paused'), labelled('Seconds', span), save));
  ends.add(() => curves.forEach((curve) => curve.stop()), () => chart.end());
  for (const [topic, path] of curvesIn(settings)) plot(topic, path);
  return { element, close: ends.end, settings: () => ({ curve: curves.map(({ name }) => name), seconds: [span.value] }) };
}

/// Lists to choose a topic, and a number in its messages.
function fieldChooser(context: Context, settings: Settings, ends: Ends, plot: (topic: string, path: string) => void): HTMLElement {
  const { connection } = context;
  const path = h('select', { 'aria-label': 'Number', class: 'wide' });
  let stop = (): void => {};
  const chooser = topicChooser(context, [], setting(settings, 'topic'), ends, (topic) => {
    stop();
    setChoices(path, []);
    if (!topic) return;
    // the list has the numeric fields of the topic's first message
    stop = connection.subscribe(topic, (message, _time, type) => {
      setChoices(path, numbersIn(connection.types.get(type), message).map((each) => each.path));
      stop();
    });
  });
  ends.add(() => stop());
  const add = h('button', { type: 'button', onclick: () => plot(chooser.value, path.value) }, 'Plot');
  return h('div', { class: 'row wrap' }, chooser, path, add);
}

/// The width that the labels of an axis need.
function labelWidth(plot: uPlot, texts: readonly string[] | null, index: number, cycle: number): number {
  const axis = plot.axes[index] as uPlot.Axis & { _size: number; font: [string] };
  // uPlot asks again after it has set the size
  if (cycle > 1) return axis._size;
  plot.ctx.font = axis.font[0];
  const widths = (texts ?? []).map((text) => plot.ctx.measureText(text).width / devicePixelRatio);
  return Math.ceil(Math.max(20, ...widths) + (axis.ticks?.size ?? 0) + (axis.gap ?? 0));
}

/// Makes canvases that are drawn by the processor. Where graphics are emulated in software, long jagged lines take a
/// tenth of the time that they take there; everywhere else they are fast enough.
function drawnByProcessor<T>(make: () => T): T {
  const { prototype } = HTMLCanvasElement;
  const { getContext } = prototype;
  prototype.getContext = function (this: HTMLCanvasElement, kind: string) {
    return getContext.call(this, kind, { willReadFrequently: true });
  } as typeof getContext;
  try {
    return make();
  } finally {
    prototype.getContext = getContext;
  }
}

/// The chart (uPlot), with all curves.
class Chart {
  readonly element = h('div', { class: 'chart', role: 'img', 'aria-label': 'Values over time' });
  private plot: uPlot | null = null;
  private isZoomed = false;
  private curves: readonly Curve[] = [];
  private readonly observer = new ResizeObserver(() => this.plot?.setSize(this.size()));

  /// @param pointed Called with the values at the pointer; without it, the last ones.
  constructor(private readonly pointed: (values: (number | null | undefined)[]) => void) {
    this.observer.observe(this.element);
  }

  rebuild(curves: readonly Curve[]): void {
    this.plot?.destroy();
    this.plot = null;
    this.isZoomed = false;
    this.curves = curves;
    if (curves.length === 0) return;
    const ink = getComputedStyle(this.element).getPropertyValue('--text');
    const grid = { stroke: getComputedStyle(this.element).getPropertyValue('--grid'), width: 1 };
    const axis: uPlot.Axis = { stroke: ink, grid, ticks: grid, values: (_plot, labels) => tickTexts(labels) };
    const series = curves.map(({ name }, i) => ({ label: name, stroke: kColors[i % kColors.length]!, width: 1.5, spanGaps: true }));
    this.plot = drawnByProcessor(() => new uPlot({
      ...this.size(),
      legend: { show: false },
      scales: { x: { time: false } },
      axes: [{ ...axis, label: 'time [s]' }, { ...axis, size: labelWidth }],
      series: [{}, ...series],
      hooks: {
        setSelect: [({ select }) => { if (select.width > 0) this.zoomed(); }],
        setCursor: [() => this.tellValues()],
      },
    }, [[], ...curves.map(() => [])] as unknown as uPlot.AlignedData, this.element));
    this.plot.over.addEventListener('dblclick', () => (this.isZoomed = false));
  }

  /// Shows the curves between two times; the visible range stays while the user has zoomed in.
  show(curves: readonly Curve[], since: number, until: number): void {
    const { plot } = this;
    if (!plot) return;
    this.curves = curves;
    const { min, max } = plot.scales.x ?? {};
    const [from, to] = this.isZoomed ? [min ?? since, max ?? until] : [since, until];
    plot.batch(() => {
      plot.setData(columnsOf(curves, from, to, Math.max(100, this.element.clientWidth)) as uPlot.AlignedData, !this.isZoomed);
      if (to > from) plot.setScale('x', { min: from, max: to });
    });
    this.tellValues();
  }

  end(): void {
    this.observer.disconnect();
    this.plot?.destroy();
  }

  /// Shows what is between the times that the user has selected with all its values.
  private zoomed(): void {
    this.isZoomed = true;
    // after uPlot has set the range
    queueMicrotask(() => this.show(this.curves, 0, 0));
  }

  private tellValues(): void {
    const data = this.plot?.data;
    if (!this.plot || !data) return;
    const at = this.plot.cursor.idx ?? data[0].length - 1;
    this.pointed(data.slice(1).map((column) => {
      let i = at;
      while (i > 0 && (column[i] === null || column[i] === undefined)) --i;
      return column[i];
    }));
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(160, this.element.clientWidth), height: 200 };
  }
}
