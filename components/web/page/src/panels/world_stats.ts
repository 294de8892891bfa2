/// Shows simulated time, real time, iterations, and a curve of the real-time factor.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';
import type { Message } from '../connection/types.ts';

const kKept = 300;

/// An ignition.msgs.Time as days, hours, minutes and seconds: "0 00:01:02.345".
export function timeText(time: Message | undefined): string {
  const total = Number(time?.sec ?? 0);
  const two = (value: number): string => String(Math.floor(value)).padStart(2, '0');
  const ms = String(Math.floor(Number(time?.nsec ?? 0) / 1e6)).padStart(3, '0');
  return `${Math.floor(total / 86400)} ${two((total / 3600) % 24)}:${two((total / 60) % 60)}:${two(total % 60)}.${ms}`;
}

/// Draws a curve of the latest values; the vertical range is 1.25 times the largest one.
function drawFactors(canvas: HTMLCanvasElement, factors: number[]): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const { width, height } = canvas;
  const most = 1.25 * Math.max(1, ...factors);
  const style = getComputedStyle(canvas);
  context.clearRect(0, 0, width, height);
  const lineAt = (factor: number): number => height - (factor / most) * height;
  context.strokeStyle = style.getPropertyValue('--line');
  context.beginPath();
  context.moveTo(0, lineAt(1));
  context.lineTo(width, lineAt(1));
  context.stroke();
  context.strokeStyle = style.getPropertyValue('--accent');
  context.lineWidth = 1.5;
  context.beginPath();
  factors.forEach((factor, i) => context.lineTo((i / (kKept - 1)) * width, lineAt(factor)));
  context.stroke();
}

export function openWorldStats(context: Context): Panel {
  const { world } = context;
  const ends = new Ends();
  const factors: number[] = [];
  const cell = (id: string): HTMLElement => h('dd', { id: `stats-${id}` }, '–');
  const [factor, simulated, real, iterations] = [cell('factor'), cell('sim'), cell('real'), cell('iterations')];
  const canvas = h('canvas', { width: kKept, height: 48, role: 'img', 'aria-label': 'Real-time factor over time' });
  const element = h('div', { class: 'world-stats' },
    h('dl', {}, h('dt', {}, 'Real-time factor'), factor, h('dt', {}, 'Sim time'), simulated,
      h('dt', {}, 'Real time'), real, h('dt', {}, 'Iterations'), iterations),
    canvas);
  ends.add(world.connection.subscribe(world.path('stats'), (stats) => {
    const value = stats.paused ? 0 : (stats.realTimeFactor as number);
    factors.push(value);
    if (factors.length > kKept) factors.shift();
    factor.textContent = `${(100 * value).toFixed(2)} %`;
    simulated.textContent = timeText(stats.simTime as Message);
    real.textContent = timeText(stats.realTime as Message);
    iterations.textContent = String(stats.iterations);
    drawFactors(canvas, factors);
  }));
  return { element, close: ends.end };
}
