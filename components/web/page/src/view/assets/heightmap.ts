import { BufferAttribute, BufferGeometry, Vector3 } from 'three';

/// The brightness of each pixel, 0 to 255; the first row is the top of the image.
export interface GrayPicture {
  width: number;
  height: number;
  pixels: Uint8Array;
}

/// The surface of a heightmap, as in Fortress. Black is at the origin's z, and the brightest pixel is higher by size z;
/// the top of the image is in the direction of y. A pixel is size / number of pixels wide.
export function groundGeometry(picture: GrayPicture, size: Vector3, origin: Vector3): BufferGeometry {
  const { width, height, pixels } = picture;
  const brightest = pixels.reduce((most, value) => Math.max(most, value), 1);
  const places = new Float32Array(width * height * 3);
  const texels = new Float32Array(width * height * 2);
  for (let row = 0; row < height; ++row) {
    for (let column = 0; column < width; ++column) {
      const at = row * width + column;
      places[at * 3] = origin.x + (column - (width - 1) / 2) * (size.x / width);
      places[at * 3 + 1] = origin.y + ((height - 1) / 2 - row) * (size.y / height);
      places[at * 3 + 2] = origin.z + (pixels[at]! / brightest) * size.z;
      texels[at * 2] = column / Math.max(width - 1, 1);
      texels[at * 2 + 1] = 1 - row / Math.max(height - 1, 1);
    }
  }
  const corners = new Uint32Array(Math.max(width - 1, 0) * Math.max(height - 1, 0) * 6);
  let at = 0;
  for (let row = 0; row + 1 < height; ++row) {
    for (let column = 0; column + 1 < width; ++column) {
      const a = row * width + column;
      const below = a + width;
      corners.set([a, below, below + 1, a, below + 1, a + 1], at);
      at += 6;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(places, 3));
  geometry.setAttribute('uv', new BufferAttribute(texels, 2));
  geometry.setIndex(new BufferAttribute(corners, 1));
  geometry.computeVertexNormals();
  return geometry;
}

/// @param bytes An image file. As in the simulator, the red channel is used, and the upper 8 bits of 16.
export async function grayPictureOf(bytes: ArrayBuffer): Promise<GrayPicture> {
  const bitmap = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d');
  if (context === null) throw new Error('this browser cannot read pixels');
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const colors = context.getImageData(0, 0, width, height).data;
  return { width, height, pixels: Uint8Array.from({ length: width * height }, (_, i) => colors[i * 4]!) };
}
