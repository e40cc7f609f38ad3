// The energy balance in time: what is held, what was booked, and what the balance has drifted.
import type { App, Section } from "../app";
import { Chart } from "../charts/chart";
import type { Curve } from "../charts/curves";
import { element, select } from "../dom";
import { makeSection, setVisible } from "../section";
import { formatNumber, withUnit } from "../units";
import { changeOf, hasEnergy, largestChange, loadTerms, stacked, type Terms } from "./terms";

type Mode = "change" | "value" | "stacked";

function curvesOf(terms: Terms, mode: Mode): Curve[] {
  if (mode === "stacked") return stacked(terms.held);
  const all = [...terms.held, ...(terms.total ? [terms.total] : []), ...terms.booked];
  return mode === "change" ? all.map(changeOf) : all;
}

function verdict(terms: Terms): string {
  const { balance } = terms;
  if (!balance || balance.y.length === 0) return "The sums hold no balance.";
  const drift = changeOf(balance);
  const last = drift.y[drift.y.length - 1];
  const exchanged = largestChange([...terms.held, ...terms.booked]);
  const share =
    exchanged > 0
      ? `, ${formatNumber((100 * last) / exchanged, 3)}\u00a0% of the largest change of any term (${withUnit(exchanged, balance.unit, 3)})`
      : "";
  return `Drift of the balance at the end: ${withUnit(last, balance.unit, 4)}${share}. Largest on the way: ${withUnit(largestChange([balance]), balance.unit, 4)}.`;
}

export function energySection(app: App): Section {
  let mode: Mode = "change";
  let terms: Promise<Terms> | null = null;
  const load = () => {
    const run = app.run;
    terms ??= run ? loadTerms(app, run) : null;
    return terms ?? Promise.resolve({ held: [], booked: [], total: null, balance: null });
  };
  const common = { isLogX: false, isLogY: false, colourBy: "curve" as const };
  const balance = new Chart(app, new Set(), {
    ...common,
    title: "Energy",
    yName: "energy",
    load: async () => curvesOf(await load(), mode),
  });
  const drift = new Chart(app, new Set(), {
    ...common,
    title: "Drift of the balance",
    load: async () => {
      const found = (await load()).balance;
      return found ? [{ ...changeOf(found), label: "drift", quantity: "drift" }] : [];
    },
  });
  const choices = [
    { value: "change", text: "change since the start" },
    { value: "value", text: "values" },
    { value: "stacked", text: "held, stacked" },
  ];
  balance.tools.prepend(
    select("What the energy chart shows", choices, mode, (value) => {
      mode = value as Mode;
      void balance.refresh();
    }),
  );
  const summary = element("p", { class: "summary" });
  const section = makeSection(
    "energy",
    "Energy balance",
    summary,
    element("div", { class: "charts" }, balance.root, drift.root),
  );
  const update = () => {
    const run = app.run;
    setVisible(section, run !== null && hasEnergy(run));
    terms = null;
    if (section.root.hidden) return;
    void balance.refresh();
    void drift.refresh();
    load().then(
      (found) => (summary.textContent = verdict(found)),
      () => (summary.textContent = ""),
    );
  };
  app.on(["data", "run"], update);
  app.on(["theme"], () => [balance, drift].forEach((chart) => chart.redraw()));
  app.on(["time"], () => [balance, drift].forEach((chart) => chart.markMoved()));
  update();
  return section;
}
