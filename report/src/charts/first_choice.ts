// What the charts show when the page opens: one chart for each quantity that several gauges
// measure.
import type { Run } from "../format";
import { words } from "../units";
import { availableColumns, columnKey, type Available } from "./curves";

const CHARTS_AT_FIRST = 3;
const CURVES_AT_FIRST = 6;

export interface Choice {
  title: string;
  keys: string[];
}

export function titleOf(columns: Available[]): string {
  const unique = (names: string[]) => [...new Set(names.filter(Boolean))];
  const quantities = unique(columns.map(({ column }) => words(column.name || column.label)));
  const gauges = unique(columns.map(({ column }) => column.gauge));
  const list = (names: string[]) =>
    names.length > 4
      ? `${names.slice(0, 3).join(", ")} and ${names.length - 3} more`
      : names.join(", ");
  const what = list(quantities) || "no curves";
  return gauges.length > 0 ? `${what} at ${list(gauges)}` : what;
}

function choice(columns: Available[], runs: number): Choice {
  const chosen = columns.slice(0, Math.max(1, Math.floor(CURVES_AT_FIRST / runs)));
  const title = titleOf(chosen);
  return {
    title: title.charAt(0).toUpperCase() + title.slice(1),
    keys: chosen.map(({ key }) => key),
  };
}

/** Curves with measured ones beside them come first: they are what a reader looks for. */
export function firstChoice(runs: Run[]): Choice[] {
  const references = new Set(
    runs.flatMap((run) => run.references.map((r) => columnKey(r.table, r.column))),
  );
  const quantities = new Map<string, Available[]>();
  for (const entry of availableColumns(runs)) {
    const { gauge, name, unit, group } = entry.column;
    const key = gauge ? `${name}\n${unit}` : `${entry.table}\n${group}`;
    if (!gauge && group !== "step") continue;
    quantities.set(key, [...(quantities.get(key) ?? []), entry]);
  }
  const hasReference = (list: Available[]) => list.some(({ key }) => references.has(key));
  const lists = [...quantities.values()].map((list) =>
    [...list].sort((a, b) => Number(references.has(b.key)) - Number(references.has(a.key))),
  );
  const ordered = [...lists.filter(hasReference), ...lists.filter((list) => !hasReference(list))];
  const gauges = ordered.filter((list) => list[0].column.gauge !== "");
  return (gauges.length > 0 ? gauges : ordered)
    .slice(0, CHARTS_AT_FIRST)
    .map((list) => choice(list, runs.length));
}
