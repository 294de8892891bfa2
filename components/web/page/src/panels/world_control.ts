/// Runs, pauses, steps and resets the world; sets its seed and speed.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, iconButton, labelled, numberField } from '../app/dom.ts';
import { icon } from '../app/icons.ts';
import { speedField } from './speed_field.ts';

export function openWorldControl(context: Context): Panel {
  const { world } = context;
  const ends = new Ends();
  let isPaused = true;

  const play = iconButton(icon('play'), 'Play', () => void context.attempt('Play', world.control({ pause: !isPaused })), { id: 'play' });
  const steps = numberField(1, { min: 1, max: 1_000_000, step: 1, 'aria-label': 'Steps', class: 'short' });
  const step = iconButton(icon('step'), 'Step', () => {
    const count = Math.max(1, Math.trunc(steps.valueAsNumber) || 1);
    void context.attempt('Step', world.control({ pause: true, multiStep: count }));
  }, { id: 'step' });
  const seed = numberField(0, { min: 0, step: 1, title: 'Seed of the next run; 0: the same again', class: 'short' });
  const reset = iconButton(icon('reset'), 'Reset', () => {
    const fields = { reset: { all: true }, seed: Math.max(0, Math.trunc(seed.valueAsNumber) || 0), pause: isPaused };
    void context.attempt('Reset', world.control(fields));
  }, { id: 'reset' });
  const speed = speedField(context);
  ends.add(speed.end);

  const element = h('div', { class: 'world-control' },
    h('div', { class: 'row' }, play, step, steps, reset),
    h('div', { class: 'row' }, labelled('Seed', seed), speed.element));
  ends.add(world.connection.subscribe(world.path('stats'), (stats) => {
    if (stats.paused === isPaused && play.dataset.known) return;
    isPaused = stats.paused as boolean;
    play.dataset.known = 'yes';
    play.replaceChildren(icon(isPaused ? 'play' : 'pause'));
    play.title = isPaused ? 'Play' : 'Pause';
    play.setAttribute('aria-label', play.title);
  }));
  return { element, close: ends.end };
}
