import assert from 'node:assert/strict';
import test from 'node:test';
import { imagePixels } from './image_pixels.ts';

const image = (pixelFormatType: number, width: number, height: number, data: number[], step = 0): Record<string, unknown> => ({
  pixelFormatType, width, height, step, data: Uint8Array.from(data),
});

test('colours keep their values, whatever their order', () => {
  assert.deepEqual([...imagePixels(image(3, 2, 1, [1, 2, 3, 4, 5, 6])).pixels], [1, 2, 3, 255, 4, 5, 6, 255]);
  assert.deepEqual([...imagePixels(image(8, 1, 1, [1, 2, 3])).pixels], [3, 2, 1, 255]);
  assert.deepEqual([...imagePixels(image(5, 1, 1, [1, 2, 3, 9])).pixels], [3, 2, 1, 255]);
  assert.deepEqual([...imagePixels(image(1, 1, 1, [7])).pixels], [7, 7, 7, 255]);
});

test('lines may be longer than their pixels', () => {
  assert.deepEqual([...imagePixels(image(1, 1, 2, [7, 0, 0, 0, 9], 4)).pixels], [7, 7, 7, 255, 9, 9, 9, 255]);
});

test('depths are from black to white, and what is beyond the range looks far', () => {
  const bytes = new Uint8Array(Float32Array.of(1, 3, Infinity, 2, -Infinity, NaN).buffer);
  const { pixels } = imagePixels(image(13, 6, 1, [...bytes]));
  assert.deepEqual([0, 4, 8, 12, 16, 20].map((at) => pixels[at]), [0, 255, 255, 128, 0, 0]);
});

test('what is cut off or of no known format is refused', () => {
  assert.throws(() => imagePixels(image(3, 2, 2, [1, 2, 3])), /truncated/);
  assert.throws(() => imagePixels(image(99, 1, 1, [1])), /format 99/);
});
