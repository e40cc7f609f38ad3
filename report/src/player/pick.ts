// Which particle is at a place of the picture; how many a slice leaves.
import { NONE, STEPS } from "../format";
import type { SceneBox, Slice } from "./scene_interface";

export interface Spot {
  x: number; // pixels from the left
  y: number; // pixels from the top
  depth: number; // -1 near, 1 far
}

export function project(
  matrix: ArrayLike<number>,
  x: number,
  y: number,
  z: number,
  width: number,
  height: number,
): Spot {
  const m = matrix;
  const w = m[3] * x + m[7] * y + m[11] * z + m[15];
  const clip = (row: number) => (m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12]) / w;
  return {
    x: 0.5 * (clip(0) + 1) * width,
    y: 0.5 * (1 - clip(1)) * height,
    depth: w > 0 ? clip(2) : 2,
  };
}

/** Not so for a particle that is nowhere: one of its components is none. */
function isSomewhere(quads: Uint16Array, index: number): boolean {
  return [0, 1, 2].every((axis) => quads[4 * index + axis] !== NONE);
}

/** Not-a-number where there is none. */
export function place(box: SceneBox, quads: Uint16Array, index: number): [number, number, number] {
  const at = (axis: number) => {
    const quantised = quads[4 * index + axis];
    if (quantised === NONE) return NaN;
    return box.min[axis] + (quantised / STEPS) * (box.max[axis] - box.min[axis]);
  };
  return [at(0), at(1), at(2)];
}

export function isInSlice(
  box: SceneBox,
  quads: Uint16Array,
  index: number,
  slice: Slice | null,
): boolean {
  if (!slice) return true;
  const along = place(box, quads, index)[slice.axis];
  return along >= slice.low && along <= slice.high;
}

export interface Picking {
  matrix: ArrayLike<number>;
  width: number;
  height: number;
  box: SceneBox;
  quads: Uint16Array;
  slice: Slice | null;
  isHidden(value: number): boolean;
  /** Radius of a dot in pixels at a depth. */
  reach: number;
}

/**
 * Number of the particle nearest to the eye among those under the pointer, or else nearest to it;
 * -1 if none is near.
 */
export function pick(picking: Picking, x: number, y: number): number {
  const { matrix, width, height, box, quads, slice, reach } = picking;
  let best = -1;
  let least = Infinity;
  for (let i = 0; i < quads.length / 4; ++i) {
    if (!isSomewhere(quads, i)) continue;
    const [px, py, pz] = place(box, quads, i);
    const spot = project(matrix, px, py, pz, width, height);
    const away = Math.hypot(spot.x - x, spot.y - y);
    if (away > reach || spot.depth > 1 || spot.depth < -1) continue;
    if (picking.isHidden(quads[4 * i + 3]) || !isInSlice(box, quads, i, slice)) continue;
    // Depth decides between dots that cover each other, distance between those beside each other.
    const badness = box.dimension === 3 ? spot.depth + (1e-3 * away) / reach : away;
    if (badness < least) [best, least] = [i, badness];
  }
  return best;
}

export function countDrawn(
  box: SceneBox,
  quads: Uint16Array,
  slice: Slice | null,
  isHidden: (value: number) => boolean,
): number {
  let drawn = 0;
  for (let i = 0; i < quads.length / 4; ++i) {
    if (isHidden(quads[4 * i + 3]) || !isSomewhere(quads, i)) continue;
    if (isInSlice(box, quads, i, slice)) ++drawn;
  }
  return drawn;
}
