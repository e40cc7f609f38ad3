// What the gauges come to over the whole run: peaks, impulses, arrivals, decays.
import type { App, Section } from "../app";
import { csv, save } from "../charts/save";
import { button, element, field, select, setChoices, stackedTable } from "../dom";
import type { Run } from "../format";
import { makeSection, onlyChanged, setVisible } from "../section";
import { SortedTable, type SortedColumn } from "../sorted_table";
import { formatNumber, withUnit, words } from "../units";
import {
  csvRows,
  matches,
  measuresThere,
  rowsOfOne,
  rowsOfSeveral,
  type MeasureName,
  type MeasureRow,
} from "./rows";

/** More rows than this are read by nobody; the filter finds the others. */
const MOST_ROWS = 300;

/** Runs whose curves are drawn over each other stand beside each other here too. */
function runsOf(app: App): Run[] {
  const { shown, run } = app;
  const runs = shown.length > 0 || !run ? shown : [run];
  return runs.filter(({ measures }) => measures.length > 0);
}

function columnsOf(heads: string[]): SortedColumn<MeasureRow>[] {
  const name: SortedColumn<MeasureRow> = {
    label: "gauge",
    isNumeric: false,
    value: ({ gauge, column }) => `${gauge} ${column}`,
    content: ({ gauge, column }) =>
      element("span", {}, element("strong", {}, gauge), ` ${words(column)}`),
  };
  const numbers = heads.map((label, i) => ({
    label,
    isNumeric: true,
    value: ({ cells }: MeasureRow) => cells[i].value,
    content: ({ cells }: MeasureRow) => {
      const { value, unit } = cells[i];
      const title = value === null ? {} : { title: `${value} ${unit}` };
      return element("span", { attributes: title }, withUnit(value, unit, 5));
    },
  }));
  return [name, ...numbers];
}

/** Of the peaks along lines with the distance. */
function decays(runs: Run[]): HTMLElement[] {
  const several = runs.length > 1;
  const rows = runs.flatMap((run) =>
    run.decays.map(({ gauge, exponent, points, scatter }) => [
      element("strong", {}, gauge),
      ...(several ? [run.title || run.name] : []),
      formatNumber(exponent, 4),
      formatNumber(points, 6),
      formatNumber(scatter, 3),
    ]),
  );
  if (rows.length === 0) return [];
  const heads = ["Gauge", ...(several ? ["Run"] : []), "Exponent", "Points", "Scatter"];
  const first = several ? 2 : 1;
  return [
    element("h3", {}, "Decay of the peaks with distance"),
    stackedTable("Decay of the peaks", heads, rows, [first, first + 1, first + 2]),
  ];
}

function unseen(runs: Run[]): string {
  const names = runs.flatMap((run) => run.measures.filter((m) => !m.seen).map((m) => m.gauge));
  return names.length > 0 ? `Have seen nothing: ${[...new Set(names)].join(", ")}.` : "";
}

class Measures {
  readonly table = new SortedTable<MeasureRow>("Measures of the gauges");
  readonly below = element("div");
  readonly hint = element("p", { class: "hint", attributes: { role: "status" } });
  readonly search = element("input", {
    attributes: { type: "search", placeholder: "gauge or quantity" },
  });
  readonly measure = select("Measure", [], "", (name) => {
    this.chosen = name as MeasureName;
    this.draw();
  });
  readonly choosing = field("Measure", this.measure);
  private chosen: MeasureName = "largest";

  constructor(private readonly app: App) {
    this.search.addEventListener("input", () => this.draw());
  }

  draw(): void {
    const runs = runsOf(this.app);
    const names = measuresThere(runs);
    if (!names.includes(this.chosen)) this.chosen = names[0] ?? "largest";
    this.choosing.hidden = runs.length < 2;
    const choices = names.map((value) => ({ value, text: words(value) }));
    if (document.activeElement !== this.measure) setChoices(this.measure, choices, this.chosen);
    const heads = runs.length === 1 ? names.map(words) : runs.map((run) => run.title || run.name);
    const all = runs.length === 1 ? rowsOfOne(runs[0], names) : rowsOfSeveral(runs, this.chosen);
    const wanted = this.search.value.trim();
    const found = all.filter(({ gauge, column }) => matches(gauge, column, wanted));
    this.table.show(columnsOf(heads), found.slice(0, MOST_ROWS));
    const count = Math.min(found.length, MOST_ROWS);
    const shown = count < all.length ? `${count} of ${all.length} rows. ` : "";
    this.hint.textContent = shown + unseen(runs);
    this.below.replaceChildren(...decays(runs));
  }
}

export function measuresSection(app: App): Section {
  const measures = new Measures(app);
  const file = button(
    "CSV",
    () => save("measures.csv", csv(csvRows(runsOf(app)))),
    "save all measures of these runs as CSV",
  );
  const section = makeSection(
    "measures",
    "Measures",
    element(
      "div",
      { class: "controls" },
      field("Filter", measures.search),
      measures.choosing,
      file,
    ),
    measures.table.root,
    measures.hint,
    measures.below,
  );
  const update = onlyChanged(
    () => runsOf(app).map((run) => [run.name, run.title, run.measures, run.decays]),
    () => {
      setVisible(section, runsOf(app).length > 0);
      measures.draw();
    },
  );
  app.on(["data", "run", "shown"], update);
  update();
  return section;
}
