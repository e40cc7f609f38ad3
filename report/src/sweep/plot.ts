// Any output of a sweep over any of its parameters, as dots or as lines.
import type { App } from "../app";
import { Chart } from "../charts/chart";
import type { Curve } from "../charts/curves";
import { select, toggle } from "../dom";
import type { Member, Sweep } from "../format";
import { formatNumber, typesetUnit } from "../units";

interface Point {
  x: number;
  y: number;
  name: string;
}

export class SweepPlot {
  readonly chart: Chart;
  private parameter = 0;
  private hasLines = false;

  constructor(
    app: App,
    private sweep: Sweep,
    private output: number,
  ) {
    this.chart = new Chart(app, new Set(), {
      title: "",
      isLogX: false,
      isLogY: false,
      colourBy: "curve",
      hasRoomX: true,
      load: () => Promise.resolve(this.curves()),
    });
    const choices = (list: { label: string }[]) =>
      list.map(({ label }, i) => ({ value: String(i), text: label }));
    const set = (change: () => void) => () => {
      change();
      this.refresh();
    };
    this.chart.tools.prepend(
      select("Output", choices(sweep.outputs), String(output), (value) =>
        set(() => (this.output = Number(value)))(),
      ),
      select("Parameter", choices(sweep.parameters), "0", (value) =>
        set(() => (this.parameter = Number(value)))(),
      ),
      toggle(
        "lines",
        false,
        (hasLines) => set(() => (this.hasLines = hasLines))(),
        "a line for each choice of the other parameters",
      ),
      toggle("log x", false, (isLogX) => set(() => (this.chart.options.isLogX = isLogX))()),
      toggle("log y", false, (isLogY) => set(() => (this.chart.options.isLogY = isLogY))()),
    );
    this.refresh();
  }

  update(sweep: Sweep): void {
    this.sweep = sweep;
    this.refresh();
  }

  private refresh(): void {
    const { options } = this.chart;
    const [parameter, output] = [
      this.sweep.parameters[this.parameter],
      this.sweep.outputs[this.output],
    ];
    this.chart.title = `${output.label} over ${parameter.label}`;
    options.xName = parameter.label;
    options.xUnit = parameter.unit;
    options.xNames = this.names();
    void this.chart.refresh();
  }

  /** Values of a parameter that is no number, in the order in which they occur. */
  private names(): string[] | null {
    const values = this.sweep.members.map((member) => member.values[this.parameter]);
    return values.every((value) => typeof value === "number")
      ? null
      : [...new Set(values.map(String))];
  }

  private curves(): Curve[] {
    const groups = new Map<string, Point[]>();
    const names = this.names();
    for (const member of this.sweep.members) {
      const y = member.outputs[this.output];
      const value = member.values[this.parameter];
      const x = names ? names.indexOf(String(value)) : Number(value);
      if (y === null || y === undefined || !Number.isFinite(x)) continue;
      const group = this.hasLines ? this.others(member) : "all members";
      groups.set(group, [...(groups.get(group) ?? []), { x, y, name: member.name }]);
    }
    return [...groups].map(([label, points]) => this.curve(label, points));
  }

  private curve(label: string, points: Point[]): Curve {
    const output = this.sweep.outputs[this.output];
    const inOrder = [...points].sort((a, b) => a.x - b.x);
    return {
      run: null,
      key: label,
      label,
      quantity: output.label,
      unit: output.unit,
      isDots: !this.hasLines,
      source: "",
      note: "",
      x: inOrder.map(({ x }) => x),
      y: inOrder.map(({ y }) => y),
      rowNames: inOrder.map(({ name }) => name),
    };
  }

  private others(member: Member): string {
    const texts = this.sweep.parameters.flatMap(({ label, unit }, i) => {
      const value = member.values[i];
      const text = typeof value === "number" ? formatNumber(value, 4) : String(value);
      return i === this.parameter ? [] : [`${label} ${text}${unit ? ` ${typesetUnit(unit)}` : ""}`];
    });
    return texts.join(", ") || this.sweep.outputs[this.output].label;
  }
}
