// Probes as segments and dots: a place, a line, a box.
import type { Probe } from "../format";
import { boxEdges, space } from "./outlines";
import type { SceneBox } from "./scene_interface";
import type { Label } from "./stage";

export interface ProbeShapes {
  segments: Float64Array;
  dots: Float64Array;
  labels: Label[];
}

/** The part of a box that is in the picture: one may reach as far as its user liked. */
function seenPart({ points }: Probe, box: SceneBox): [number[], number[]] | null {
  const [first, second] = [space(points[0]), space(points[1] ?? points[0])];
  const axes = [0, 1, 2].slice(0, box.dimension);
  const isBeside = axes.some(
    (axis) =>
      Math.max(first[axis], second[axis]) < box.min[axis] ||
      Math.min(first[axis], second[axis]) > box.max[axis],
  );
  if (isBeside && box.dimension > 1) return null;
  const within = (point: number[]) =>
    point.map((x, axis) => Math.min(box.max[axis], Math.max(box.min[axis], x)));
  return [within(first), within(second)];
}

export function probeShapes(probes: Probe[], box: SceneBox): ProbeShapes {
  const segments: number[] = [];
  const dots: number[] = [];
  const labels: Label[] = [];
  for (const probe of probes) {
    if (probe.points.length === 0) continue;
    let point = space(probe.points[0]);
    if (probe.shape === "box") {
      const part = seenPart(probe, box);
      if (!part) continue;
      segments.push(...boxEdges(...part, box.dimension));
      point = part[0];
    } else if (probe.shape === "line") segments.push(...probe.points.flatMap(space));
    else dots.push(...point);
    labels.push({ text: probe.name, point });
  }
  return { segments: Float64Array.from(segments), dots: Float64Array.from(dots), labels };
}
