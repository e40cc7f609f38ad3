// Boxes as the segments of their edges: whole ones, and walls with sides left out.
import type { WallBox } from "../format";
import type { SceneBox } from "./scene_interface";

const AXES = [0, 1, 2];

export function space(point: number[]): number[] {
  return AXES.map((axis) => point[axis] ?? 0);
}

/**
 * Edges of a box of so many dimensions. An edge is drawn where one of the sides that meet in it is
 * `closed`: in 2D an edge is a side.
 */
export function boxEdges(
  min: number[],
  max: number[],
  dimension: number,
  closed: (axis: number, isUpper: boolean) => boolean = () => true,
): number[] {
  const axes = AXES.slice(0, dimension);
  const corner = (code: number) =>
    AXES.map((axis) => (axis < dimension && (code >> axis) & 1 ? max[axis] : min[axis]) ?? 0);
  const edges: number[] = [];
  for (let code = 0; code < 2 ** dimension; ++code) {
    for (const along of axes) {
      if ((code >> along) & 1) continue;
      const across = axes.filter((axis) => axis !== along);
      const isDrawn =
        across.length === 0 || across.some((axis) => closed(axis, Boolean((code >> axis) & 1)));
      if (isDrawn) edges.push(...corner(code), ...corner(code | (1 << along)));
    }
  }
  return edges;
}

function isFinitePlace(place: number[]): boolean {
  return place.every((x) => Number.isFinite(x));
}

/** Walls of a profile over x are upright lines at its ends. */
function ends({ min, max }: WallBox, closed: (isUpper: boolean) => boolean, box: SceneBox) {
  return [false, true].filter(closed).flatMap((isUpper) => {
    const x = isUpper ? max[0] : min[0];
    return [x, box.min[1], 0, x, box.max[1], 0];
  });
}

export function wallOutlines(walls: WallBox[], box: SceneBox): Float64Array {
  const segments = walls.filter(({ min, max }) => isFinitePlace([...min, ...max]));
  return Float64Array.from(
    segments.flatMap((wall) => {
      const closed = (axis: number, isUpper: boolean) =>
        !wall.open.includes("xyz"[axis] + (isUpper ? "+" : "-"));
      return box.dimension === 1
        ? ends(wall, (isUpper) => closed(0, isUpper), box)
        : boxEdges(space(wall.min), space(wall.max), box.dimension, closed);
    }),
  );
}
