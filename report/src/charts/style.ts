// Colours and dashes of curves.
import { styleColour } from "../dom";
import type { Run } from "../format";
import type { Curve } from "./curves";

export type ColourBy = "run" | "curve";

export interface CurveStyle {
  colour: string;
  dash: number[];
}

/**
 * In theme.css, after M. Okabe and K. Ito, "Color universal design" (2008), darkened or lightened
 * for contrast.
 */
export const COLOURS = 8;

/** Dashes tell apart what has the same colour, also without seeing colours. */
const DASHES = [[], [7, 4], [2, 3], [10, 3, 2, 3], [14, 5], [4, 2, 1, 2]];

export function seriesColour(index: number): string {
  return styleColour(`--series-${index % COLOURS}`);
}

/** Runs keep their colour in all charts: it goes by their place in the report. */
export function styles(curves: Curve[], runs: Run[], by: ColourBy): CurveStyle[] {
  const keys = [...new Set(curves.map((curve) => curve.key))];
  return curves.map((curve) => {
    const run = curve.run ? runs.indexOf(curve.run) : 0;
    const column = keys.indexOf(curve.key);
    const [colour, dash] = by === "run" ? [run, column] : [column, run];
    // Measured values belong to none of several runs.
    if (by === "run" && curve.isDots) return { colour: styleColour("--text"), dash: [] };
    const turn = by === "run" ? 0 : Math.floor(column / COLOURS);
    return { colour: seriesColour(colour), dash: DASHES[(dash + turn) % DASHES.length] };
  });
}
