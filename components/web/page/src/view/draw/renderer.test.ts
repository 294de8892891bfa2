import assert from 'node:assert/strict';
import { test } from 'node:test';

import { isEmulated } from './renderer.ts';

test('emulated graphics are known by their names', () => {
  for (const name of [
    'ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)',
    'ANGLE (Mesa, llvmpipe (LLVM 15.0.6 256 bits), OpenGL 4.5)', 'Google SwiftShader', 'Microsoft Basic Render Driver',
  ]) assert.ok(isEmulated(name), name);
  assert.ok(!isEmulated('ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11 vs_5_0 ps_5_0)'));
  assert.ok(!isEmulated('Mesa Intel(R) UHD Graphics 620 (KBL GT2)'));
});
