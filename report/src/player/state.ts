// What the reader has chosen in the player.
import { STEPS, type Field, type Particles } from "../format";
import { quantisedOf } from "./frames";
import type { SceneBox, Slice } from "./scene_interface";

export type RangeMode = "all" | "frame" | "typed";

export class PlayerState {
  frame = 0;
  field = 0;
  rangeMode: RangeMode = "all";
  typed: [number, number] = [0, 1];
  /** Of the frame that is shown, quantised. */
  inFrame = { low: 0, high: 1 };
  hidden = new Set<number>();
  slice: Slice | null = null;
  showsWalls = true;
  showsProbes = true;
  dotScale = 1;
  framesPerSecond = 10;
  isLooping = true;

  constructor(public particles: Particles) {
    this.field = firstField(particles.fields);
  }

  get fieldOf(): Field | undefined {
    return this.particles.fields[this.field];
  }

  get isCategory(): boolean {
    return this.fieldOf?.kind === "category";
  }

  isHidden = (value: number): boolean => this.isCategory && this.hidden.has(value);

  /** Limits of the colours, as values. */
  range(): [number, number] {
    const field = this.fieldOf;
    if (!field) return [0, 1];
    if (this.rangeMode === "typed") return this.typed;
    if (this.rangeMode === "all" || this.inFrame.low > this.inFrame.high)
      return [field.min, field.max];
    return [this.inFrame.low, this.inFrame.high].map(
      (q) => field.min + (q / STEPS) * (field.max - field.min),
    ) as [number, number];
  }

  quantisedRange(): [number, number] {
    const field = this.fieldOf;
    if (!field) return [0, 1];
    const [low, high] = this.range();
    return [quantisedOf(field, low), quantisedOf(field, high)];
  }
}

/** What changes most is looked at first: pressure or speed rather than a material. */
function firstField(fields: Field[]): number {
  for (const name of ["pressure", "velocity", "speed"]) {
    const found = fields.findIndex((field) => field.kind === "number" && field.name.includes(name));
    if (found >= 0) return found;
  }
  return Math.max(
    0,
    fields.findIndex((field) => field.kind === "number"),
  );
}

/** Share of the width that the value of a one-dimensional run is drawn high. */
const PROFILE_HEIGHT = 0.4;

/** Where only some of the particles are shown, each stands for its share of the space. */
function shownSpacing({ spacing, total, shown, dimension }: Particles): number {
  return shown > 0 && shown < total ? spacing * (total / shown) ** (1 / dimension) : spacing;
}

/** The box of the picture: three extents that are not all zero. */
export function sceneBox(particles: Particles): SceneBox {
  const { dimension, box } = particles;
  const min = [0, 1, 2].map((axis) => (axis < dimension ? (box.min[axis] ?? 0) : 0));
  const max = [0, 1, 2].map((axis) => (axis < dimension ? (box.max[axis] ?? 0) : 0));
  if (dimension === 1) max[1] = PROFILE_HEIGHT * (max[0] - min[0]);
  return { min, max, dimension, spacing: shownSpacing(particles) };
}
