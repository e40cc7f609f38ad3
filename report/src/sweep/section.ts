// A sweep: its members as a table and its outputs over its parameters.
import type { App, Section } from "../app";
import { csv, save } from "../charts/save";
import { button, element } from "../dom";
import type { Sweep } from "../format";
import { makeSection, setVisible } from "../section";
import { SweepPlot } from "./plot";
import { sweepColumns } from "./rows";
import { MembersTable } from "./table";

function saveMembers(sweep: Sweep): void {
  const columns = sweepColumns(sweep);
  const head = columns.map(({ label, unit }) => (unit ? `${label} [${unit}]` : label));
  save(
    `${sweep.title || "sweep"}.csv`,
    csv([head, ...sweep.members.map((member) => columns.map((column) => column.cell(member)))]),
  );
}

function summaryOf(sweep: Sweep): string {
  const count = (state: string) => sweep.members.filter((member) => member.state === state).length;
  const parts = ["done", "failed", "waiting"].map((state) => `${count(state)} ${state}`);
  return `${sweep.members.length} members: ${parts.join(", ")}.`;
}

function runNames(app: App, sweep: Sweep): string[] {
  return sweep.members
    .flatMap(({ run }) => (run === null ? [] : [app.report.runs[run]?.name ?? ""]))
    .filter(Boolean);
}

export function sweepSection(app: App): Section {
  const content = element("div");
  const section = makeSection("sweep", "Sweep", content);
  let members: MembersTable | null = null;
  const plots: SweepPlot[] = [];

  const build = (sweep: Sweep) => {
    members = new MembersTable(app, sweep);
    const charts = element("div", { class: "charts" });
    const add = (output: number) => {
      const plot = new SweepPlot(app, app.report.sweep ?? sweep, output);
      plots.push(plot);
      charts.append(plot.chart.root);
    };
    const canPlot = sweep.parameters.length > 0 && sweep.outputs.length > 0;
    if (canPlot) sweep.outputs.slice(0, 2).forEach((_, i) => add(i));
    const bar = element(
      "div",
      { class: "controls" },
      button("Draw all", () => app.showOnly(runNames(app, sweep))),
      button("Draw none", () => app.showOnly([])),
      canPlot && button("Add a plot", () => add(0)),
      button("CSV", () => saveMembers(app.report.sweep ?? sweep), "save the members as CSV"),
    );
    content.replaceChildren(summary, bar, members.root, charts);
  };
  const summary = element("p", { class: "summary" });
  const update = () => {
    const { sweep } = app.report;
    setVisible(section, sweep !== null);
    if (!sweep) return;
    if (!members) build(sweep);
    members?.update(sweep);
    plots.forEach((plot) => plot.update(sweep));
    summary.textContent = summaryOf(sweep);
  };
  app.on(["data"], update);
  app.on(["shown"], () => members?.syncBoxes());
  app.on(["theme"], () => plots.forEach(({ chart }) => chart.redraw()));
  update();
  return section;
}
