// Writes an animated WebP file (https://developers.google.com/speed/webp/docs/riff_container).

function chunk(name, ...parts) {
  const data = Buffer.concat(parts);
  const head = Buffer.alloc(8);
  head.write(name, 0, 'latin1');
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

function number(value, bytes) {
  const buffer = Buffer.alloc(bytes);
  buffer.writeUIntLE(value, 0, bytes);
  return buffer;
}

/// @return The chunks of a WebP file, as objects with the name and the whole chunk.
export function chunksOf(file) {
  const chunks = [];
  for (let at = 12; at < file.length;) {
    const length = file.readUInt32LE(at + 4);
    chunks.push({ name: file.toString('latin1', at, at + 4), whole: file.subarray(at, at + 8 + length + (length % 2)) });
    at += 8 + length + (length % 2);
  }
  return chunks;
}

/// @param pictures WebP files of that size [pixels], lossy and without transparency.
/// @param ms Duration of each image; the animation repeats forever.
export function movingWebp(pictures, { width, height }, ms) {
  const size = Buffer.concat([number(width - 1, 3), number(height - 1, 3)]);
  const frames = pictures.map((picture) => {
    const pixels = chunksOf(picture).find(({ name }) => name === 'VP8 ').whole;
    // offset (0, 0), no blending
    return chunk('ANMF', number(0, 6), size, number(ms, 3), number(2, 1), pixels);
  });
  const animated = number(2, 4);
  const body = [chunk('VP8X', animated, size), chunk('ANIM', number(0xffffffff, 4), number(0, 2)), ...frames];
  return Buffer.concat([chunk('RIFF', Buffer.from('WEBP', 'latin1'), ...body)]);
}
