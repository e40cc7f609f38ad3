// Curves as rows of a CSV file: all times of all runs, empty where a run has no row.
import { unionOfTimes } from "./align";
import type { Curve } from "./curves";

type Cell = string | number | null | undefined;

function headOf({ run, label, unit }: Curve): string {
  return `${run ? `${run.name}: ` : ""}${label}${unit ? ` [${unit}]` : ""}`;
}

export function rowsOfCurves(xName: string, xUnit: string, curves: Curve[]): Cell[][] {
  const times = unionOfTimes(curves).sort((a, b) => a - b);
  const values = curves.map(({ x, y }) => {
    const at = new Map<number, number>();
    for (let i = 0; i < x.length; ++i) at.set(x[i], y[i]);
    return at;
  });
  const head = [`${xName}${xUnit ? ` [${xUnit}]` : ""}`, ...curves.map(headOf)];
  return [head, ...times.map((time) => [time, ...values.map((at) => at.get(time))])];
}
