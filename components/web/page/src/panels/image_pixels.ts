/// Converts an ignition.msgs.Image to pixels for a canvas.
import type { Message } from '../connection/types.ts';

// ignition.msgs.PixelFormatType
const kFormats: Record<number, { bytes: number; read: (data: DataView, at: number) => [number, number, number] | number }> = {
  1: { bytes: 1, read: (data, at) => [data.getUint8(at), data.getUint8(at), data.getUint8(at)] },
  2: { bytes: 2, read: (data, at) => data.getUint16(at, true) },
  3: { bytes: 3, read: (data, at) => [data.getUint8(at), data.getUint8(at + 1), data.getUint8(at + 2)] },
  4: { bytes: 4, read: (data, at) => [data.getUint8(at), data.getUint8(at + 1), data.getUint8(at + 2)] },
  5: { bytes: 4, read: (data, at) => [data.getUint8(at + 2), data.getUint8(at + 1), data.getUint8(at)] },
  8: { bytes: 3, read: (data, at) => [data.getUint8(at + 2), data.getUint8(at + 1), data.getUint8(at)] },
  13: { bytes: 4, read: (data, at) => data.getFloat32(at, true) },
};

/// Converts an image to 4 bytes per pixel. Depths and temperatures are grey, from black (smallest) to white (largest). As
/// depth cameras mean it, infinity is farther than all others, minus infinity nearer; NaN is black.
/// @throws Error if the format is not supported, or bytes are missing.
export function imagePixels(image: Message): { width: number; height: number; pixels: Uint8ClampedArray<ArrayBuffer> } {
  const [width, height] = [image.width as number, image.height as number];
  const format = kFormats[image.pixelFormatType as number];
  if (width === 0 || height === 0) throw new Error('the image is empty');
  if (!format) throw new Error(`images of format ${image.pixelFormatType} can't be shown`);
  const bytes = image.data as Uint8Array;
  const step = Math.max(image.step as number, width * format.bytes);
  if (bytes.length < (height - 1) * step + width * format.bytes) throw new Error('the image is truncated');
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const pixels = new Uint8ClampedArray(4 * width * height);
  const values = new Float32Array(typeof format.read(data, 0) === 'number' ? width * height : 0);
  for (let y = 0, pixel = 0; y < height; y++) {
    for (let x = 0; x < width; x++, pixel++) {
      const value = format.read(data, y * step + x * format.bytes);
      if (typeof value === 'number') values[pixel] = value;
      else pixels.set(value, 4 * pixel);
      pixels[4 * pixel + 3] = 255;
    }
  }
  if (values.length > 0) spread(values, pixels);
  return { width, height, pixels };
}

function spread(values: Float32Array, pixels: Uint8ClampedArray): void {
  let [least, most] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  const scale = most > least ? 255 / (most - least) : 0;
  values.forEach((value, i) => pixels.fill(value === Infinity ? 255 : Number.isFinite(value) ? (value - least) * scale : 0, 4 * i, 4 * i + 3));
}
