import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments } from 'three';

export type Theme = 'dark' | 'light';

// the grid of Fortress: 20 cells of a metre
const half = 10;

/// Positions of the grid's lines, in pieces of one cell: long lines that pass the eye are not always drawn.
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
