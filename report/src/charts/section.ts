// Curves of gauges and sums: several charts, each with its own choice of columns.
import type { App, Section } from "../app";
import { button, checkbox, element, select, toggle } from "../dom";
import { makeSection, setVisible } from "../section";
import { Chart } from "./chart";
import { Chooser } from "./chooser";
import { availableColumns } from "./curves";
import { firstChoice, titleOf, type Choice } from "./first_choice";
import { seriesColour, type ColourBy } from "./style";

interface Panel {
  chart: Chart;
  chooser: Chooser;
}

class Charts {
  readonly list = element("div", { class: "charts" });
  private readonly panels: Panel[] = [];
  private hasChosen = false;
  readonly adding = button("Add a chart", () => this.add({ title: "New chart", keys: [] }));

  constructor(private readonly app: App) {}

  /** The first data decide what is shown at first; later only the reader does. */
  update(): void {
    const columns = availableColumns(this.app.report.runs);
    if (!this.hasChosen && columns.length > 0) {
      this.hasChosen = true;
      for (const choice of firstChoice(this.app.shown)) this.add(choice);
      if (this.panels.length === 0) this.add({ title: "Curves", keys: [columns[0].key] });
    }
    for (const { chart, chooser } of this.panels) {
      chooser.update(columns, chart.keys);
      void chart.refresh();
    }
  }

  add(choice: Choice): void {
    const chart = new Chart(this.app, new Set(choice.keys), {
      title: choice.title,
      isLogX: false,
      isLogY: false,
      colourBy: "auto",
    });
    const chooser = new Chooser([], chart.keys, () => {
      chart.title = this.titleFor(chart.keys);
      void chart.refresh();
    });
    const panel = { chart, chooser };
    chooser.root.hidden = choice.keys.length > 0;
    chart.tools.prepend(...this.tools(panel));
    chart.tools.append(button("×", () => this.remove(panel), "remove this chart"));
    chart.root.insertBefore(chooser.root, chart.root.children[1]);
    this.panels.push(panel);
    this.list.append(chart.root);
    chooser.update(availableColumns(this.app.report.runs), chart.keys);
    void chart.refresh();
  }

  redraw(): void {
    for (const { chart } of this.panels) chart.redraw();
  }

  markMoved(): void {
    for (const { chart } of this.panels) chart.markMoved();
  }

  private titleFor(keys: Set<string>): string {
    const title = titleOf(
      availableColumns(this.app.report.runs).filter(({ key }) => keys.has(key)),
    );
    return title.charAt(0).toUpperCase() + title.slice(1);
  }

  private tools({ chart, chooser }: Panel): HTMLElement[] {
    const { options } = chart;
    const choosing = toggle("Choose curves", !chooser.root.hidden, (isOpen) => {
      chooser.root.hidden = !isOpen;
    });
    const set = (change: Partial<typeof options>) => {
      Object.assign(options, change);
      void chart.refresh();
    };
    const logs = [
      toggle("log x", false, (isLogX) => set({ isLogX }), "logarithmic time axis"),
      toggle("log y", false, (isLogY) => set({ isLogY }), "logarithmic value axis"),
    ];
    if (this.app.report.runs.length < 2) return [choosing, ...logs];
    const choices = [
      { value: "auto", text: "colour by run" },
      { value: "curve", text: "colour by curve" },
    ];
    return [
      choosing,
      ...logs,
      select("Colour by", choices, "auto", (value) =>
        set({ colourBy: value as ColourBy | "auto" }),
      ),
    ];
  }

  private remove(panel: Panel): void {
    this.panels.splice(this.panels.indexOf(panel), 1);
    panel.chart.root.remove();
    this.adding.focus();
  }
}

/** Which runs are drawn over each other. */
function overlayChoice(app: App): HTMLElement {
  const list = element("fieldset", { class: "overlay" });
  const draw = () => {
    const { runs } = app.report;
    list.hidden = runs.length < 2;
    const boxes = runs.map((run, i) => {
      const box = checkbox(run.title || run.name, app.isShown(run), (isShown) =>
        app.show([run.name], isShown),
      );
      box.style.setProperty("--run-colour", seriesColour(i));
      return box;
    });
    if (!list.contains(document.activeElement))
      list.replaceChildren(element("legend", {}, "Runs drawn"), ...boxes);
  };
  app.on(["data", "shown", "theme"], draw);
  draw();
  return list;
}

export function chartsSection(app: App): Section {
  const charts = new Charts(app);
  const help = element(
    "p",
    { class: "hint" },
    "Drag to zoom, double click to see all. Click a chart, or hold Ctrl, to zoom with the wheel. Keys: ← → read, + − zoom, 0 all.",
  );
  const section = makeSection(
    "curves",
    "Curves",
    overlayChoice(app),
    charts.list,
    element("div", { class: "controls" }, charts.adding),
    help,
  );
  const update = () => {
    setVisible(section, availableColumns(app.report.runs).length > 0);
    charts.update();
  };
  app.on(["data", "shown"], update);
  app.on(["theme"], () => charts.redraw());
  app.on(["time"], () => charts.markMoved());
  update();
  return section;
}
