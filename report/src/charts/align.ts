// Curves of several runs have times of their own; the plot wants one list of times for all.
import type { Curve } from "./curves";

/** null: a hole in the curve. undefined: a time of another curve, which the line passes over. */
export type Aligned = [number[], ...(number | null | undefined)[][]];

/** Times of all curves, ascending, each once. */
export function unionOfTimes(curves: Curve[]): number[] {
  const lists = [...new Set(curves.map((curve) => curve.x))];
  if (lists.length === 1) return Array.from(lists[0]);
  const all = new Set<number>();
  for (const list of lists) for (let i = 0; i < list.length; ++i) all.add(list[i]);
  return [...all].sort((a, b) => a - b);
}

export function align(curves: Curve[], isLogX: boolean, isLogY: boolean): Aligned {
  let times = unionOfTimes(curves).filter(Number.isFinite);
  if (isLogX) times = times.filter((time) => time > 0);
  // One list of x may hold a value twice, as parameters of members do.
  if (isOneList(curves, times))
    return [times, ...curves.map(({ y, drawn }) => drawable(drawn ?? y, isLogY))];
  const rowOf = new Map(times.map((time, row) => [time, row]));
  const columns = curves.map(({ x, y: read, drawn }) => {
    const y = drawn ?? read;
    const column: (number | null | undefined)[] = new Array<undefined>(times.length).fill(
      undefined,
    );
    for (let i = 0; i < x.length; ++i) {
      const row = rowOf.get(x[i]);
      if (row !== undefined) column[row] = isDrawable(y[i], isLogY) ? y[i] : null;
    }
    widenHoles(column);
    return column;
  });
  return [times, ...columns];
}

/** Times of other curves beside a hole belong to it: the line must not show between them. */
function widenHoles(column: (number | null | undefined)[]): void {
  const from = (first: number, step: number) => {
    let isHole = false;
    for (let i = first; i >= 0 && i < column.length; i += step) {
      if (column[i] === undefined && isHole) column[i] = null;
      isHole = column[i] === null;
    }
  };
  from(0, 1);
  from(column.length - 1, -1);
}

function isOneList(curves: Curve[], times: number[]): boolean {
  return curves.every(({ x }) => x === curves[0].x && x.length === times.length);
}

function drawable(y: ArrayLike<number>, isLogY: boolean): (number | null)[] {
  return Array.from(y, (value) => (isDrawable(value, isLogY) ? value : null));
}

/** Logarithmic axes have no place for zero and less. */
function isDrawable(value: number, isLogY: boolean): boolean {
  return Number.isFinite(value) && (!isLogY || value > 0);
}
