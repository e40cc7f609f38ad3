// Legend and reading in one: each curve with its value at the time of the cursor.
import { element } from "../dom";
import { displayUnit, formatNumber } from "../units";
import { nearestRow, type Curve } from "./curves";
import type { CurveStyle } from "./style";

export interface Entry {
  name: string;
  curve: Curve;
  style: CurveStyle;
}

export interface Reading {
  root: HTMLElement;
  /** Fills in the values at a time; null stands for the end of the curves. */
  show(time: number | null): void;
  /** The same in one sentence. */
  text(): string;
}

/** Names as short as they can be: run and column only where there are several of them. */
export function curveNames(curves: Curve[]): string[] {
  const lines = curves.filter((curve) => !curve.isDots);
  const hasSeveralRuns = new Set(lines.map(({ run }) => run)).size > 1;
  const hasSeveralColumns = new Set(lines.map(({ key }) => key)).size > 1;
  return curves.map(({ run, label, isDots }) => {
    if (!hasSeveralRuns || !run || isDots) return label;
    const title = run.title || run.name;
    return hasSeveralColumns ? `${label} · ${title}` : title;
  });
}

function swatch(entry: Entry): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("class", "swatch");
  svg.setAttribute("aria-hidden", "true");
  const isDot = entry.curve.isDots;
  const shape = document.createElementNS("http://www.w3.org/2000/svg", isDot ? "circle" : "line");
  const place = isDot
    ? { cx: 13, cy: 5, r: 3, fill: entry.style.isFilled ? entry.style.colour : "none" }
    : { x1: 0, y1: 5, x2: 26, y2: 5 };
  for (const [name, value] of Object.entries(place)) shape.setAttribute(name, String(value));
  shape.setAttribute("stroke", entry.style.colour);
  shape.setAttribute("stroke-width", "2");
  if (!isDot) shape.setAttribute("stroke-dasharray", entry.style.dash.join(" "));
  svg.append(shape);
  return svg;
}

function largestOf(curve: Curve): number {
  let largest = 0;
  for (let i = 0; i < curve.y.length; ++i)
    if (Math.abs(curve.y[i]) > largest) largest = Math.abs(curve.y[i]);
  return largest;
}

export function makeReading(
  entries: Entry[],
  xText: (x: number) => string,
  toggle: (index: number) => boolean,
): Reading {
  const at = element("p", { class: "at" });
  const list = element("ul", { class: "reading" });
  const units = entries.map(({ curve }) => displayUnit(curve.unit, largestOf(curve)));
  const values = entries.map((entry, index) => {
    const value = element("output", {});
    const item = element("button", {
      attributes: {
        type: "button",
        "aria-pressed": "true",
        title: "hide or show",
      },
    });
    item.addEventListener("click", () => item.setAttribute("aria-pressed", String(toggle(index))));
    item.append(swatch(entry), element("span", { class: "name" }, entry.name));
    const { source } = entry.curve;
    list.append(
      element("li", {}, item, value, source && element("span", { class: "source" }, source)),
    );
    return value;
  });
  return {
    root: element("div", { class: "readings" }, at, list),
    show(time) {
      at.textContent = time === null ? "last values" : xText(time);
      entries.forEach(({ curve }, i) => {
        const row = nearestRow(curve.x, time ?? Infinity);
        const value = row < 0 ? NaN : curve.y[row];
        const number = formatNumber(value / units[i].factor, 6);
        const rowName = curve.rowNames?.[row] ? ` · ${curve.rowNames[row]}` : "";
        values[i].textContent =
          (Number.isFinite(value) && units[i].unit ? `${number}\u00a0${units[i].unit}` : number) +
          rowName;
        const isElsewhere = row >= 0 && time !== null && curve.x[row] !== time;
        values[i].title = row < 0 ? "" : `${value} ${curve.unit} at ${curve.x[row]}`;
        values[i].classList.toggle("elsewhere", isElsewhere);
      });
    },
    text: () =>
      `${at.textContent}: ${entries.map((entry, i) => `${entry.name} ${values[i].textContent}`).join(", ")}`,
  };
}
