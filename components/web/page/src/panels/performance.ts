/// Shows how the page keeps up: frames of the view, the time that a request takes, and what arrives by topic.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';

const kEveryMs = 1000;
const kMostRows = 12;

/// "12.3 kB", in powers of 1000.
export function sizeText(bytes: number): string {
  const units = ['B', 'kB', 'MB', 'GB'];
  const unit = Math.min(Math.max(Math.floor(Math.log10(Math.max(bytes, 1)) / 3), 0), units.length - 1);
  return `${(bytes / 1000 ** unit).toFixed(unit === 0 ? 0 : 1)} ${units[unit]}`;
}

export function openPerformance(context: Context): Panel {
  const { connection, world, view } = context;
  const ends = new Ends();
  const cell = (id: string): HTMLElement => h('dd', { id: `performance-${id}` }, '–');
  const [frames, resolution, work, trip, total] = [cell('frames'), cell('resolution'), cell('work'), cell('trip'), cell('total')];
  const rows = h('tbody', {});
  let drawn = view?.statistics.frames ?? 0;
  let at = performance.now();
  let isAsking = false;
  // a request that changes nothing: to the world's thread and back, between two steps
  const ask = async (): Promise<void> => {
    if (isAsking) return;
    isAsking = true;
    const begin = performance.now();
    const isAnswered = await world.ask('gui/info').then(() => true, () => false);
    trip.textContent = isAnswered ? `${(performance.now() - begin).toFixed(0)} ms` : 'no answer';
    isAsking = false;
  };
  const show = (): void => {
    const now = performance.now();
    if (view) {
      const { frames: count, scale, drawCalls, triangles } = view.statistics;
      frames.textContent = `${((1000 * (count - drawn)) / (now - at)).toFixed(1)} per second`;
      resolution.textContent = `${Math.round(100 * scale)} %`;
      work.textContent = `${drawCalls} draw calls, ${triangles} triangles`;
      drawn = count;
    }
    at = now;
    const rates = connection.traffic.take(now);
    total.textContent = `${sizeText(rates.reduce((sum, { bytes }) => sum + bytes, 0))} per second`;
    rows.replaceChildren(...rates.slice(0, kMostRows).map(({ topic, messages, bytes }) => h('tr', {},
      h('td', {}, topic), h('td', {}, messages.toFixed(messages < 10 ? 1 : 0)), h('td', {}, sizeText(bytes)))));
    void ask();
  };
  const timer = setInterval(show, kEveryMs);
  ends.add(() => clearInterval(timer));
  // what came before does not count
  connection.traffic.take(at);
  const element = h('div', { class: 'performance' },
    h('dl', {}, h('dt', {}, 'Frames drawn'), frames, h('dt', {}, 'Resolution'), resolution, h('dt', {}, 'Last frame'), work,
      h('dt', {}, 'Request and answer'), trip, h('dt', {}, 'Received'), total),
    h('table', {}, h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Topic'), h('th', { scope: 'col' }, 'per s'), h('th', { scope: 'col' }, 'bytes/s'))), rows),
    h('p', { class: 'hint' }, 'The view draws only when something changes.'));
  return { element, close: ends.end };
}
