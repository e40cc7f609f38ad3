// Frames of the particles, decoded when they are asked for.
import type { App } from "../app";
import type { NumberArray } from "../blocks";
import { NONE, STEPS, type Field, type Particles } from "../format";

/** One frame with one field's values, as the scene wants it. */
export interface Picture {
  frame: number;
  count: number;
  ids: NumberArray;
  /** x, y, z, value of each particle, quantised. */
  quads: Uint16Array;
  /** Least and largest quantised value that is there; low > high if none is. */
  low: number;
  high: number;
}

const MIDDLE = STEPS / 2;

export function valueOf(field: Field, quantised: number): number {
  if (field.kind === "category") return quantised;
  if (quantised === NONE) return NaN;
  return field.min + (quantised / STEPS) * (field.max - field.min);
}

export function quantisedOf(field: Field, value: number): number {
  if (field.kind === "category") return value;
  const span = field.max - field.min;
  return span > 0 ? ((value - field.min) / span) * STEPS : 0;
}

/** Places between components: those that a run of fewer dimensions lacks are in the middle. */
function interleave(
  count: number,
  components: NumberArray[],
  values: NumberArray | null,
): Uint16Array {
  const quads = new Uint16Array(4 * count);
  for (let part = 0; part < 3; ++part) {
    const from = components[part];
    for (let i = 0; i < count; ++i) quads[4 * i + part] = from ? from[i] : MIDDLE;
  }
  for (let i = 0; i < count; ++i) quads[4 * i + 3] = values ? values[i] : 0;
  return quads;
}

function extremes(quads: Uint16Array, field: Field | undefined): { low: number; high: number } {
  const none = field?.kind === "category" ? -1 : NONE;
  let [low, high] = [Infinity, -Infinity];
  for (let i = 3; i < quads.length; i += 4) {
    const value = quads[i];
    if (value === none) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return { low, high };
}

export async function loadPicture(
  app: App,
  particles: Particles,
  frameIndex: number,
  fieldIndex: number,
): Promise<Picture> {
  const frame = particles.frames[frameIndex];
  const field = particles.fields[fieldIndex];
  const wanted = [frame.id, ...frame.position, ...(field ? [frame.values[fieldIndex]] : [])];
  const [ids, ...rest] = await Promise.all(wanted.map((numbers) => app.blocks.numbers(numbers)));
  const values = field ? (rest.pop() ?? null) : null;
  const quads = interleave(frame.count, rest, values);
  if (particles.dimension === 1) raise(quads, field);
  return { frame: frameIndex, count: frame.count, ids, quads, ...extremes(quads, field) };
}

/** In one dimension the value is drawn over x. */
function raise(quads: Uint16Array, field: Field | undefined): void {
  const isCategory = field?.kind === "category";
  const scale = isCategory ? STEPS / Math.max(1, field.max) : 1;
  // What has no value has no height either.
  const most = isCategory ? STEPS : NONE;
  for (let i = 0; i < quads.length; i += 4) quads[i + 1] = Math.min(most, quads[i + 3] * scale);
}

export async function loadWalls(
  app: App,
  particles: Particles,
  frameIndex: number,
): Promise<Uint16Array | null> {
  const frames = particles.walls?.frames ?? [];
  const frame = frames.length === 1 ? frames[0] : frames[frameIndex];
  if (!frame || frame.count === 0) return null;
  const components = await Promise.all(
    frame.position.map((numbers) => app.blocks.numbers(numbers)),
  );
  return interleave(frame.count, components, null);
}

/** Number of a particle in a frame, or -1. The ids ascend. */
export function indexOfId(ids: NumberArray, id: number): number {
  let low = 0;
  let high = ids.length - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    if (ids[middle] === id) return middle;
    if (ids[middle] < id) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

export async function valuesOf(
  app: App,
  particles: Particles,
  frameIndex: number,
  index: number,
): Promise<number[]> {
  const frame = particles.frames[frameIndex];
  const all = await Promise.all(frame.values.map((numbers) => app.blocks.numbers(numbers)));
  return all.map((values, i) => valueOf(particles.fields[i], values[index]));
}
