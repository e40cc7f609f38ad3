// Can this run be trusted: checks with their limits, comparisons with reference values, the time
// step.
import type { App, Section } from "../app";
import { element, stackedTable, table } from "../dom";
import type { Comparison, Run, Verdict, Vote } from "../format";
import { makeSection, onlyChanged, setVisible } from "../section";
import { formatNumber, withUnit } from "../units";
import { verdictMark } from "./verdict";

const VERDICTS: Verdict[] = ["good", "unknown", "doubtful", "bad"];

/** "11 good, 1 doubtful", the worst one last. */
function counted(rows: { verdict: Verdict }[]): string {
  return VERDICTS.map((verdict) => [rows.filter((row) => row.verdict === verdict).length, verdict])
    .filter(([count]) => count !== 0)
    .map(([count, verdict]) => `${count} ${verdict}`)
    .join(", ");
}

function worst(rows: { verdict: Verdict }[]): Verdict {
  const found = VERDICTS.filter((verdict) => rows.some((row) => row.verdict === verdict));
  return found[found.length - 1] ?? "unknown";
}

/** What a reader wants to know before anything else: all in one line. */
function summary(run: Run): HTMLElement {
  const parts = [
    run.quality.length > 0 && `${counted(run.quality)}.`,
    run.comparisons.length > 0 && `Beside reference values: ${counted(run.comparisons)}.`,
  ];
  return element(
    "p",
    { class: "verdicts" },
    verdictMark(worst([...run.quality, ...run.comparisons])),
    element("span", {}, parts.filter(Boolean).join(" ")),
  );
}

function checks(run: Run): HTMLElement {
  const rows = run.quality.map((row) => [
    verdictMark(row.verdict),
    element("strong", {}, row.name),
    row.value,
    row.limit,
    element("span", { class: "meaning" }, row.meaning),
  ]);
  return stackedTable(
    "Quality of the run",
    ["Verdict", "Check", "Value", "Limit", "Meaning"],
    rows,
  );
}

function deviation(row: Comparison): string {
  if (row.value === null || row.reference === 0) return "–";
  const percent = (100 * (row.value - row.reference)) / Math.abs(row.reference);
  return `${percent > 0 ? "+" : ""}${formatNumber(percent, 3)}\u00a0%`;
}

function comparisons(run: Run): HTMLElement {
  const rows = run.comparisons.map((row) => {
    const largest = Math.max(Math.abs(row.reference), Math.abs(row.value ?? 0));
    return [
      verdictMark(row.verdict),
      element("strong", {}, row.name),
      withUnit(row.value, row.unit, 4, largest),
      withUnit(row.reference, row.unit, 4, largest),
      deviation(row),
      row.tolerance === null ? "–" : `±\u00a0${withUnit(row.tolerance, row.unit, 3, largest)}`,
      element("span", { class: "meaning" }, row.source),
    ];
  });
  const head = ["Verdict", "Quantity", "This run", "Reference", "Deviation", "Tolerance", "Source"];
  return stackedTable("Comparison with reference values", head, rows, [2, 3, 4, 5]);
}

function voteBar(vote: Vote): HTMLElement {
  const bar = element("span", { class: "bar", attributes: { "aria-hidden": "true" } });
  bar.style.setProperty("--share", String(Math.min(1, Math.max(0, vote.share))));
  return bar;
}

function votes(run: Run): HTMLElement {
  const rows = [...run.votes]
    .sort((a, b) => b.share - a.share)
    .map((vote) => [
      element("strong", {}, vote.reason),
      voteBar(vote),
      `${formatNumber(100 * vote.share, 3)}\u00a0%`,
      formatNumber(vote.steps, 9),
      withUnit(vote.least_time_step_s, "s", 3),
    ]);
  const head = ["Limited by", "", "Share of steps", "Steps", "Least step"];
  return table("What limited the time step", head, rows, [2, 3, 4]);
}

export function qualitySection(app: App): Section {
  const content = element("div");
  const section = makeSection("quality", "Quality", content);
  const draw = () => {
    const run = app.run;
    content.replaceChildren();
    if (run && run.quality.length + run.comparisons.length > 0) content.append(summary(run));
    if (run?.quality.length) content.append(checks(run));
    if (run?.comparisons.length)
      content.append(element("h3", {}, "Compared with reference values"), comparisons(run));
    if (run?.votes.length)
      content.append(element("h3", {}, "What limited the time step"), votes(run));
    setVisible(section, content.childElementCount > 0);
  };
  const update = onlyChanged(() => [app.run?.quality, app.run?.comparisons, app.run?.votes], draw);
  app.on(["data", "run"], update);
  update();
  return section;
}
