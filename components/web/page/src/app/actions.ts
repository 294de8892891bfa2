/// Actions on the selected entity.
import { poseMessage, rollPitchYawOf } from '../connection/poses.ts';
import { modelSdf } from '../connection/sdf_writer.ts';
import type { Message } from '../connection/types.ts';
import type { Entity } from '../connection/entities.ts';
import type { Context } from './context.ts';
import { download } from './dom.ts';
import { insert, remove } from './edits.ts';

/// The top-level model or light that contains the selected entity, or is it.
export function chosenTop(context: Context): Entity | null {
  const { world, selection } = context;
  const entity = world.entities.get(selection.id);
  if (!entity || entity.kind === 'world') return null;
  const top = world.entities.topOf(entity);
  return top.kind === 'model' || top.kind === 'light' ? top : null;
}

export async function removeChosen(context: Context): Promise<void> {
  const top = chosenTop(context);
  if (!top) return;
  await context.attempt(`Remove ${top.name}`, remove(context, top).then((isRemoved) => {
    if (!isRemoved) return;
    context.selection.set(null);
    context.log.add('info', `Removed ${top.name}; Ctrl+Z brings it back`);
  }));
}

/// Takes back the last change, or makes it again.
export async function undo(context: Context, isRedo = false): Promise<void> {
  const { history, log } = context;
  const word = isRedo ? 'Redo' : 'Undo';
  await context.attempt(word, (isRedo ? history.redo() : history.undo()).then((what) => log.add('info', what ? `${word}: ${what}` : `There is nothing to ${word.toLowerCase()}`)));
}

function messageOf(context: Context, entity: Entity): Message | undefined {
  return ((context.world.scene?.model ?? []) as Message[]).find(({ id }) => id === entity.id);
}

/// Current pose of the entity, as an ignition.msgs.Pose.
function poseNow(context: Context, entity: Entity, message: Message): Message | undefined {
  const live = context.world.poses.get(entity.id);
  if (!live) return message.pose as Message | undefined;
  const [x, y, z, qx, qy, qz, qw] = live;
  return { position: { x, y, z }, orientation: { x: qx, y: qy, z: qz, w: qw } };
}

/// Copies the selected model as SDF to the clipboard; saves it as a file if the browser denies access.
export async function copyAsSdf(context: Context): Promise<void> {
  const top = chosenTop(context);
  const message = top && messageOf(context, top);
  if (!message) return context.log.add('info', 'Select a model to copy');
  const sdf = modelSdf(message, poseNow(context, top, message));
  try {
    await navigator.clipboard.writeText(sdf);
    context.log.add('info', `${top.name} is in the clipboard as SDF, without plugins and sensors`);
  } catch {
    download(`${top.name}.sdf`, new Blob([sdf], { type: 'application/xml' }));
  }
}

let copied: { name: string; message: Message } | null = null;

export function copyChosen(context: Context): void {
  const top = chosenTop(context);
  const message = top && messageOf(context, top);
  if (!message) return;
  copied = { name: top.name, message };
  context.log.add('info', `${top.name} can be pasted`);
}

/// Inserts a copy of the copied model at a pose chosen by the user.
export async function paste(context: Context): Promise<void> {
  if (!copied) return;
  const { name, message } = copied;
  const place = await context.choosePlace(message);
  if (!place) return;
  const pose = poseMessage([...place.position, ...rollPitchYawOf(place.orientation)]);
  await context.attempt(`Paste ${name}`, insert(context, `Paste ${name}`, { from: { case: 'cloneName', value: name }, name, pose }, name));
}
