/// Runs, pauses, steps and resets the world; sets its seed and speed.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, iconButton, labelled, numberField } from '../app/dom.ts';
import { icon } from '../app/icons.ts';

// Real-time factor for "as fast as possible": more than any world reaches.
const kAsFastAsPossible = 1e6;

export function openWorldControl(context: Context): Panel {
  const { world } = context;
  const ends = new Ends();
  let isPaused = true;
  let stepSize = 0.001;

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
  const speed = numberField(1, { min: 0, step: 0.1, title: 'Real-time factor to keep; 0: as fast as possible', class: 'short' });
  speed.addEventListener('change', () => {
    if (!(speed.valueAsNumber >= 0)) return;
    // the service takes 0 as "unchanged"
    const factor = speed.valueAsNumber || kAsFastAsPossible;
    void context.attempt('Speed', world.ask('set_physics', { maxStepSize: stepSize, realTimeFactor: factor }));
  });

  const element = h('div', { class: 'world-control' },
    h('div', { class: 'row' }, play, step, steps, reset),
    h('div', { class: 'row' }, labelled('Seed', seed), labelled('Speed', speed)));
  ends.add(world.connection.subscribe(world.path('stats'), (stats) => {
    stepSize = Number(stats.stepSize?.sec ?? 0) + Number(stats.stepSize?.nsec ?? 0) / 1e9 || stepSize;
    if (stats.paused === isPaused && play.dataset.known) return;
    isPaused = stats.paused as boolean;
    play.dataset.known = 'yes';
    play.replaceChildren(icon(isPaused ? 'play' : 'pause'));
    play.title = isPaused ? 'Play' : 'Pause';
    play.setAttribute('aria-label', play.title);
  }));
  return { element, close: ends.end };
}
