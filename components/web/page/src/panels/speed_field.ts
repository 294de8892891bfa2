/// A field for the real-time factor that a world keeps.
import type { Context } from '../app/context.ts';
import { labelled, numberField } from '../app/dom.ts';
import { secondsOf } from '../connection/time.ts';

// Real-time factor for "as fast as possible": more than any world reaches.
const kAsFastAsPossible = 1e6;

/// @return The field with its label, and a function that ends its subscription.
export function speedField(context: Context): { element: HTMLElement; end: () => void } {
  const { world } = context;
  let stepSize = 0.001;
  const speed = numberField(1, { min: 0, step: 0.1, title: 'Real-time factor to keep; 0: as fast as possible', class: 'short' });
  speed.addEventListener('change', () => {
    if (!(speed.valueAsNumber >= 0)) return;
    // the service takes 0 as "unchanged"
    const factor = speed.valueAsNumber || kAsFastAsPossible;
    void context.attempt('Speed', world.ask('set_physics', { maxStepSize: stepSize, realTimeFactor: factor }));
  });
  const end = world.connection.subscribe(world.path('stats'), (stats) => {
    stepSize = secondsOf(stats.stepSize) || stepSize;
  });
  return { element: labelled('Speed', speed), end };
}
