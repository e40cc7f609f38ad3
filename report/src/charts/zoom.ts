// What a chart zooms to: all of its curves, or what has been dragged over.
import type uPlot from "uplot";
import { unionOfTimes } from "./align";
import type { Limits, Zoom } from "./axes";
import type { Curve } from "./curves";
import { limitsOfX, yScale } from "./plot";

/** A drag of fewer pixels was a click. */
const LEAST_PIXELS = 3;

export function wholeOf(curves: Curve[], isLogX: boolean, hasRoom: boolean): Limits {
  const times = unionOfTimes(curves).filter((t) => !isLogX || t > 0);
  return limitsOfX(times, isLogX, hasRoom);
}

/** Limits of the selection of a plot, beside those that stay; null where nothing was selected. */
export function zoomOfSelection(plot: uPlot, curves: Curve[], before: Zoom): Zoom | null {
  const { left, top, width, height } = plot.select;
  if (width < LEAST_PIXELS && height < LEAST_PIXELS) return null;
  const zoom: Zoom = { ...before };
  if (width >= LEAST_PIXELS && width < plot.over.clientWidth - 1)
    zoom.x = [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")];
  if (height >= LEAST_PIXELS && height < plot.over.clientHeight - 1) {
    for (const unit of new Set(curves.map((curve) => curve.unit))) {
      const scale = yScale(unit);
      zoom[scale] = [plot.posToVal(top + height, scale), plot.posToVal(top, scale)];
    }
  }
  return zoom;
}
