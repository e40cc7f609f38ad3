// One uPlot for a list of curves.
import uPlot from "uplot";
import { styleColour } from "../dom";
import type { Aligned } from "./align";
import { makeAxis, padded, type AxisPlan, type Limits, type Zoom } from "./axes";
import type { Curve } from "./curves";
import type { CurveStyle } from "./style";

export interface PlotPlan {
  curves: Curve[];
  styles: CurveStyle[];
  data: Aligned;
  xName: string;
  xUnit: string;
  /** Names of the places 0, 1, 2 on the x axis, where it has no numbers. */
  xNames: string[] | null;
  /** Leaves room beside the first and the last x. */
  hasRoomX: boolean;
  /** Name of the y axis where the curves are of several quantities. */
  yName: string;
  isLogX: boolean;
  isLogY: boolean;
  width: number;
  height: number;
  zoom: Zoom;
  /** Time that is marked by a line. */
  mark(): number | null;
  moved(plot: uPlot): void;
  select(plot: uPlot): void;
  reset(): void;
  syncKey: string | null;
}

export function yScale(unit: string): string {
  return `y ${unit}`;
}

export function limitsOfX(x: number[], isLogX: boolean, hasRoom: boolean): Limits {
  if (x.length === 0) return isLogX ? [1, 10] : [0, 1];
  const [first, last] = [x[0], x[x.length - 1]];
  if (first >= last) return padded(first, last, isLogX);
  if (!hasRoom) return [first, last];
  const room = isLogX ? (last / first) ** 0.04 : 0.04 * (last - first);
  return isLogX ? [first / room, last * room] : [first - room, last + room];
}

function axisPlans(plan: PlotPlan): AxisPlan[] {
  const units = [...new Set(plan.curves.map((curve) => curve.unit))];
  return units.map((unit) => {
    const names = new Set(plan.curves.filter((c) => c.unit === unit).map((c) => c.quantity));
    return {
      scale: yScale(unit),
      unit,
      name: names.size === 1 ? [...names][0] : plan.yName,
      names: null,
      isLogarithmic: plan.isLogY,
    };
  });
}

function makeScales(plan: PlotPlan, axes: AxisPlan[]): uPlot.Scales {
  const scales: uPlot.Scales = {
    x: {
      time: false,
      distr: plan.isLogX ? 3 : 1,
      range: () => plan.zoom.x ?? limitsOfX(plan.data[0], plan.isLogX, plan.hasRoomX),
    },
  };
  for (const axis of axes) {
    scales[axis.scale] = {
      distr: plan.isLogY ? 3 : 1,
      range: (_plot, min, max) => plan.zoom[axis.scale] ?? padded(min, max, plan.isLogY),
    };
  }
  return scales;
}

function makeSeries(curve: Curve, style: CurveStyle): uPlot.Series {
  const common = {
    pxAlign: 0,
    label: curve.label,
    scale: yScale(curve.unit),
    stroke: style.colour,
  };
  if (curve.isDots) {
    return {
      ...common,
      paths: () => null,
      points: {
        show: true,
        size: 6,
        width: 1.5,
        stroke: style.colour,
        fill: style.isFilled ? style.colour : styleColour("--background"),
      },
    };
  }
  const fill = curve.drawn ? { fill: `${style.colour}55` } : {};
  return { ...common, ...fill, width: 1.6, dash: style.dash, points: { size: 5, space: 14 } };
}

/** Row of the nearest drawn value of a curve: its neighbours may be times of other runs. */
function nearestDrawn(plot: uPlot, series: number, row: number): number {
  const column = plot.data[series];
  for (let away = 0; away < column.length; ++away) {
    if (column[row - away] !== undefined) return row - away;
    if (column[row + away] !== undefined) return row + away;
  }
  return row;
}

function drawMark(plot: uPlot, time: number | null): void {
  if (time === null) return;
  const { left, top, width, height } = plot.bbox;
  const x = plot.valToPos(time, "x", true);
  if (x < left || x > left + width) return;
  const { ctx } = plot;
  ctx.save();
  ctx.strokeStyle = styleColour("--accent");
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(x, top);
  ctx.lineTo(x, top + height);
  ctx.stroke();
  ctx.restore();
}

export function makePlot(plan: PlotPlan, parent: HTMLElement): uPlot {
  const axes = axisPlans(plan);
  const xAxis: AxisPlan = {
    scale: "x",
    unit: plan.xUnit,
    name: plan.xName,
    names: plan.xNames,
    isLogarithmic: plan.isLogX,
  };
  const options: uPlot.Options = {
    width: plan.width,
    height: plan.height,
    scales: makeScales(plan, axes),
    axes: [
      makeAxis(xAxis, 2, true),
      ...axes.map((axis, i) => makeAxis(axis, i % 2 === 0 ? 3 : 1, i === 0)),
    ],
    series: [{}, ...plan.curves.map((curve, i) => makeSeries(curve, plan.styles[i]))],
    bands: stackBands(plan),
    legend: { show: false },
    padding: [10, axes.length > 1 ? 4 : 16, 0, 4],
    cursor: {
      drag: { x: true, y: true, uni: 24, setScale: false },
      dataIdx: (plot, series, row) => (series === 0 ? row : nearestDrawn(plot, series, row)),
      points: { size: 7 },
      bind: { dblclick: () => () => (plan.reset(), null) },
      ...(plan.syncKey
        ? {
            sync: {
              key: plan.syncKey,
              scales: ["x", null],
              setSeries: false,
              filters: { pub: isMove },
            },
          }
        : {}),
    },
    hooks: {
      setCursor: [(plot) => plan.moved(plot)],
      setSelect: [(plot) => plan.select(plot)],
      draw: [(plot) => drawMark(plot, plan.mark())],
    },
  };
  return new uPlot(options, plan.data as uPlot.AlignedData, parent);
}

/** Fills between curves that stand on each other. */
function stackBands(plan: PlotPlan): uPlot.Band[] {
  return plan.curves.flatMap((curve, i) =>
    curve.drawn && i > 0 ? [{ series: [i + 1, i], fill: `${plan.styles[i].colour}55` }] : [],
  );
}

/** Charts share the cursor, not what is dragged. */
function isMove(type: string): boolean {
  return type === "mousemove" || type === "mouseleave";
}
