import { LoadingManager, Loader, type Object3D, type Texture } from 'three';
import { GLTFLoader, type GLTFParser } from 'three/examples/jsm/loaders/GLTFLoader.js';
import { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js';
import { ColladaComposer } from 'three/examples/jsm/loaders/collada/ColladaComposer.js';
import { ColladaParser } from 'three/examples/jsm/loaders/collada/ColladaParser.js';
import { Material, Mesh, MeshPhongMaterial } from 'three';

import type { FetchAsset } from '../draw/textures.ts';
import { addressBeside, endingOf, pictureAddresses } from './address.ts';
import { type MeshPart, namedPicture, partsOf } from './mesh_parts.ts';

export interface MeshRequest {
  filename: string;
  submesh: string;
  isCentered: boolean;
}

/// The mesh files in use. Each is fetched and parsed once.
export class Meshes {
  private readonly files = new Map<string, Promise<Object3D>>();
  private readonly parts = new Map<string, Promise<MeshPart[]>>();
  private readonly done = new Map<string, MeshPart[]>();
  private readonly failed = new Set<MeshRequest>();

  /// @param embed Stores an image that is embedded in a mesh file, under an address.
  constructor(
    private readonly asset: FetchAsset,
    private readonly embed: (address: string, bytes: ArrayBuffer) => void,
  ) {}

  static key(request: MeshRequest): string {
    return `${request.filename}|${request.submesh}|${request.isCentered}`;
  }

  /// @returns The parts, if the file has been loaded.
  known(request: MeshRequest): MeshPart[] | undefined {
    return this.done.get(Meshes.key(request));
  }

  /// Forgets failures, so that these files are fetched again: the connection may have been lost.
  retry(): void {
    for (const request of this.failed) {
      this.parts.delete(Meshes.key(request));
      this.files.delete(request.filename);
    }
    this.failed.clear();
  }

  /// @throws (rejects) An Error with the reason.
  get(request: MeshRequest): Promise<MeshPart[]> {
    const key = Meshes.key(request);
    let known = this.parts.get(key);
    if (known === undefined) {
      known = this.read(request);
      this.parts.set(key, known);
      known.then((parts) => this.done.set(key, parts), () => this.failed.add(request));
    }
    return known;
  }

  private async read(request: MeshRequest): Promise<MeshPart[]> {
    let file = this.files.get(request.filename);
    if (file === undefined) {
      file = this.asset(request.filename).then((bytes) => this.parse(request.filename, bytes));
      this.files.set(request.filename, file);
    }
    const ending = endingOf(request.filename);
    const isGltf = ending === 'glb' || ending === 'gltf';
    const parts = partsOf(await file, { ...request, hasScreenColors: !isGltf, hasTexelsFromTop: isGltf });
    if (parts.length === 0) {
      throw new Error(request.submesh === '' ? 'it contains no triangles' : `it has no submesh '${request.submesh}'`);
    }
    return parts;
  }

  private async parse(address: string, bytes: ArrayBuffer): Promise<Object3D> {
    switch (endingOf(address)) {
      case 'dae':
        return parseCollada(address, new TextDecoder().decode(bytes));
      case 'stl':
        return new Mesh(new STLLoader().parse(bytes), defaultMaterial());
      case 'obj':
        return await this.parseObj(address, new TextDecoder().decode(bytes));
      case 'glb':
      case 'gltf':
        return await this.parseGltf(address, bytes);
      default:
        throw new Error('supported formats are .dae, .stl, .obj, .glb and .gltf');
    }
  }

  private async parseObj(address: string, text: string): Promise<Object3D> {
    const loader = new OBJLoader();
    const library = /^mtllib\s+(.+?)\s*$/m.exec(text)?.[1];
    if (library === undefined) return withDefaults(loader.parse(text));
    try {
      const manager = new LoadingManager();
      manager.addHandler(/./, new NamedPictures(address) as unknown as Loader);
      const bytes = await this.asset(addressBeside(address, library));
      const materials = new MTLLoader(manager).parse(new TextDecoder().decode(bytes), '');
      materials.preload();
      return loader.setMaterials(materials).parse(text);
    } catch {
      // without its material library, the shape can still be shown
      return withDefaults(loader.parse(text));
    }
  }

  private async parseGltf(address: string, bytes: ArrayBuffer): Promise<Object3D> {
    const loader = new GLTFLoader();
    loader.register((parser) => ({
      name: 'files of the scene',
      loadTexture: (index: number) => this.gltfTexture(address, parser, index),
      loadBufferView: (index: number) => this.gltfView(address, parser, index),
    }));
    return (await loader.parseAsync(bytes, '')).scene;
  }

  private async gltfTexture(address: string, parser: GLTFParser, index: number): Promise<Texture> {
    const number = (parser.json.textures[index] as { source: number }).source;
    const image = parser.json.images[number] as { uri?: string; bufferView?: number };
    if (image.uri !== undefined && !image.uri.startsWith('data:')) {
      return namedPicture(pictureAddresses(address, decodeURIComponent(image.uri)));
    }
    const within = `${address}#${number}`;
    const bytes =
      image.uri === undefined
        ? ((await parser.getDependency('bufferView', image.bufferView ?? 0)) as ArrayBuffer)
        : dataOf(image.uri);
    this.embed(within, bytes);
    return namedPicture(within);
  }

  /// @returns The bytes of a buffer view; null if they are in the glTF file itself, whose loader reads them.
  private gltfView(address: string, parser: GLTFParser, index: number): Promise<ArrayBuffer> | null {
    const view = parser.json.bufferViews[index] as { buffer: number; byteOffset?: number; byteLength: number };
    const { uri } = parser.json.buffers[view.buffer] as { uri?: string };
    if (uri === undefined) return null;
    const begin = view.byteOffset ?? 0;
    const whole = uri.startsWith('data:')
      ? Promise.resolve(dataOf(uri))
      : this.asset(addressBeside(address, decodeURIComponent(uri)));
    return whole.then((bytes) => bytes.slice(begin, begin + view.byteLength));
  }
}

/// A texture loader that only records addresses, without loading.
class NamedPictures {
  constructor(private readonly mesh: string) {}

  load(name: string): Texture {
    return namedPicture(pictureAddresses(this.mesh, decodeURIComponent(name)));
  }
}

function defaultMaterial(): MeshPhongMaterial {
  const material = new MeshPhongMaterial();
  material.userData['isDefault'] = true;
  return material;
}

function withDefaults(root: Object3D): Object3D {
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    for (const material of [node.material as Material | Material[]].flat()) material.userData['isDefault'] = true;
  });
  return root;
}

function parseCollada(address: string, text: string): Object3D {
  const parsed = new ColladaParser().parse(text);
  if (parsed === null) throw new Error('it is not a Collada file');
  const pictures = new NamedPictures(address);
  const { scene } = new ColladaComposer(parsed.library, parsed.collada, pictures, pictures).compose();
  // the file's unit is applied, but not its up axis, as in Fortress
  scene.scale.setScalar(parsed.asset.unit || 1);
  return scene;
}

/// The bytes of a data URI.
function dataOf(uri: string): ArrayBuffer {
  const comma = uri.indexOf(',');
  const text = uri.slice(comma + 1);
  const plain = uri.slice(0, comma).endsWith(';base64') ? atob(text) : decodeURIComponent(text);
  return Uint8Array.from(plain, (letter) => letter.charCodeAt(0)).buffer;
}
