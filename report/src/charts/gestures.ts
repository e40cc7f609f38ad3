// Zoom by wheel and two fingers, cursor by one finger and by keys.
import type uPlot from "uplot";
import type { Limits } from "./axes";

export interface Zoomable {
  plot(): uPlot | null;
  /** The whole span of x. */
  whole(): Limits;
  zoomX(limits: Limits): void;
  reset(): void;
  moveTo(row: number): void;
}

const WHEEL_STEP = 1.0015;

/** Limits scaled about a place, in logarithms for a logarithmic axis, and kept within the data. */
export function scaled(
  limits: Limits,
  about: number,
  factor: number,
  whole: Limits,
  isLog: boolean,
): Limits {
  const to = isLog ? Math.log : (v: number) => v;
  const from = isLog ? Math.exp : (v: number) => v;
  const at = to(about);
  const min = from(at - (at - to(limits[0])) * factor);
  const max = from(at + (to(limits[1]) - at) * factor);
  return [Math.max(whole[0], min), Math.min(whole[1], max)];
}

function limitsOf(plot: uPlot): Limits {
  return [plot.scales.x.min ?? 0, plot.scales.x.max ?? 1];
}

function zoomAt(chart: Zoomable, left: number, factor: number): void {
  const plot = chart.plot();
  if (!plot) return;
  const isLog = plot.scales.x.distr === 3;
  const next = scaled(limitsOf(plot), plot.posToVal(left, "x"), factor, chart.whole(), isLog);
  if (next[1] > next[0]) chart.zoomX(next);
}

/** The wheel belongs to the page until the chart has the focus, or the control key is held. */
export function addWheel(root: HTMLElement, chart: Zoomable): void {
  root.addEventListener(
    "wheel",
    (event) => {
      const plot = chart.plot();
      if (!plot || !(event.ctrlKey || root.contains(document.activeElement))) return;
      event.preventDefault();
      zoomAt(
        chart,
        event.clientX - plot.over.getBoundingClientRect().left,
        WHEEL_STEP ** event.deltaY,
      );
    },
    { passive: false },
  );
}

export function addTouch(root: HTMLElement, chart: Zoomable): void {
  const fingers = new Map<number, number>();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { middle: (a + b) / 2, width: Math.max(12, Math.abs(a - b)) };
  };
  root.addEventListener("pointerdown", (event) => {
    if (event.pointerType === "touch") fingers.set(event.pointerId, event.clientX);
  });
  root.addEventListener("pointermove", (event) => {
    const plot = chart.plot();
    if (!plot || !fingers.has(event.pointerId)) return;
    const edge = plot.over.getBoundingClientRect();
    if (fingers.size === 1)
      plot.setCursor({ left: event.clientX - edge.left, top: event.clientY - edge.top });
    const before = fingers.size === 2 ? spread() : null;
    fingers.set(event.pointerId, event.clientX);
    if (before) zoomAt(chart, spread().middle - edge.left, before.width / spread().width);
  });
  for (const end of ["pointerup", "pointercancel", "pointerleave"] as const) {
    root.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
}

function rowInView(plot: uPlot, row: number): number {
  const times = plot.data[0];
  const [min, max] = limitsOf(plot);
  let first = 0;
  let last = times.length - 1;
  while (first < last && times[first] < min) ++first;
  while (last > first && times[last] > max) --last;
  return Math.min(last, Math.max(first, row));
}

export function addKeys(root: HTMLElement, chart: Zoomable): void {
  root.addEventListener("keydown", (event) => {
    const plot = chart.plot();
    if (!plot || event.target !== root || event.altKey || event.metaKey) return;
    const row = plot.cursor.idx ?? -1;
    const step = event.shiftKey ? 10 : 1;
    const middle =
      plot.cursor.left !== undefined && plot.cursor.left >= 0
        ? plot.cursor.left
        : plot.over.clientWidth / 2;
    const actions: Record<string, () => void> = {
      ArrowLeft: () => chart.moveTo(rowInView(plot, row < 0 ? Infinity : row - step)),
      ArrowRight: () => chart.moveTo(rowInView(plot, row < 0 ? 0 : row + step)),
      Home: () => chart.moveTo(rowInView(plot, 0)),
      End: () => chart.moveTo(rowInView(plot, Infinity)),
      "+": () => zoomAt(chart, middle, 0.7),
      "-": () => zoomAt(chart, middle, 1 / 0.7),
      "0": () => chart.reset(),
      Escape: () => chart.reset(),
    };
    const action = actions[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  });
}
