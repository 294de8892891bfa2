/// Plots the ranges of a lidar in polar coordinates, forward up, and shows them in the 3D view.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, shortNumber } from '../app/dom.ts';
import type { Message } from '../connection/types.ts';
import { topicChooser, topicSetting } from './topics.ts';

/// Positions of the hits of one ring, x forward and y left [m]; beams without a hit are omitted.
export function hitsOf(scan: Message, ring: number): [number, number][] {
  const hits: [number, number][] = [];
  const ranges = scan.ranges as number[];
  const count = scan.count as number;
  const step = (scan.angleStep as number) || (count > 1 ? ((scan.angleMax as number) - (scan.angleMin as number)) / (count - 1) : 0);
  for (let i = 0; i < count; i++) {
    const range = ranges[ring * count + i];
    if (range === undefined || !Number.isFinite(range)) continue;
    const angle = (scan.angleMin as number) + i * step;
    hits.push([range * Math.cos(angle), range * Math.sin(angle)]);
  }
  return hits;
}

function draw(canvas: HTMLCanvasElement, scan: Message, reach: number): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const { width } = canvas;
  const centre = width / 2;
  const scale = (centre - 4) / reach;
  const style = getComputedStyle(canvas);
  context.clearRect(0, 0, width, width);
  context.strokeStyle = style.getPropertyValue('--line');
  for (const part of [0.25, 0.5, 0.75, 1]) {
    context.beginPath();
    context.arc(centre, centre, part * (centre - 4), 0, 2 * Math.PI);
    context.stroke();
  }
  context.fillStyle = style.getPropertyValue('--accent');
  // the middle one of several rings
  const ring = Math.floor(((scan.verticalCount as number) || 1) / 2);
  for (const [x, y] of hitsOf(scan, ring)) context.fillRect(centre - y * scale - 1.5, centre - x * scale - 1.5, 3, 3);
  context.fillStyle = style.getPropertyValue('--text');
  context.beginPath();
  context.moveTo(centre, centre - 7);
  context.lineTo(centre + 4, centre + 4);
  context.lineTo(centre - 4, centre + 4);
  context.fill();
}

export function openLidarPlot(context: Context, settings: Settings): Panel {
  const { connection, view } = context;
  const ends = new Ends();
  let stop = (): void => {};
  const canvas = h('canvas', { width: 320, height: 320, class: 'polar', role: 'img', 'aria-label': 'Lidar ranges' });
  const note = h('p', { class: 'hint' }, 'No lidar publishes scans');
  const inView = h('input', { type: 'checkbox', id: 'lidar-in-view', checked: true, disabled: !view });
  let shown = '';
  const listen = (topic: string): void => {
    stop();
    stop = (): void => {};
    if (shown) view?.setLidar(shown, null);
    shown = topic;
    if (!topic) return;
    note.textContent = 'Waiting for a scan';
    stop = connection.subscribe(topic, (scan) => {
      const reach = Number.isFinite(scan.rangeMax) && scan.rangeMax > 0 ? (scan.rangeMax as number) : 10;
      draw(canvas, scan, reach);
      const hits = (scan.ranges as number[]).filter(Number.isFinite);
      const nearest = hits.length > 0 ? `${shortNumber(hits.reduce((least, range) => Math.min(least, range)))} m` : 'no hits';
      note.textContent = `${scan.ranges.length} rays, to ${shortNumber(reach)} m, nearest ${nearest}`;
      if (inView.checked) view?.setLidar(topic, scan);
    });
  };
  inView.addEventListener('change', () => {
    if (!inView.checked && shown) view?.setLidar(shown, null);
  });
  const select = topicChooser(context, ['ignition.msgs.LaserScan'], setting(settings, 'topic'), ends, listen);
  ends.add(() => {
    stop();
    if (shown) view?.setLidar(shown, null);
  });
  const element = h('div', { class: 'lidar-plot' }, select, canvas, note,
    h('div', { class: 'row' }, inView, h('label', { for: 'lidar-in-view' }, 'Rays in the 3D view')));
  return { element, close: ends.end, settings: () => topicSetting(select) };
}
