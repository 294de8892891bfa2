/// Shows the images on a camera's topic.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h } from '../app/dom.ts';
import { imagePixels } from './image_pixels.ts';
import { topicChooser, topicSetting } from './topics.ts';

export function openImageDisplay(context: Context, settings: Settings): Panel {
  const { connection } = context;
  const ends = new Ends();
  let stop = (): void => {};
  const canvas = h('canvas', { class: 'picture', role: 'img', 'aria-label': 'Camera image' });
  const note = h('p', { class: 'hint' }, 'No camera publishes images');
  const listen = (topic: string): void => {
    stop();
    stop = (): void => {};
    if (!topic) return;
    note.textContent = 'Waiting for an image';
    stop = connection.subscribe(topic, (image) => {
      try {
        const { width, height, pixels } = imagePixels(image);
        if (canvas.width !== width) canvas.width = width;
        if (canvas.height !== height) canvas.height = height;
        canvas.getContext('2d')?.putImageData(new ImageData(pixels, width, height), 0, 0);
        note.textContent = `${width} × ${height}`;
      } catch (fault) {
        note.textContent = (fault as Error).message;
      }
    });
  };
  const select = topicChooser(context, ['ignition.msgs.Image'], setting(settings, 'topic'), ends, listen);
  ends.add(() => stop());
  return { element: h('div', { class: 'image-display' }, select, canvas, note), close: ends.end, settings: () => topicSetting(select) };
}
