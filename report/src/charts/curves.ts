// The curves that can be drawn: columns of the tables of all runs, and measured ones beside them.
import type { App } from "../app";
import type { Column, Reference, Run, Table } from "../format";
import { words } from "../units";

export interface Curve {
  /** The run it is of; null for curves over something else than time. */
  run: Run | null;
  key: string;
  label: string;
  /** What it is of, without the gauge: the name of its axis. */
  quantity: string;
  unit: string;
  /** Measured values and the like: dots instead of a line. */
  isDots: boolean;
  source: string;
  /** "101 of 404" rows where rows were left out, or "". */
  note: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  /** What a row is of, where it is not only a time. */
  rowNames?: string[];
  /** What is drawn in place of y, where curves stand on each other. */
  drawn?: ArrayLike<number>;
}

/** One column that may be chosen, in whichever of the runs it occurs. */
export interface Available {
  key: string;
  table: string;
  column: Column;
}

export function columnKey(table: string, label: string): string {
  return `${table}\n${label}`;
}

/** Names of gauges are the user's own and stay as they are. */
function labelOf({ label, gauge, name }: Column): string {
  if (gauge === "") return words(label);
  return label === `${gauge} ${name}` ? `${gauge} ${words(name)}` : label;
}

export function availableColumns(runs: Run[]): Available[] {
  const found = new Map<string, Available>();
  for (const run of runs) {
    for (const table of run.tables) {
      for (const column of table.columns) {
        const key = columnKey(table.name, column.label);
        if (!found.has(key)) found.set(key, { key, table: table.name, column });
      }
    }
  }
  return [...found.values()];
}

async function columnCurve(app: App, run: Run, table: Table, column: Column): Promise<Curve> {
  const [x, y] = await Promise.all([
    app.blocks.numbers(table.time),
    app.blocks.numbers(column.data),
  ]);
  const note = table.rows_of > table.rows ? `${table.rows} of ${table.rows_of}` : "";
  const common = {
    run,
    key: columnKey(table.name, column.label),
    label: labelOf(column),
    unit: column.unit,
  };
  return { ...common, quantity: words(column.name), isDots: false, source: "", note, x, y };
}

async function referenceCurve(
  app: App,
  run: Run,
  reference: Reference,
  column: Column,
): Promise<Curve> {
  const [x, y] = await Promise.all([
    app.blocks.numbers(reference.time),
    app.blocks.numbers(reference.value),
  ]);
  const key = columnKey(reference.table, reference.column);
  const { name, source } = reference;
  return {
    run,
    key,
    label: name,
    quantity: words(column.name),
    unit: column.unit,
    isDots: true,
    source,
    note: "",
    x,
    y,
  };
}

/**
 * The chosen columns of all `runs`, in the order of `keys`. References that several runs share come
 * once.
 */
export async function loadCurves(app: App, keys: string[], runs: Run[]): Promise<Curve[]> {
  const loading: Promise<Curve>[] = [];
  const seen = new Set<string>();
  for (const key of keys) {
    for (const run of runs) {
      for (const table of run.tables) {
        const column = table.columns.find((c) => columnKey(table.name, c.label) === key);
        if (!column) continue;
        loading.push(columnCurve(app, run, table, column));
        for (const reference of run.references) {
          const name = `${key}\n${reference.name}\n${reference.source}`;
          if (columnKey(reference.table, reference.column) !== key || seen.has(name)) continue;
          seen.add(name);
          loading.push(referenceCurve(app, run, reference, column));
        }
      }
    }
  }
  return Promise.all(loading);
}

/** Row whose time is nearest; -1 for an empty curve. Times ascend. */
export function nearestRow(x: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = x.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (x[middle] <= time) low = middle;
    else high = middle;
  }
  if (high < 0) return -1;
  if (time >= x[high]) return high;
  return Math.abs(x[low] - time) <= Math.abs(x[high] - time) ? low : high;
}
