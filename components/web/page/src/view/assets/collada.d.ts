// Type declarations for the parts of three's ColladaLoader that the page uses.
declare module 'three/examples/jsm/loaders/collada/ColladaParser.js' {
  export class ColladaParser {
    parse(text: string): { library: unknown; collada: unknown; asset: { unit: number; upAxis: string } } | null;
  }
}
declare module 'three/examples/jsm/loaders/collada/ColladaComposer.js' {
  import type { Scene, Texture } from 'three';
  interface PictureLoader {
    load(name: string): Texture;
  }
  export class ColladaComposer {
    constructor(library: unknown, collada: unknown, textures: PictureLoader, tgas: PictureLoader);
    compose(): { scene: Scene };
  }
}
