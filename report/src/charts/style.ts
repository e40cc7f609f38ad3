// Colours and dashes of curves.
import { styleColour } from "../dom";
import type { Run } from "../format";
import type { Curve } from "./curves";

export type ColourBy = "run" | "curve";

export interface CurveStyle {
  colour: string;
  dash: number[];
  /** Of dots: filled ones beside hollow ones of the same column. */
  isFilled: boolean;
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

/** How many measured curves of the same column come before each curve. */
function placesAmongDots(curves: Curve[]): number[] {
  const count = new Map<string, number>();
  return curves.map(({ key, isDots }) => {
    const before = count.get(key) ?? 0;
    if (isDots) count.set(key, before + 1);
    return isDots ? before : 0;
  });
}

/** Runs keep their colour in all charts: it goes by their place in the report. */
export function styles(curves: Curve[], runs: Run[], by: ColourBy): CurveStyle[] {
  const keys = [...new Set(curves.map((curve) => curve.key))];
  const places = placesAmongDots(curves);
  // Colours after those of the lines are for further measured curves.
  let next = by === "run" ? runs.length : keys.length;
  return curves.map((curve, i) => {
    const run = curve.run ? runs.indexOf(curve.run) : 0;
    const column = keys.indexOf(curve.key);
    const [colour, dash] = by === "run" ? [run, column] : [column, run];
    const isFilled = places[i] % 2 === 1;
    if (places[i] > 0) return { colour: seriesColour(next++), dash: [], isFilled };
    // Measured values belong to none of several runs.
    if (by === "run" && curve.isDots) return { colour: styleColour("--text"), dash: [], isFilled };
    const turn = by === "run" ? 0 : Math.floor(column / COLOURS);
    return { colour: seriesColour(colour), dash: DASHES[(dash + turn) % DASHES.length], isFilled };
  });
}
