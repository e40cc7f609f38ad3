// Numbers and units as people read them; the same rules as the program's own figures.

export interface DisplayUnit {
  factor: number; // shown number = value / factor
  unit: string;
}

const PREFIXES: [number, string][] = [
  [1e-12, "p"],
  [1e-9, "n"],
  [1e-6, "µ"],
  [1e-3, "m"],
  [1, ""],
  [1e3, "k"],
  [1e6, "M"],
  [1e9, "G"],
  [1e12, "T"],
];

/** Symbols that take a prefix, with the largest one in use: nobody reads kiloseconds. */
const LARGEST_PREFIX: Record<string, number> = {
  Pa: 1e12,
  J: 1e12,
  W: 1e12,
  N: 1e12,
  Hz: 1e12,
  s: 1,
  m: 1e3,
  g: 1,
};

const RAISED: Record<string, string> = {
  "-": "⁻",
  "0": "⁰",
  "1": "¹",
  "2": "²",
  "3": "³",
  "4": "⁴",
  "5": "⁵",
  "6": "⁶",
  "7": "⁷",
  "8": "⁸",
  "9": "⁹",
};

export function raised(exponent: number | string): string {
  return [...String(exponent)].map((c) => RAISED[c] ?? c).join("");
}

/** "kPa·ms" for "kPa ms", "m³" for "m^3". */
export function typesetUnit(unit: string): string {
  return unit
    .replace(/([A-Za-z])\^?(-?\d+)/g, (_, symbol: string, power: string) => symbol + raised(power))
    .replace(/ /g, "·")
    .replace(/\bu(?=[smJPN])/g, "µ");
}

export function displayUnit(unit: string, largest: number): DisplayUnit {
  const plain = { factor: 1, unit: typesetUnit(unit) };
  const size = Math.abs(largest);
  if (!(size > 0) || !Number.isFinite(size)) return plain;
  if (unit === "kg" && size < 1) return prefixed("g", size * 1e3, 1e-3);
  const first = /^[A-Za-z]+/.exec(unit)?.[0] ?? "";
  const takesPrefix = first in LARGEST_PREFIX && !/^[\^\d-]/.test(unit.slice(first.length));
  const isRate = first === "m" && unit.length > 1;
  if (isRate && size >= 0.01 && size < 1e4) return plain;
  if (takesPrefix) return prefixed(unit, size, 1);
  if (size >= 0.01 && size < 1e5) return plain;
  return powerOfTen(unit, size);
}

function prefixed(unit: string, size: number, factor: number): DisplayUnit {
  const first = /^[A-Za-z]+/.exec(unit)?.[0] ?? "";
  const usable = PREFIXES.filter(([scale]) => scale <= (LARGEST_PREFIX[first] ?? 1));
  // Rounding must not turn 999.9999 into "1000": the next prefix takes over slightly before.
  let best = usable[0];
  for (const entry of usable) if (size >= entry[0] * 0.9999999) best = entry;
  return { factor: best[0] * factor, unit: best[1] + typesetUnit(unit) };
}

function powerOfTen(unit: string, size: number): DisplayUnit {
  const exponent = 3 * Math.floor(Math.log10(size) / 3);
  if (exponent === 0) return { factor: 1, unit: typesetUnit(unit) };
  return { factor: 10 ** exponent, unit: `10${raised(exponent)} ${typesetUnit(unit)}`.trim() };
}

/** "1.5", "0.00012", "3.2·10⁻⁹"; thousands are set apart by thin spaces. */
export function formatNumber(value: number | null | undefined, digits = 6): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 10 ** Math.max(digits, 6) || size < 1e-4) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${withoutZeros(mantissa)}·10${raised(Number(exponent))}`.replace("-", "−");
  }
  const [whole, part = ""] = withoutZeros(value.toPrecision(digits)).split(".");
  const grouped =
    whole.replace("-", "").length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return (part ? `${grouped}.${part}` : grouped).replace("-", "−");
}

function withoutZeros(text: string): string {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

export function withUnit(
  value: number | null | undefined,
  unit: string,
  digits = 4,
  largest = value,
): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  const shown = displayUnit(unit, largest ?? value);
  const number = formatNumber(value / shown.factor, digits);
  return shown.unit ? `${number}\u00a0${shown.unit}` : number;
}

/** "2 h 5 min", "48 s". */
export function duration(seconds: number): string {
  if (seconds < 1) return withUnit(seconds, "s", 3);
  if (seconds < 100) return `${formatNumber(seconds, 3)}\u00a0s`;
  const minutes = Math.round(seconds / 60);
  if (minutes < 100) return `${minutes}\u00a0min`;
  const hours = Math.floor(minutes / 60);
  if (hours < 48) return `${hours}\u00a0h ${minutes % 60}\u00a0min`;
  return `${Math.floor(hours / 24)}\u00a0d ${hours % 24}\u00a0h`;
}

/** Numbers of ticks, all with as many decimals as the step between them needs. */
export function formatTicks(
  values: (number | null)[],
  factor: number,
  isLogarithmic: boolean,
): string[] {
  if (isLogarithmic) return values.map((v) => (v === null ? "" : formatNumber(v / factor, 4)));
  const scaled = values.map((v) => (v === null ? null : v / factor));
  const known = scaled.filter((v): v is number => v !== null);
  const step = known.length > 1 ? Math.abs(known[1] - known[0]) : 1;
  const decimals = Math.min(
    12,
    Math.max(0, Math.ceil(-Math.log10(step) - 1e-9) + (isRound(step) ? 0 : 1)),
  );
  return scaled.map((v) => {
    if (v === null) return "";
    const rounded = Math.abs(v) < step * 1e-6 ? 0 : v;
    return Math.abs(rounded) >= 1e6 ? formatNumber(rounded, 6) : groupedFixed(rounded, decimals);
  });
}

function groupedFixed(value: number, decimals: number): string {
  const [whole, part] = value.toFixed(decimals).split(".");
  const grouped =
    whole.replace("-", "").length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, "\u202f") : whole;
  return (part === undefined ? grouped : `${grouped}.${part}`).replace("-", "−");
}

/** Steps of 1, 2 or 5 times a power of ten need one decimal less than 2.5. */
function isRound(step: number): boolean {
  const mantissa = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
  return Math.abs(mantissa - Math.round(mantissa)) < 1e-6;
}

/** Names of the program in words: "kinetic_energy" is read as "kinetic energy". */
export function words(name: string): string {
  return name.replace(/_/g, " ");
}
