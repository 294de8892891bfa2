/// Plots numbers of any topics over simulated time. Drag to zoom, double click to show all; with pause and CSV export.
import uPlot from 'uplot';
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { download, h, labelled, numberField, setChoices } from '../app/dom.ts';
import { numberReader, numbersIn } from '../connection/fields.ts';
import type { Message } from '../connection/types.ts';
import { addValue, csvOf, joined, type Curve } from './plot_data.ts';
import { topicChooser } from './topics.ts';

/// Colours that most people can distinguish, with enough contrast on a dark and on a light background.
const kColors = ['#2f8fd8', '#d9680a', '#1f9d6b', '#c2459c', '#8a7a00', '#7a63e0', '#d0392f', '#5f7380'];

/// The simulated time of a message [s]: the stamp in its header, else the time at which the server sent it.
export function timeOf(message: Message, sentNs: bigint): number {
  const stamp = (message.header?.stamp ?? message.simTime) as Message | undefined;
  if (stamp) return Number(stamp.sec) + Number(stamp.nsec) / 1e9;
  return Number(sentNs) / 1e9;
}

interface Plotted extends Curve {
  end(): void;
}

export function openPlot(context: Context, settings: Settings): Panel {
  const { connection, log } = context;
  const ends = new Ends();
  const curves: Plotted[] = [];
  const chart = new Chart();
  const span = numberField(30, { min: 1, class: 'short', title: 'Seconds shown' });
  const isPaused = h('input', { type: 'checkbox', id: 'plot-paused' });
  let isScheduled = false;
  const draw = (): void => {
    if (isScheduled || isPaused.checked) return;
    isScheduled = true;
    requestAnimationFrame(() => {
      isScheduled = false;
      if (isPaused.checked) return;
      const last = Math.max(...curves.map(({ times }) => times.at(-1) ?? 0));
      chart.show(curves, last - (span.valueAsNumber || 30));
    });
  };
  const legend = h('ul', { class: 'legend' });
  const listCurves = (): void => {
    legend.replaceChildren(...curves.map((curve, i) => h('li', {},
      h('span', { class: 'dot', 'data-color': i % kColors.length }), curve.name, ' ',
      h('button', { type: 'button', class: 'link', 'aria-label': `Remove ${curve.name}`, onclick: () => remove(curve) }, '×'))));
    legend.querySelectorAll<HTMLElement>('.dot').forEach((dot, i) => (dot.style.background = kColors[i % kColors.length]!));
  };
  const remove = (curve: Plotted): void => {
    curve.end();
    curves.splice(curves.indexOf(curve), 1);
    listCurves();
    chart.rebuild(curves);
    draw();
  };
  const plot = (topic: string, path: string): void => {
    if (!topic || !path || curves.some(({ name }) => name === `${topic} ${path}`)) return;
    const curve: Plotted = { name: `${topic} ${path}`, times: [], values: [], end: () => {} };
    let read: ((message: Message) => number) | null = null;
    curve.end = connection.subscribe(topic, (message, sentNs, type) => {
      try {
        read ??= numberReader(connection.types.get(type), path);
      } catch (fault) {
        log.add('error', `Plot: ${(fault as Error).message}`);
        curve.end();
        return;
      }
      if (isPaused.checked) return;
      addValue(curve, timeOf(message, sentNs), read(message));
      draw();
    }, true);
    curves.push(curve);
    listCurves();
    chart.rebuild(curves);
  };
  isPaused.addEventListener('change', draw);
  const save = h('button', { type: 'button', onclick: () => download('plot.csv', new Blob([csvOf(curves)], { type: 'text/csv' })) }, 'CSV');
  const element = h('div', { class: 'plot' }, fieldChooser(context, settings, ends, plot), chart.element, legend,
    h('div', { class: 'row' }, isPaused, h('label', { for: 'plot-paused' }, 'Paused'), labelled('Seconds', span), save));
  ends.add(() => curves.forEach((curve) => curve.end()), () => chart.end());
  return { element, close: ends.end };
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

/// The chart (uPlot), with all curves.
class Chart {
  readonly element = h('div', { class: 'chart', role: 'img', 'aria-label': 'Values over time' });
  private plot: uPlot | null = null;
  private isZoomed = false;
  private readonly observer = new ResizeObserver(() => this.plot?.setSize(this.size()));

  constructor() {
    this.observer.observe(this.element);
  }

  rebuild(curves: readonly Curve[]): void {
    this.plot?.destroy();
    this.plot = null;
    this.isZoomed = false;
    if (curves.length === 0) return;
    const ink = getComputedStyle(this.element).getPropertyValue('--text');
    const grid = { stroke: getComputedStyle(this.element).getPropertyValue('--line') };
    const series = curves.map(({ name }, i) => ({ label: name, stroke: kColors[i % kColors.length]!, width: 1.5, spanGaps: true }));
    this.plot = new uPlot({
      ...this.size(),
      legend: { show: false },
      scales: { x: { time: false } },
      axes: [{ stroke: ink, grid, label: 'time [s]' }, { stroke: ink, grid }],
      series: [{}, ...series],
      hooks: { setSelect: [({ select }) => { if (select.width > 0) this.isZoomed = true; }] },
    }, [[], ...curves.map(() => [])] as unknown as uPlot.AlignedData, this.element);
    this.plot.over.addEventListener('dblclick', () => (this.isZoomed = false));
  }

  /// Shows the curves from time `since` on; the visible range stays while the user has zoomed in.
  show(curves: readonly Curve[], since: number): void {
    this.plot?.setData(joined(curves, this.isZoomed ? -Infinity : since) as uPlot.AlignedData, !this.isZoomed);
    if (this.isZoomed) this.plot?.redraw();
  }

  end(): void {
    this.observer.disconnect();
    this.plot?.destroy();
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(160, this.element.clientWidth), height: 200 };
  }
}
