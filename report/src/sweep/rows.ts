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
    ...sweep.parameters.map((p, i) => ({ ...p, cell: (member: Member) => member.values[i] ?? null })),
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
  return sign * String(a).localeCompare(String(b), undefined, { numeric: true });
}

export function sorted(members: Member[], column: SweepColumn, isAscending: boolean): Member[] {
  const sign = isAscending ? 1 : -1;
  return [...members].sort((a, b) => compare(column.cell(a), column.cell(b), sign));
}
