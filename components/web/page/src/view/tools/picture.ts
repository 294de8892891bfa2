/// A canvas as a PNG file.
/// @param scale By which the canvas is larger than the picture.
export async function pictureOf(canvas: HTMLCanvasElement, scale: number): Promise<Blob> {
  const picture = new OffscreenCanvas(Math.round(canvas.width / scale), Math.round(canvas.height / scale));
  const context = picture.getContext('2d');
  if (!context) throw new Error('the browser cannot take a picture');
  context.imageSmoothingQuality = 'high';
  context.drawImage(canvas, 0, 0, picture.width, picture.height);
  return picture.convertToBlob({ type: 'image/png' });
}
