// The terms of the energy balance: what the particles hold, what came or went through a booked way,
// the rest.
import type { App } from "../app";
import type { Curve } from "../charts/curves";
import type { Column, Run, Table } from "../format";
import { words } from "../units";

export type Role = "held" | "total" | "booked" | "balance";

/**
 * Signs with which terms enter the balance: held + lost - brought in by work and transformation.
 */
const LOST = /^lost/;
/** Held energy that the total already contains. */
const CONTAINED = /^penalty/;

export function roleOf(name: string): Role {
  if (/balance/.test(name)) return "balance";
  if (/^total/.test(name)) return "total";
  return /^(kinetic|internal|potential|penalty|elastic)/.test(name) ? "held" : "booked";
}

export interface Terms {
  held: Curve[];
  booked: Curve[];
  total: Curve | null;
  /** What should stay as it was at the start. */
  balance: Curve | null;
}

function energyTable(run: Run): { table: Table; columns: Column[] } | null {
  const table = run.tables.find((t) => t.name === "sums");
  const columns = table?.columns.filter((column) => column.group === "energy") ?? [];
  return table && columns.length > 0 ? { table, columns } : null;
}

export function hasEnergy(run: Run): boolean {
  return energyTable(run) !== null;
}

function balanceOf(held: Curve[], booked: Curve[], total: Curve | null): Curve | null {
  const parts = total ? [total] : held.filter(({ label }) => !CONTAINED.test(label));
  const model = parts[0];
  if (!model) return null;
  const y = Float64Array.from(model.x, (_, i) => {
    const inside = parts.reduce((sum, part) => sum + part.y[i], 0);
    return booked.reduce(
      (sum, part) => sum + (LOST.test(part.label) ? part.y[i] : -part.y[i]),
      inside,
    );
  });
  return { ...model, key: "balance", label: "balance", quantity: "balance", y };
}

export async function loadTerms(app: App, run: Run): Promise<Terms> {
  const found = energyTable(run);
  const terms: Terms = { held: [], booked: [], total: null, balance: null };
  if (!found) return terms;
  const x = await app.blocks.numbers(found.table.time);
  for (const column of found.columns) {
    const y = await app.blocks.numbers(column.data);
    const name = column.name || column.label;
    const curve: Curve = {
      run,
      key: column.label,
      label: words(name),
      quantity: words(name),
      unit: column.unit,
      isDots: false,
      source: "",
      note: "",
      x,
      y,
    };
    const role = roleOf(name);
    if (role === "held" || role === "booked") terms[role].push(curve);
    else terms[role] = curve;
  }
  terms.booked = terms.booked.filter(isUsed);
  terms.held = terms.held.filter(isUsed);
  terms.balance ??= balanceOf(terms.held, terms.booked, terms.total);
  return terms;
}

/** A way that nothing came through is left out. */
function isUsed(curve: Curve): boolean {
  for (let i = 0; i < curve.y.length; ++i)
    if (curve.y[i] !== 0 && !Number.isNaN(curve.y[i])) return true;
  return false;
}

/** The curve less its first value. */
export function changeOf(curve: Curve): Curve {
  const first = curve.y[0] ?? 0;
  return { ...curve, y: Float64Array.from(curve.y, (value) => value - first) };
}

/** Curves drawn upon each other; they are read as they are. */
export function stacked(curves: Curve[]): Curve[] {
  const sum = new Float64Array(curves[0]?.x.length ?? 0);
  return curves.map((curve) => {
    for (let i = 0; i < sum.length; ++i) sum[i] += Number.isNaN(curve.y[i]) ? 0 : curve.y[i];
    return { ...curve, drawn: sum.slice() };
  });
}

export function largestChange(curves: Curve[]): number {
  let largest = 0;
  for (const { y } of curves)
    for (let i = 0; i < y.length; ++i) largest = Math.max(largest, Math.abs(y[i] - y[0]) || 0);
  return largest;
}
