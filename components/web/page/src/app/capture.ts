/// Screenshots and videos of the view, as files.
import type { Context } from './context.ts';
import { download } from './dom.ts';

const stamp = (): string => new Date().toISOString().slice(0, 19).replaceAll(':', '-');

export async function saveScreenshot(context: Context): Promise<void> {
  const { view, stream, world, log } = context;
  const sight = view ?? stream;
  if (!sight) return log.add('info', 'There is no view to take a picture of');
  await context.attempt('Screenshot', sight.screenshot().then((picture) => download(`${world.name}-${stamp()}.png`, picture)));
}

/// Starts or stops recording a video.
/// @return Whether a video is being recorded now.
export async function toggleVideo(context: Context, isTaking: boolean): Promise<boolean> {
  const { view, world, log } = context;
  if (!view) {
    log.add('info', 'There is no view to record');
    return false;
  }
  if (isTaking) {
    await context.attempt('Video', view.stopVideo().then((video) => download(`${world.name}-${stamp()}.webm`, video)));
    return false;
  }
  try {
    view.startVideo();
    return true;
  } catch (fault) {
    log.add('error', `Video: ${(fault as Error).message}`);
    return false;
  }
}
