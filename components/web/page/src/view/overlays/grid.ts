import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from 'three';

export type Theme = 'dark' | 'light';

// half the number of cells: Fortress's grid has 20 x 20 cells of 1 m
const half = 10;

/// End points of the grid's lines, in pieces of one cell: some renderers drop long lines that pass the camera.
export function gridLines(): number[] {
  const lines: number[] = [];
  for (let a = -half; a <= half; ++a) {
    for (let b = -half; b < half; ++b) lines.push(a, b, 0, a, b + 1, 0, b, a, 0, b + 1, a, 0);
  }
  return lines;
}

export function gridOf(theme: Theme): LineSegments<BufferGeometry, LineBasicMaterial> {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(gridLines(), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: theme === 'dark' ? 0x606060 : 0x808080 }));
}
