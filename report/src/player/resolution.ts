// Numbers with the digits that 16 bits over a range carry, and not one more.
import { STEPS } from "../format";
import { withUnit } from "../units";

export function stepOf(min: number, max: number): number {
  return (max - min) / STEPS;
}

/**
 * "3.02 Pa ± 23 mPa": rounded to the decade of the step; half a step is what quantising may have
 * moved it by. Where the step carries more than so many digits, only those are shown.
 */
export function withResolution(value: number, step: number, unit: string, digits: number): string {
  if (!Number.isFinite(value) || !(step > 0)) return withUnit(value, unit, digits);
  const decade = Math.floor(Math.log10(step));
  const size = value === 0 ? decade : Math.floor(Math.log10(Math.abs(value)));
  if (size - decade >= digits) return withUnit(value, unit, digits);
  const rounded = Math.round(value / 10 ** decade) * 10 ** decade;
  return `${withUnit(rounded, unit, digits)} ± ${withUnit(0.5 * step, unit, 2)}`;
}
