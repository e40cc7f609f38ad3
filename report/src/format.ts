// The data of a report, as FORMAT.md describes them. Numbers are in SI units; null is "no number".

export interface Report {
  format: 1;
  program: { name: string; version: string; revision: string };
  made: string;
  cite: { text: string; bibtex: string };
  live: { data: string; interval_s: number } | null;
  revision?: number;
  blocks?: Record<string, string>;
  runs: Run[];
  sweep: Sweep | null;
}

export type RunState = "ended" | "running" | "stopped" | "broken";

export interface Run {
  name: string;
  title: string;
  state: RunState;
  end_reason: string;
  progress: Progress | null;
  facts: { label: string; value: string }[];
  quality: Quality[];
  comparisons: Comparison[];
  stages: Stage[];
  tables: Table[];
  references: Reference[];
  measures: Measure[];
  decays: Decay[];
  votes: Vote[];
  timing: Timing[];
  settings: Setting[];
  particles: Particles | null;
}

export interface Progress {
  time_s: number;
  end_time_s: number;
  step: number;
  time_step_s: number;
  limited_by: string;
  steps_per_second: number | null;
  time_left_s: number | null;
  particles: number;
}

export type Verdict = "good" | "doubtful" | "bad" | "unknown";

export interface Quality {
  name: string;
  verdict: Verdict;
  value: string;
  limit: string;
  meaning: string;
}

export interface Comparison {
  name: string;
  unit: string;
  value: number | null;
  reference: number;
  tolerance: number | null;
  verdict: "good" | "bad" | "unknown";
  source: string;
}

export interface Stage {
  name: string;
  time_s: number;
  step: number;
  cause: string;
}

export interface Vote {
  reason: string;
  steps: number;
  share: number;
  least_time_step_s: number | null;
}

export interface Timing {
  label: string;
  seconds: number;
  calls: number;
}

export interface Setting {
  section: string;
  key: string;
  value: string;
  unit: string;
  is_default: boolean;
  meaning: string;
}

export interface Table {
  name: string;
  rows: number;
  rows_of: number;
  time: Numbers;
  columns: Column[];
}

export interface Column {
  label: string;
  gauge: string;
  name: string;
  unit: string;
  group: string;
  data: Numbers;
}

export interface Reference {
  name: string;
  table: string;
  column: string;
  source: string;
  time: Numbers;
  value: Numbers;
}

export interface Measure {
  gauge: string;
  column: string;
  unit: string;
  seen: boolean;
  first: number | null;
  largest: number | null;
  time_of_largest: number | null;
  smallest: number | null;
  time_of_smallest: number | null;
  integral_over_time: number | null;
  impulse: number | null;
  arrival: number | null;
  duration: number | null;
}

export interface Decay {
  gauge: string;
  exponent: number | null;
  points: number | null;
  scatter: number | null;
}

export type NumberType = "f64" | "f32" | "u32" | "u16" | "u8";

export interface Numbers {
  block: string;
  offset: number;
  count: number;
  type: NumberType;
}

export interface Particles {
  dimension: 1 | 2 | 3;
  spacing: number;
  box: { min: number[]; max: number[] };
  total: number;
  shown: number;
  note: string;
  fields: Field[];
  materials: string[];
  frames: Frame[];
  walls: { frames: WallFrame[]; boxes: WallBox[] } | null;
  probes: Probe[];
}

export interface WallBox {
  name: string;
  min: number[];
  max: number[];
  open: string[];
}

export interface Probe {
  name: string;
  kind: string;
  shape: "dot" | "line" | "box";
  points: number[][];
}

export interface Field {
  name: string;
  unit: string;
  kind: "number" | "category";
  min: number;
  max: number;
}

export interface Frame {
  time_s: number;
  count: number;
  id: Numbers;
  position: Numbers[];
  values: Numbers[];
}

export interface WallFrame {
  count: number;
  position: Numbers[];
}

export interface Sweep {
  title: string;
  parameters: { label: string; unit: string }[];
  outputs: { label: string; unit: string }[];
  members: Member[];
}

export interface Member {
  name: string;
  state: "done" | "failed" | "waiting";
  message: string;
  run: number | null;
  values: (number | string)[];
  outputs: (number | null)[];
  steps: number | null;
  wall_time_s: number | null;
}

/** Largest number of a quantised position or value; one more stands for "none". */
export const STEPS = 65534;
export const NONE = 65535;

/** Throws where data are not what this page reads. */
export function requireReport(data: unknown): Report {
  const report = data as Partial<Report> | null;
  if (report?.format !== 1) {
    throw new Error(`the data have format ${String(report?.format)}, this page reads format 1`);
  }
  if (!Array.isArray(report.runs)) throw new Error("the data have no list of runs");
  return report as Report;
}
