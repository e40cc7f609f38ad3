// Where the computing time went, and the stages of the run.
import type { App, Section } from "../app";
import { element, table } from "../dom";
import { makeSection, onlyChanged, setVisible } from "../section";
import { duration, formatNumber, withUnit } from "../units";

export function timingSection(app: App): Section {
  const content = element("div");
  const section = makeSection("timing", "Computing time", content);
  const draw = () => {
    const timing = [...(app.run?.timing ?? [])].sort((a, b) => b.seconds - a.seconds);
    const total = timing.reduce((sum, row) => sum + row.seconds, 0);
    setVisible(section, timing.length > 0);
    const rows = timing.map((row) => {
      const share = total > 0 ? row.seconds / total : 0;
      const bar = element("span", { class: "bar", attributes: { "aria-hidden": "true" } });
      bar.style.setProperty("--share", String(share));
      return [
        row.label,
        bar,
        `${(100 * share).toFixed(1)}\u00a0%`,
        duration(row.seconds),
        formatNumber(row.calls, 9),
      ];
    });
    content.replaceChildren(
      element("p", { class: "hint" }, `${duration(total)} in all`),
      table(
        "Where the computing time went",
        ["Part", "", "Share", "Time", "Calls"],
        rows,
        [2, 3, 4],
      ),
    );
  };
  const update = onlyChanged(() => app.run?.timing, draw);
  app.on(["data", "run"], update);
  update();
  return section;
}

export function stagesSection(app: App): Section {
  const content = element("div");
  const section = makeSection("stages", "Stages", content);
  const draw = () => {
    const stages = app.run?.stages ?? [];
    setVisible(section, stages.length > 0);
    const rows = stages.map((stage) => [
      element("strong", {}, stage.name),
      withUnit(stage.time_s, "s", 5),
      formatNumber(stage.step, 9),
      stage.cause,
    ]);
    content.replaceChildren(
      table("Stages of the run", ["Stage", "From", "Step", "Cause"], rows, [1, 2]),
    );
  };
  const update = onlyChanged(() => app.run?.stages, draw);
  app.on(["data", "run"], update);
  update();
  return section;
}
