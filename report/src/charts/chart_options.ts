// What a chart is asked to show, and what it says about that in words.
import { withUnit } from "../units";
import type { Curve } from "./curves";
import type { ColourBy } from "./style";

export interface ChartOptions {
  title: string;
  isLogX: boolean;
  isLogY: boolean;
  colourBy: ColourBy | "auto";
  /** Curves to draw; by default the chosen columns of all runs that are shown. */
  load?: () => Promise<Curve[]>;
  xName?: string;
  xUnit?: string;
  xNames?: string[] | null;
  hasRoomX?: boolean;
  yName?: string;
}

export function xTextOf({ xName = "time", xUnit = "s", xNames }: ChartOptions, x: number): string {
  return `${xName} ${xNames ? (xNames[x] ?? "") : withUnit(x, xUnit, 6)}`;
}

/** What is not in the picture. */
export function hintOf(curves: Curve[], isLogY: boolean): string {
  if (curves.length === 0) return "Choose curves.";
  const log = isLogY ? "Zero and negative values have no place on a logarithmic axis. " : "";
  const thinned = [...new Set(curves.map(({ note }) => note))].filter(Boolean).join(", ");
  return log + (thinned && `Rows in this page: ${thinned}, extremes kept.`);
}
