/// Settings of the 3D view: viewpoint, overlays, the entity to follow.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h, iconButton } from '../app/dom.ts';
import { readContacts } from '../connection/contacts.ts';
import { quaternionOf, rollPitchYawOf } from '../connection/poses.ts';
import { saveViews, savedViews, withView, type SavedView } from '../app/saved_views.ts';
import { View, type Direction, type StreamedView, type Overlay } from '../view/index.ts';

const kOverlays: [Overlay, string][] = [
  ['frames', 'Frames'], ['joints', 'Joints'], ['centres', 'Centres of mass'], ['inertia', 'Inertia'],
  ['collisions', 'Collisions'], ['contacts', 'Contacts'], ['wireframe', 'Wireframe'], ['transparent', 'Transparent'],
];
const kDirections: Direction[] = ['home', 'front', 'back', 'left', 'right', 'top', 'bottom'];

function box(id: string, name: string, isOn: boolean, set: (on: boolean) => void): HTMLElement {
  const input = h('input', { type: 'checkbox', id: `show-${id}`, checked: isOn });
  input.addEventListener('change', () => set(input.checked));
  return h('div', { class: 'row' }, input, h('label', { for: input.id }, name));
}

/// Lists the saved viewpoints, with a field that saves the present one.
function showViews(element: HTMLElement, world: string, sight: View | StreamedView): void {
  const name = h('input', { type: 'text', placeholder: 'Name', 'aria-label': 'Name of the view', class: 'short' });
  const change = (views: SavedView[]): void => {
    saveViews(world, views);
    showViews(element, world, sight);
  };
  const all = savedViews(world);
  const save = (event: Event): void => {
    event.preventDefault();
    const { position, orientation } = sight.camera();
    if (name.value.trim()) change(withView(all, { name: name.value.trim(), pose: [...position, ...rollPitchYawOf(orientation)] }));
  };
  element.replaceChildren(
    h('form', { class: 'row', onsubmit: save }, name, h('button', { type: 'submit' }, 'Save view')),
    ...all.map((view) => h('div', { class: 'row' },
      h('button', { type: 'button', class: 'link', onclick: () => {
        const [x, y, z, roll, pitch, yaw] = view.pose;
        sight.setCamera({ position: [x, y, z], orientation: quaternionOf(roll, pitch, yaw) });
      } }, view.name),
      iconButton('×', `Forget ${view.name}`, () => change(all.filter(({ name: other }) => other !== view.name))))));
}

export function openViewSettings(context: Context): Panel {
  const { view, stream, world, selection, connection } = context;
  const ends = new Ends();
  const sight = view ?? stream;
  const from = h('div', { class: 'row wrap', role: 'group', 'aria-label': 'Look from' },
    ...kDirections.map((direction) => h('button', { type: 'button', onclick: () => sight?.lookFrom(direction) }, direction)));
  const views = h('div', {});
  if (sight) showViews(views, world.name, sight);
  const drawn = box('by-server', 'The server draws the picture, for slow links', !view, (on) => context.drawByServer(on));
  const grid = box('grid', 'Grid', true, (on) => sight?.setGrid(on));
  if (!view) {
    if (!View.supported()) drawn.querySelector('input')!.disabled = true;
    return { element: h('div', { class: 'view-settings' }, from, views, grid, drawn, h('p', { class: 'hint' }, 'All else needs the 3D view of the browser')) };
  }
  const orthographic = box('orthographic', 'Orthographic', false, (on) => view.setOrthographic(on));
  const isOnlyChosen = h('input', { type: 'checkbox', id: 'overlay-chosen' });
  let endContacts = (): void => {};
  const showContacts = (on: boolean): void => {
    endContacts();
    endContacts = (): void => {};
    const own = world.path('contacts');
    if (connection.channels.has(own)) {
      if (!on) return view.setContacts(own, null);
      endContacts = connection.subscribeBytes(own, (bytes) => view.setContacts(own, readContacts(bytes)));
      return;
    }
    // a server of another version
    const topics = [...connection.channels.values()].filter(({ schemaName }) => schemaName === 'ignition.msgs.Contacts');
    if (!on) {
      for (const { topic } of topics) view.setContacts(topic, null);
      return;
    }
    const all = topics.map(({ topic }) => connection.subscribe(topic, (contacts) => view.setContacts(topic, contacts)));
    endContacts = (): void => all.forEach((end) => end());
    if (all.length === 0) context.log.add('info', 'No sensor of the world publishes contacts');
  };
  const overlays = kOverlays.map(([overlay, name]) => box(overlay, name, false, (on) => {
    const chosen = isOnlyChosen.checked ? (selection.id ?? undefined) : undefined;
    view.setOverlay(overlay, on, chosen);
    if (overlay === 'contacts') showContacts(on);
  }));
  const top = (): number | null => {
    const entity = world.entities.get(selection.id);
    return entity ? world.entities.topOf(entity).id : null;
  };
  const follow = box('follow', 'Follow the selected model', false, (on) => view.follow(on ? top() : null));
  const trail = box('trail', 'Trail of the selected model', false, (on) => {
    const id = top();
    if (id !== null) view.setTrail(id, on);
  });
  ends.add(() => endContacts());
  const element = h('div', { class: 'view-settings' },
    from, views, orthographic, follow, trail, grid, box('shadows', 'Shadows', true, (on) => view.setShadows(on)),
    box('as-cameras', 'Light and background as cameras see them', false, (on) => view.setAsCameras(on)),
    drawn,
    h('div', { class: 'row' }, isOnlyChosen, h('label', { for: isOnlyChosen.id }, 'Show those below only for the selection')),
    ...overlays);
  return { element, close: ends.end };
}
