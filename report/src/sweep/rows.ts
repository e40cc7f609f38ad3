// The members of a sweep as rows of cells, in the order that the reader wants.
import type { Member, Sweep } from "../format";
import { sortRows } from "../sorted_table";

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

export function sorted(members: Member[], column: SweepColumn, isAscending: boolean): Member[] {
  return sortRows(members, (member) => column.cell(member), isAscending);
}
