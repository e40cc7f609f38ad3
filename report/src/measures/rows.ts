// Measures of gauges as rows: of one run with a column for each measure, of several with a column
// for each run.
import type { Measure, Run } from "../format";
import { words } from "../units";

export const MEASURES = [
  "largest",
  "time_of_largest",
  "smallest",
  "time_of_smallest",
  "first",
  "impulse",
  "integral_over_time",
  "arrival",
  "duration",
] as const;
export type MeasureName = (typeof MEASURES)[number];

export function unitOf(name: MeasureName, unit: string): string {
  if (name === "impulse" || name === "integral_over_time") return unit ? `${unit} s` : "s";
  const isTime = name.startsWith("time_of") || name === "arrival" || name === "duration";
  return isTime ? "s" : unit;
}

export interface Cell {
  value: number | null;
  unit: string;
}

export interface MeasureRow {
  gauge: string;
  column: string;
  cells: Cell[];
}

/** Measures that any of the runs has a number of. */
export function measuresThere(runs: Run[]): MeasureName[] {
  const all = runs.flatMap((run) => run.measures);
  return MEASURES.filter((name) => all.some((measure) => measure[name] !== null));
}

function cellOf(measure: Measure | undefined, name: MeasureName): Cell {
  return { value: measure?.[name] ?? null, unit: unitOf(name, measure?.unit ?? "") };
}

const rowKey = ({ gauge, column }: Measure): string => `${gauge}\n${column}`;

/** Rows of all gauges and columns of the runs, each once, in the order of the first run. */
export function measureRows(
  runs: Run[],
  cells: (found: (Measure | undefined)[]) => Cell[],
): MeasureRow[] {
  const known = runs.map((run) => new Map(run.measures.map((m) => [rowKey(m), m])));
  const keys = new Map(runs.flatMap((run) => run.measures.map((m) => [rowKey(m), m])));
  return [...keys].map(([key, { gauge, column }]) => ({
    gauge,
    column,
    cells: cells(known.map((measures) => measures.get(key))),
  }));
}

export function rowsOfOne(run: Run, names: MeasureName[]): MeasureRow[] {
  return measureRows([run], ([measure]) => names.map((name) => cellOf(measure, name)));
}

export function rowsOfSeveral(runs: Run[], name: MeasureName): MeasureRow[] {
  return measureRows(runs, (found) => found.map((measure) => cellOf(measure, name)));
}

export function matches(gauge: string, column: string, wanted: string): boolean {
  const text = `${gauge} ${column} ${words(column)}`.toLowerCase();
  return wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

/** All numbers of all runs with all their digits, for files. */
export function csvRows(runs: Run[]): (string | number | null)[][] {
  const decay = ["exponent", "points", "scatter"] as const;
  const head = ["run", "gauge", "column", "unit", ...MEASURES, ...decay.map((d) => `decay_${d}`)];
  const rows = runs.flatMap((run) =>
    run.measures.map((measure) => {
      const found = run.decays.find(({ gauge }) => gauge === measure.gauge);
      const { gauge, column, unit } = measure;
      const numbers = [
        ...MEASURES.map((name) => measure[name]),
        ...decay.map((part) => found?.[part] ?? null),
      ];
      return [run.name, gauge, column, unit, ...numbers];
    }),
  );
  return [head, ...rows];
}
