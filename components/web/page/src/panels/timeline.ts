/// Goes to any time of a recording, or back within the last minute of a running world.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, iconButton, labelled } from '../app/dom.ts';
import { icon } from '../app/icons.ts';
import { secondsOf, timeMessage } from '../connection/time.ts';
import { speedField } from './speed_field.ts';

/// Sends one request at a time; of those that are made meanwhile, the last one.
export class LatestOnly<T> {
  private waiting: T | null = null;
  private isBusy = false;

  constructor(private readonly send: (value: T) => Promise<unknown>) {}

  ask(value: T): void {
    this.waiting = value;
    if (!this.isBusy) void this.sendAll();
  }

  private async sendAll(): Promise<void> {
    this.isBusy = true;
    for (let value = this.waiting; value !== null; value = this.waiting) {
      this.waiting = null;
      await this.send(value);
    }
    this.isBusy = false;
  }
}

/// The state of the slider.
export interface Times {
  start: number;
  end: number;
  now: number;
}

/// @return Whether a run that plays in a loop begins again: it has come to the end, and stands there.
export function isAtEnd({ end, now }: Times, isPaused: boolean): boolean {
  return isPaused && end > 0 && now >= end - 1e-6;
}

export function openTimeline(context: Context, settings: Settings): Panel {
  const { world } = context;
  const ends = new Ends();
  const times: Times = { start: 0, end: 0, now: 0 };
  let isPaused = true;
  // what the user has let go on, so that a loop does not start what stands still
  let isPlaying = false;

  const seek = (time: number, pause: boolean): Promise<boolean> =>
    context.attempt('Go to a time', world.ask('playback/control', { pause, seek: timeMessage(time) }));
  const drags = new LatestOnly<number>((time) => seek(time, true));

  const slider = h('input', { type: 'range', min: 0, max: 0, step: 'any', value: 0, 'aria-label': 'Time', id: 'timeline' });
  slider.addEventListener('input', () => {
    isPlaying = false;
    times.now = slider.valueAsNumber;
    drags.ask(times.now);
    show();
  });
  const text = h('output', { id: 'timeline-times' }, '–');
  const play = iconButton(icon('play'), 'Play on', () => {
    isPlaying = isPaused;
    if (loop.checked && isAtEnd(times, isPaused)) void seek(times.start, false);
    else void context.attempt('Play', world.control({ pause: !isPaused }));
  });
  const back = iconButton(icon('reset'), 'To the beginning', () => void seek(times.start, true));
  const loop = h('input', { type: 'checkbox', checked: setting(settings, 'loop') === 'true' });
  const speed = speedField(context);

  const show = (): void => {
    slider.min = String(times.start);
    slider.max = String(times.end);
    if (document.activeElement !== slider || isPlaying) slider.value = String(times.now);
    slider.disabled = times.end <= times.start;
    text.textContent = `${times.now.toFixed(2)} s of ${times.start.toFixed(2)} to ${times.end.toFixed(2)} s`;
    slider.setAttribute('aria-valuetext', text.textContent);
  };
  ends.add(
    speed.end,
    world.connection.subscribe(world.path('playback/stats'), (range) => {
      times.start = secondsOf(range.startTime);
      times.end = secondsOf(range.endTime);
      show();
    }),
    world.connection.subscribe(world.path('stats'), (stats) => {
      times.now = secondsOf(stats.simTime);
      isPaused = Boolean(stats.paused);
      play.replaceChildren(icon(isPaused ? 'play' : 'pause'));
      play.title = isPaused ? 'Play on' : 'Hold';
      play.setAttribute('aria-label', play.title);
      if (isPlaying && loop.checked && isAtEnd(times, isPaused)) void seek(times.start, false);
      show();
    }),
  );

  const element = h('div', { class: 'timeline' },
    h('div', { class: 'row' }, play, back, slider), h('div', { class: 'row' }, text, labelled('Loop', loop), speed.element),
    h('p', { class: 'hint' }, 'A world that runs goes on from the time chosen. What is inserted or removed can not be gone back over.'));
  return { element, close: ends.end, settings: () => ({ loop: [String(loop.checked)] }) };
}
