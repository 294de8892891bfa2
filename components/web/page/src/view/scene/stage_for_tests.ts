import assert from 'node:assert/strict';

import type { Style } from '../draw/materials.ts';
import type { SceneMessage } from '../messages.ts';
import { Stage } from './stage.ts';

export const plainStyle: Readonly<Style> = { wireframe: false, transparent: false };

/// A stage without files, which ignores problems.
export function stageOf(scene: SceneMessage): Stage {
  const stage = new Stage({
    asset: () => Promise.reject(new Error('no files')),
    changed: () => {},
    problem: assert.fail,
    styleOf: () => plainStyle,
  });
  stage.setScene(scene);
  return stage;
}
