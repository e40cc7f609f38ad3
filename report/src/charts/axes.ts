// Scales and axes: one scale for each unit, ticks with SI prefixes, limits from the data in view.
import uPlot from "uplot";
import { styleColour } from "../dom";
import { displayUnit, formatTicks, typesetUnit, type DisplayUnit } from "../units";

export type Limits = [number, number];

/** Limits that the user has zoomed to, by scale; a scale without an entry follows the data. */
export type Zoom = Partial<Record<string, Limits>>;

export interface AxisPlan {
  scale: string;
  unit: string;
  name: string;
  /** In place of numbers. */
  names: string[] | null;
  isLogarithmic: boolean;
}

const FONT_SIZE = 12;
const FONT = `${FONT_SIZE}px system-ui, sans-serif`;
/** Width of a digit in that font, close enough for leaving room. */
const DIGIT_WIDTH = 6.8;

function unitInView(plot: uPlot, plan: AxisPlan): DisplayUnit {
  const { min, max } = plot.scales[plan.scale];
  const largest = Math.max(Math.abs(min ?? 0), Math.abs(max ?? 0));
  if (plan.isLogarithmic) return { factor: 1, unit: typesetUnit(plan.unit) };
  return displayUnit(plan.unit, largest);
}

function axisLabel(plot: uPlot, plan: AxisPlan): string {
  const { unit } = unitInView(plot, plan);
  return unit ? `${plan.name} [${unit}]` : plan.name;
}

export function makeAxis(plan: AxisPlan, side: uPlot.Axis.Side, hasGrid: boolean): uPlot.Axis {
  const isHorizontal = side === 2;
  const colour = styleColour("--text-soft");
  const width = (values: string[] | null) =>
    Math.max(3, ...(values ?? []).map((text) => text.length)) * DIGIT_WIDTH + 14;
  const lines = { show: true, stroke: styleColour("--grid"), width: 1 };
  return {
    scale: plan.scale,
    side,
    stroke: colour,
    font: FONT,
    labelFont: FONT,
    label: (plot: uPlot) => axisLabel(plot, plan),
    labelSize: 20,
    gap: 4,
    grid: { ...lines, show: hasGrid },
    ticks: { ...lines, size: 5 },
    size: isHorizontal ? 32 : (_: uPlot, values: string[]) => width(values),
    space: isHorizontal ? 70 : 34,
    values: (plot: uPlot, splits: number[]) =>
      plan.names
        ? splits.map((at) => plan.names?.[at] ?? "")
        : formatTicks(splits, unitInView(plot, plan).factor, plan.isLogarithmic),
  } as uPlot.Axis;
}

/**
 * What is smaller than the largest value by more than this is rounding, and would squeeze all else.
 */
const MOST_DECADES = 1e12;

/** Limits around the data; a curve that stays at one value gets some room around it. */
export function padded(min: number | null, max: number | null, isLogarithmic: boolean): Limits {
  if (min === null || max === null || !Number.isFinite(min) || !Number.isFinite(max))
    return isLogarithmic ? [1, 10] : [0, 1];
  if (isLogarithmic)
    return uPlot.rangeLog(Math.max(min, max / MOST_DECADES), max, 10, false) as Limits;
  if (min === max) {
    const room = Math.abs(min) * 0.1 || 1;
    return [min - room, max + room];
  }
  return uPlot.rangeNum(min, max, 0.08, true) as Limits;
}
