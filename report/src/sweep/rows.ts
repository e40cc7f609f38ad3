// The members of a sweep as rows of cells, in the order that the reader wants.
import type { Member, Sweep } from "../format";

export interface SweepColumn {
  label: string;
  unit: string;
  cell(member: Member): number | string | null;
}

export function sweepColumns(sweep: Sweep): SweepColumn[] {
  return [
    { label: "member", unit: "", cell: (member) => member.name },
    ...sweep.parameters.map((p, i) => ({
      ...p,
      cell: (member: Member) => member.values[i] ?? null,
    })),
    ...sweep.outputs.map((p, i) => ({ ...p, cell: (member: Member) => member.outputs[i] ?? null })),
    { label: "state", unit: "", cell: (member) => member.state },
    { label: "message", unit: "", cell: (member) => member.message },
  ];
}

/** Numbers before texts, what is missing last in either direction. */
function compare(a: number | string | null, b: number | string | null, sign: number): number {
  if (a === null || b === null) return Number(a === null) - Number(b === null);
  if (typeof a === "number" && typeof b === "number") return sign * (a - b);
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return sign * compareTexts(String(a), String(b));
}

/** Numbers within texts by their size: "mesh-0.005" before "mesh-0.02", "run 9" before "run 10". */
function compareTexts(a: string, b: string): number {
  const parts = (text: string) => text.match(/\d+(\.\d+)?|\D+/g) ?? [];
  const [inA, inB] = [parts(a), parts(b)];
  for (let i = 0; i < Math.min(inA.length, inB.length); ++i) {
    const difference = Number(inA[i]) - Number(inB[i]);
    const order = Number.isNaN(difference) ? inA[i].localeCompare(inB[i]) : difference;
    if (order !== 0) return order;
  }
  return inA.length - inB.length;
}

export function sorted(members: Member[], column: SweepColumn, isAscending: boolean): Member[] {
  const sign = isAscending ? 1 : -1;
  return [...members].sort((a, b) => compare(column.cell(a), column.cell(b), sign));
}
