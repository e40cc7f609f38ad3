// One chart: loads its curves, draws them, reads them, and answers mouse, fingers and keys.
import type uPlot from "uplot";
import type { App } from "../app";
import { announce, button, element } from "../dom";
import { align } from "./align";
import type { Limits, Zoom } from "./axes";
import { hintOf, xTextOf, type ChartOptions } from "./chart_options";
import { loadCurves, type Curve } from "./curves";
import { addKeys, addTouch, addWheel } from "./gestures";
import { chartPicture } from "./picture";
import { makePlot } from "./plot";
import { curveNames, makeReading, type Entry, type Reading } from "./reading";
import { rowsOfCurves } from "./rows_of_curves";
import { csv, save, savePicture } from "./save";
import { styles } from "./style";
import { wholeOf, zoomOfSelection } from "./zoom";

const SYNC_KEY = "curves";
/** Keys may be held down: only the place where they rest is announced. */
const ANNOUNCE_AFTER_MS = 250;

export class Chart {
  readonly root = element("div", { class: "chart" });
  private readonly heading = element("h3");
  private readonly area = element("div", {
    class: "plot",
    attributes: { tabindex: "0", role: "application", "aria-roledescription": "chart" },
  });
  private readonly below = element("div");
  private readonly hint = element("p", { class: "hint" });
  readonly tools = element("div", { class: "controls", attributes: { role: "group" } });
  private plot: uPlot | null = null;
  private curves: Curve[] = [];
  private entries: Entry[] = [];
  private reading: Reading | null = null;
  private zoom: Zoom = {};
  private hidden = new Set<string>();
  private turn = 0;
  private isHeld = false;
  private hasNews = false;
  private announcing = 0;
  private drawnWidth = 0;

  constructor(
    private readonly app: App,
    readonly keys: Set<string>,
    readonly options: ChartOptions,
  ) {
    const files = [
      button("CSV", () => this.saveCsv(), "save the shown columns as CSV"),
      button("PNG", () => this.savePng(), "save as a picture"),
    ];
    this.tools.append(
      button("Reset zoom", () => this.resetZoom()),
      ...files,
    );
    this.root.append(
      element("div", { class: "chart-head" }, this.heading, this.tools),
      this.area,
      this.below,
      this.hint,
    );
    const zoomable = {
      plot: () => this.plot,
      whole: () => this.whole(),
      zoomX: (limits: Limits) => this.zoomTo({ ...this.zoom, x: limits }),
      reset: () => this.resetZoom(),
      moveTo: (row: number) => this.moveTo(row),
    };
    addWheel(this.area, zoomable);
    addTouch(this.area, zoomable);
    addKeys(this.area, zoomable);
    new ResizeObserver(() => this.fit()).observe(this.area);
    this.area.addEventListener("pointerdown", () => (this.isHeld = true));
    for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => this.letGo());
  }

  private letGo(): void {
    this.isHeld = false;
    if (!this.hasNews) return;
    this.hasNews = false;
    void this.refresh();
  }

  private get isOverTime(): boolean {
    return this.options.xName === undefined;
  }

  /** Loads and draws anew; zoom, cursor and hidden curves stay. What is being dragged comes first. */
  async refresh(): Promise<void> {
    if (this.isHeld) {
      this.hasNews = true;
      return;
    }
    const turn = ++this.turn;
    const load = this.options.load ?? (() => loadCurves(this.app, [...this.keys], this.app.shown));
    try {
      const curves = await load();
      if (turn !== this.turn) return;
      this.curves = curves;
      this.draw();
    } catch (error) {
      this.below.replaceChildren(
        element("p", { class: "problem" }, `These curves cannot be read: ${String(error)}`),
      );
    }
  }

  redraw(): void {
    if (this.curves.length > 0) this.draw();
  }

  /** The line of the player's time has moved. */
  markMoved(): void {
    this.plot?.redraw(false);
  }

  get title(): string {
    return this.options.title;
  }

  set title(text: string) {
    this.options.title = text;
    this.heading.textContent = text;
    this.tools.setAttribute("aria-label", text);
  }

  private draw(): void {
    this.title = this.options.title;
    const { app, curves, options } = this;
    const runs = new Set(curves.map((curve) => curve.run));
    const hasSeveralRuns = runs.size > 1;
    const by = options.colourBy === "auto" ? (hasSeveralRuns ? "run" : "curve") : options.colourBy;
    const styleOf = styles(curves, app.report.runs, by);
    const names = curveNames(curves);
    this.entries = curves.map((curve, i) => ({
      name: names[i],
      curve,
      style: styleOf[i],
    }));
    const before = this.plot?.cursor.left ?? -1;
    this.plot?.destroy();
    this.drawnWidth = this.area.clientWidth;
    this.reading = makeReading(
      this.entries,
      (x) => xTextOf(options, x),
      (i) => this.toggle(i),
    );
    this.plot = makePlot(
      {
        curves,
        styles: styleOf,
        data: align(curves, options.isLogX, options.isLogY),
        xName: options.xName ?? "time",
        xUnit: options.xUnit ?? "s",
        isLogX: options.isLogX,
        isLogY: options.isLogY,
        xNames: options.xNames ?? null,
        hasRoomX: options.hasRoomX ?? false,
        yName: options.yName ?? "",
        width: Math.max(240, this.drawnWidth),
        height: this.height(),
        zoom: this.zoom,
        mark: () => (this.isOverTime ? app.playerTime : null),
        moved: () => this.moved(),
        select: (plot) => this.selected(plot),
        reset: () => this.resetZoom(),
        syncKey: this.isOverTime ? SYNC_KEY : null,
      },
      this.area,
    );
    this.area.setAttribute(
      "aria-label",
      `${options.title}: ${this.entries.map((entry) => entry.name).join(", ")}. Left and right move the cursor, plus and minus zoom, zero shows all.`,
    );
    this.below.replaceChildren(this.reading.root);
    this.entries.forEach((entry, i) => this.hidden.has(entry.name) && this.hide(i));
    if (before >= 0) this.plot.setCursor({ left: before, top: 10 });
    else this.reading.show(null);
    this.hint.textContent = hintOf(curves, options.isLogY);
  }

  private height(): number {
    return this.area.clientWidth < 500 ? 250 : 300;
  }

  private fit(): void {
    const width = this.area.clientWidth;
    if (!this.plot || width === 0 || Math.abs(width - this.drawnWidth) < 1) return;
    this.drawnWidth = width;
    this.plot.setSize({ width: Math.max(240, width), height: this.height() });
  }

  private whole(): Limits {
    return wholeOf(this.curves, this.options.isLogX, this.options.hasRoomX ?? false);
  }

  private zoomTo(zoom: Zoom): void {
    for (const key of Object.keys(this.zoom)) delete this.zoom[key];
    Object.assign(this.zoom, zoom);
    if (!this.plot) return;
    const [min, max] = this.zoom.x ?? this.whole();
    this.plot.setScale("x", { min, max });
  }

  private resetZoom(): void {
    this.zoomTo({});
  }

  private selected(plot: uPlot): void {
    const zoom = zoomOfSelection(plot, this.curves, this.zoom);
    if (!zoom) return;
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.zoomTo(zoom);
  }

  private moved(): void {
    const plot = this.plot;
    if (!plot || !this.reading) return;
    const row = plot.cursor.idx;
    const isInside = row !== null && row !== undefined && (plot.cursor.left ?? -1) >= 0;
    this.reading.show(isInside ? plot.data[0][row] : null);
  }

  private moveTo(row: number): void {
    const plot = this.plot;
    if (!plot) return;
    const left = plot.valToPos(plot.data[0][row], "x");
    plot.setCursor({ left, top: plot.over.clientHeight / 2 });
    clearTimeout(this.announcing);
    this.announcing = window.setTimeout(
      () => announce(this.reading?.text() ?? ""),
      ANNOUNCE_AFTER_MS,
    );
  }

  private hide(index: number): void {
    this.plot?.setSeries(index + 1, { show: false });
    this.below.querySelectorAll(".reading button")[index]?.setAttribute("aria-pressed", "false");
  }

  private toggle(index: number): boolean {
    const { name } = this.entries[index];
    const isShown = this.hidden.delete(name);
    if (!isShown) this.hidden.add(name);
    this.plot?.setSeries(index + 1, { show: isShown });
    return isShown;
  }

  private saveCsv(): void {
    const { title, xName = "time", xUnit = "s" } = this.options;
    save(`${title}.csv`, csv(rowsOfCurves(xName, xUnit, this.curves)));
  }

  private savePng(): void {
    if (!this.plot) return;
    const shown = this.entries.filter(({ name }) => !this.hidden.has(name));
    savePicture(
      `${this.options.title}.png`,
      chartPicture(this.options.title, this.plot.ctx.canvas, shown),
    );
  }
}
