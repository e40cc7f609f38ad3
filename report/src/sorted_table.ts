// A table that its heads sort; the first column stays in sight while the others scroll.
import { element, scroller } from "./dom";

export type SortValue = number | string | null;

export interface SortedColumn<Row> {
  label: string;
  isNumeric: boolean;
  value(row: Row): SortValue;
  content(row: Row): Node | string;
}

export class SortedTable<Row> {
  readonly root: HTMLElement;
  private readonly head = element("tr");
  private readonly body = element("tbody");
  private columns: SortedColumn<Row>[] = [];
  private rows: Row[] = [];
  /** Head by which rows are sorted; "" for the order in which they came. */
  private sortedBy = "";
  private isAscending = true;

  constructor(caption: string) {
    const told = element("caption", { class: "unseen" }, caption);
    this.root = scroller(
      caption,
      element("table", {}, told, element("thead", {}, this.head), this.body),
    );
    this.root.classList.add("first-fixed");
  }

  show(columns: SortedColumn<Row>[], rows: Row[]): void {
    this.columns = columns;
    this.rows = rows;
    this.draw();
  }

  private draw(): void {
    const by = this.columns.find(({ label }) => label === this.sortedBy);
    this.head.replaceChildren(...this.columns.map((column) => this.headCell(column)));
    const rows = by ? sortRows(this.rows, (row) => by.value(row), this.isAscending) : this.rows;
    this.body.replaceChildren(...rows.map((row) => this.row(row)));
  }

  private headCell(column: SortedColumn<Row>): HTMLElement {
    const isBy = column.label === this.sortedBy;
    const mark = isBy ? (this.isAscending ? " ▲" : " ▼") : "";
    const sorting = element(
      "button",
      { attributes: { type: "button" }, on: { click: () => this.sortBy(column) } },
      column.label,
      element("span", { attributes: { "aria-hidden": "true" } }, mark),
    );
    const cell = element("th", { attributes: { scope: "col" } }, sorting);
    if (column.isNumeric) cell.className = "number";
    if (isBy) cell.setAttribute("aria-sort", this.isAscending ? "ascending" : "descending");
    return cell;
  }

  /** Numbers begin with the largest: that is what one looks for. */
  private sortBy({ label, isNumeric }: SortedColumn<Row>): void {
    this.isAscending = label === this.sortedBy ? !this.isAscending : !isNumeric;
    this.sortedBy = label;
    this.draw();
    const place = this.columns.findIndex((column) => column.label === label);
    this.head.querySelectorAll("button")[place]?.focus();
  }

  private row(row: Row): HTMLElement {
    const cells = this.columns.map((column) =>
      element("td", column.isNumeric ? { class: "number" } : {}, column.content(row)),
    );
    return element("tr", {}, ...cells);
  }
}

/** Numbers before texts, what is missing last in either direction. */
function compare(a: SortValue, b: SortValue, sign: number): number {
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

export function sortRows<Row>(
  rows: Row[],
  value: (row: Row) => SortValue,
  isAscending: boolean,
): Row[] {
  const sign = isAscending ? 1 : -1;
  return [...rows].sort((a, b) => compare(value(a), value(b), sign));
}
