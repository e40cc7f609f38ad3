// Facts: of one run as a list, of several side by side with what differs set off.
import type { App, Section } from "../app";
import { element, table } from "../dom";
import type { Run } from "../format";
import { makeSection, onlyChanged, setVisible } from "../section";

/** Where facts are folded at first, as in the styles. */
const NARROW = "(max-width: 640px)";

const STATES: Record<Run["state"], string> = {
  ended: "ended",
  running: "running",
  stopped: "stopped early",
  broken: "broken off",
};

export function stateText(run: Run): string {
  return run.end_reason ? `${STATES[run.state]}: ${run.end_reason}` : STATES[run.state];
}

/** Check sums and the like: nobody reads them, somebody copies them. */
function valueOf(value: string): HTMLElement | string {
  if (!/^[0-9a-f]{40,}$/.test(value)) return value;
  return element(
    "details",
    { class: "long" },
    element("summary", {}, element("code", {}, `${value.slice(0, 8)}…`)),
    element("code", {}, value),
  );
}

function factsOfOne(run: Run): HTMLElement {
  const list = element("dl", { class: "facts" });
  for (const { label, value } of [{ label: "State", value: stateText(run) }, ...run.facts]) {
    list.append(element("div", {}, element("dt", {}, label), element("dd", {}, valueOf(value))));
  }
  return list;
}

function factsOfSeveral(runs: Run[]): HTMLElement {
  const labels = [...new Set(runs.flatMap((run) => run.facts.map((fact) => fact.label)))];
  const row = (label: string, values: string[]) => {
    const differs = new Set(values).size > 1;
    return [
      label,
      ...values.map((value) => (differs ? element("strong", {}, valueOf(value)) : valueOf(value))),
    ];
  };
  const rows = labels.map((label) =>
    row(
      label,
      runs.map((run) => run.facts.find((fact) => fact.label === label)?.value ?? "–"),
    ),
  );
  rows.unshift(row("State", runs.map(stateText)));
  const made = table(
    "Facts of the runs, side by side",
    ["", ...runs.map((run) => run.title || run.name)],
    rows,
  );
  made.classList.add("first-fixed");
  return made;
}

export function factsSection(app: App): Section {
  const content = element("div");
  const heading = element("summary");
  const folded = element("details", { class: "folded" }, heading, content);
  folded.open = !matchMedia(NARROW).matches;
  const section = makeSection("facts", "Facts", folded);
  const draw = () => {
    const { runs } = app.report;
    setVisible(section, runs.length > 0);
    heading.textContent = runs.length === 1 ? stateText(runs[0]) : `${runs.length} runs`;
    if (runs.length === 1) content.replaceChildren(factsOfOne(runs[0]));
    else if (runs.length > 1)
      content.replaceChildren(factsOfSeveral(app.shown.length > 0 ? app.shown : runs.slice(0, 8)));
  };
  const update = onlyChanged(
    () =>
      app.report.runs.map((run) => [
        run.name,
        run.title,
        run.facts,
        run.state,
        run.end_reason,
        app.isShown(run),
      ]),
    draw,
  );
  app.on(["data", "shown"], update);
  update();
  return section;
}
