// The table of members: sortable, with boxes that draw the curves of a member over each other.
import type { App } from "../app";
import { element, scroller } from "../dom";
import type { Member, Sweep } from "../format";
import { displayUnit, formatNumber, withUnit, type DisplayUnit } from "../units";
import { sorted, sweepColumns, type SweepColumn } from "./rows";

export class MembersTable {
  readonly root: HTMLElement;
  private readonly body = element("tbody");
  private readonly head = element("tr");
  private readonly boxes = new Map<string, HTMLInputElement>();
  private sortedBy = 0;
  private isAscending = true;

  constructor(
    private readonly app: App,
    private sweep: Sweep,
  ) {
    const caption = element("caption", { class: "unseen" }, "Members of the sweep");
    this.root = scroller(
      "Members of the sweep",
      element("table", {}, caption, element("thead", {}, this.head), this.body),
    );
    this.drawHead();
    this.draw();
  }

  update(sweep: Sweep): void {
    this.sweep = sweep;
    this.drawHead();
    this.draw();
  }

  private get columns(): SweepColumn[] {
    return sweepColumns(this.sweep);
  }

  private drawHead(): void {
    const cells = this.columns.map((column, i) => {
      const { unit } = this.unitOf(column);
      const text = unit ? `${column.label} [${unit}]` : column.label;
      const mark = element(
        "span",
        { attributes: { "aria-hidden": "true" } },
        i === this.sortedBy ? (this.isAscending ? " ▲" : " ▼") : "",
      );
      const sorting = element(
        "button",
        { attributes: { type: "button" }, on: { click: () => this.sortBy(i) } },
        text,
        mark,
      );
      const cell = element("th", { attributes: { scope: "col" } }, sorting);
      if (this.isNumeric(i)) cell.className = "number";
      if (i === this.sortedBy)
        cell.setAttribute("aria-sort", this.isAscending ? "ascending" : "descending");
      return cell;
    });
    this.head.replaceChildren(element("th", { attributes: { scope: "col" } }, "Curves"), ...cells);
  }

  /** One for the whole column, by its largest number: cells can be compared. */
  private unitOf({ unit, cell }: SweepColumn): DisplayUnit {
    const sizes = this.sweep.members.map(cell).filter((value) => typeof value === "number");
    return displayUnit(unit, Math.max(0, ...sizes.map(Math.abs)));
  }

  private isNumeric(column: number): boolean {
    const { cell } = this.columns[column];
    return column > 0 && this.sweep.members.some((member) => typeof cell(member) === "number");
  }

  private sortBy(column: number): void {
    this.isAscending = column === this.sortedBy ? !this.isAscending : true;
    this.sortedBy = column;
    this.drawHead();
    this.draw();
    this.head.querySelectorAll("button")[column]?.focus();
  }

  /** Other curves have been chosen, here or elsewhere; the boxes stay, and with them the focus. */
  syncBoxes(): void {
    for (const [name, box] of this.boxes)
      box.checked = this.app.shown.some((run) => run.name === name);
  }

  draw(): void {
    this.boxes.clear();
    const rows = sorted(this.sweep.members, this.columns[this.sortedBy], this.isAscending).map(
      (member) => this.row(member),
    );
    this.body.replaceChildren(...rows);
  }

  private row(member: Member): HTMLElement {
    const cells = this.columns.map((column, i) => {
      const value = column.cell(member);
      const shown = (number: number) => formatNumber(number / this.unitOf(column).factor, 6);
      const text = typeof value === "number" ? shown(value) : (value ?? "–");
      const cell = element("td", this.isNumeric(i) ? { class: "number" } : {}, text);
      if (typeof value === "number" && column.unit) cell.title = withUnit(value, column.unit, 6);
      if (column.label === "message") cell.className = "message";
      return cell;
    });
    return element("tr", {}, element("td", {}, this.box(member)), ...cells);
  }

  private box(member: Member): HTMLElement | string {
    const run = member.run === null ? undefined : this.app.report.runs[member.run];
    if (!run) return "–";
    const box = element("input", {
      attributes: { type: "checkbox", "aria-label": `draw the curves of ${member.name}` },
    });
    this.boxes.set(run.name, box);
    box.checked = this.app.isShown(run);
    box.addEventListener("change", () => {
      this.app.show([run.name], box.checked);
      if (box.checked) this.app.choose(run.name);
    });
    return box;
  }
}
