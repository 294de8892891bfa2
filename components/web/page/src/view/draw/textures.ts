import { type ColorSpace, type Material, RepeatWrapping, SRGBColorSpace, Texture } from 'three';

/// Returns the bytes of a file by its address in the scene.
export type FetchAsset = (address: string) => Promise<ArrayBuffer>;

/// The textures in use, by address. Each file is fetched once.
export class Textures {
  private readonly textures = new Map<string, Promise<Texture>>();
  private readonly embedded = new Map<string, ArrayBuffer>();

  /// @param changed Called when a texture has been loaded.
  /// @param problem Called once for each texture that can't be loaded.
  constructor(
    private readonly asset: FetchAsset,
    private readonly changed: () => void,
    private readonly problem: (text: string) => void,
  ) {}

  /// Assigns a texture to a material when it has been loaded.
  put(material: Material, slot: string, address: string, colorSpace: ColorSpace): void {
    if (address === '') return;
    void this.get(address, colorSpace).then(
      (texture) => {
        (material as unknown as Record<string, Texture>)[slot] = texture;
        material.needsUpdate = true;
        this.changed();
      },
      () => {},
    );
  }

  /// Stores the bytes of an image embedded in another file.
  embed(address: string, bytes: ArrayBuffer): void {
    this.embedded.set(address, bytes);
  }

  /// @param address One address, or several in lines, of which the first that exists is used.
  private get(address: string, colorSpace: ColorSpace): Promise<Texture> {
    const key = `${colorSpace} ${address}`;
    let known = this.textures.get(key);
    if (known === undefined) {
      known = this.fetch(address.split('\n'), colorSpace);
      known.catch((error: unknown) => this.problem(`texture '${address.split('\n')[0]}' can't be shown: ${words(error)}`));
      this.textures.set(key, known);
    }
    return known;
  }

  private async fetch(addresses: string[], colorSpace: ColorSpace): Promise<Texture> {
    let first: unknown;
    for (const address of addresses) {
      try {
        return await textureOf(this.embedded.get(address) ?? (await this.asset(address)), colorSpace);
      } catch (error) {
        first ??= error;
      }
    }
    throw first;
  }

  dispose(): void {
    for (const texture of this.textures.values()) void texture.then((made) => made.dispose(), () => {});
    this.textures.clear();
  }
}

export function words(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}

/// @param bytes Of a PNG or JPEG file.
export async function textureOf(bytes: ArrayBuffer, colorSpace: ColorSpace): Promise<Texture> {
  const picture = await createImageBitmap(new Blob([bytes]), {
    imageOrientation: 'flipY',
    premultiplyAlpha: 'none',
    colorSpaceConversion: colorSpace === SRGBColorSpace ? 'default' : 'none',
  });
  const texture = new Texture(picture);
  // createImageBitmap has flipped the image
  texture.flipY = false;
  texture.colorSpace = colorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
