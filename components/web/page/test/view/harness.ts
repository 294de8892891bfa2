// The page for tests of the view alone, which tests use as `window.view`.
import { View } from '../../src/view/index.ts';

const events: unknown[] = [];
const view = new View(document.getElementById('view')!, {
  asset: async (address) => {
    const answer = await fetch(`/files${address}`);
    if (!answer.ok) throw new Error(`there is no ${address}`);
    return answer.arrayBuffer();
  },
  onPick: (entity) => events.push({ pick: entity }),
  onMove: (entity, pose, during) => void events.push({ move: entity, pose, during }),
  onPlace: (pose) => events.push({ place: pose }),
  onProblem: (text) => events.push({ problem: text }),
});

/// Waits until a scheduled frame has been drawn.
function drawn(): Promise<void> {
  return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve())));
}

async function pixelsOf(picture: Blob): Promise<ImageData> {
  const bitmap = await createImageBitmap(picture);
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  return context.getImageData(0, 0, bitmap.width, bitmap.height);
}

/// Compares a screenshot with an image: the mean difference, of 255, and the fraction of pixels that differ by more
/// than 24.
async function difference(other: string): Promise<{ mean: number; share: number }> {
  const a = await pixelsOf(await view.screenshot());
  const b = await pixelsOf(await (await fetch(other)).blob());
  if (a.width !== b.width || a.height !== b.height) return { mean: 255, share: 1 };
  let sum = 0;
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    let most = 0;
    for (let k = 0; k < 3; ++k) most = Math.max(most, Math.abs(a.data[i + k]! - b.data[i + k]!));
    sum += most;
    if (most > 24) ++count;
  }
  return { mean: sum / (a.data.length / 4), share: count / (a.data.length / 4) };
}

/// The colour of a pixel in a screenshot; x and y are fractions of its size.
async function colorAt(x = 0.5, y = 0.5): Promise<number[]> {
  const { data, width, height } = await pixelsOf(await view.screenshot());
  const at = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
  return [...data.slice(at, at + 3)];
}

async function screenshotText(): Promise<string> {
  const bytes = new Uint8Array(await (await view.screenshot()).arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}

Object.assign(window, { view, events, drawn, difference, colorAt, screenshotText });
