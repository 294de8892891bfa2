/// Inserts models: shapes, files, and models by name or address.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';
import { fromText, insert } from '../app/edits.ts';
import { kShapeNames, shapeMessage, shapeSdf, type Shape } from './shapes.ts';

/// The name of the first model, light or robot in an SDF or URDF file; null for other files.
export function sdfName(text: string): string | null {
  const found = /<(?:model|light|robot)\b[^>]*?\bname\s*=\s*["']([^"']+)["']/.exec(text);
  return found?.[1] ?? null;
}

/// Inserts models from files, such as those dropped on the page.
export async function spawnFiles(context: Context, files: Iterable<File>): Promise<void> {
  // a copy, because the browser empties the list when the event handler has returned
  for (const file of [...files]) {
    const text = await file.text();
    if (/<world\b/.test(text)) {
      context.log.add('error', `Spawn: ${file.name} is a world, not a model`);
      continue;
    }
    const name = sdfName(text);
    if (name === null) {
      context.log.add('error', `Spawn: ${file.name} has no model, light or robot`);
      continue;
    }
    // null: at the pose in the file
    if (await context.attempt(`Spawn ${name}`, insert(context, `Spawn ${name}`, fromText(text, null), name))) context.log.add('info', `Added ${name} from ${file.name}`);
  }
}

export async function spawnShape(context: Context, shape: Shape): Promise<void> {
  const place = await context.choosePlace(shapeMessage(shape));
  if (!place) return;
  const factory = fromText(shapeSdf(shape), [...place.position, 0, 0, 0], shape);
  await context.attempt(`Spawn ${shape}`, insert(context, `Spawn ${shape}`, factory, shape));
}

export function openSpawn(context: Context): Panel {
  const ends = new Ends();
  const shapes = kShapeNames.map((shape) => h('button', { type: 'button', onclick: () => void spawnShape(context, shape) }, shape));
  const choose = h('input', { type: 'file', accept: '.sdf,.urdf,.xml', multiple: true, 'aria-label': 'SDF or URDF files' });
  choose.addEventListener('change', () => {
    void spawnFiles(context, choose.files ?? []);
    choose.value = '';
  });
  const address = h('input', { class: 'wide', placeholder: 'model://NAME, a file of the simulator, or a Fuel address', 'aria-label': 'Address of a model' });
  const form = h('form', { class: 'row', onsubmit: (event: Event) => {
    event.preventDefault();
    const factory = { from: { case: 'sdfFilename', value: address.value } };
    // its name is in the file
    void context.attempt('Spawn', insert(context, `Spawn ${address.value}`, factory, ''));
  } }, address, h('button', { type: 'submit' }, 'Add'));
  const element = h('div', { class: 'spawn' }, h('p', { class: 'hint' }, 'Choose a shape, then click in the view to place it. Files can be dropped on the page.'),
    h('div', { class: 'row wrap' }, ...shapes), choose, form);
  return { element, close: ends.end };
}
