// Probes as segments and dots: a place, a line, a box.
import type { Particles, Probe } from "../format";
import type { Label } from "./stage";

export interface ProbeShapes {
  segments: Float64Array;
  dots: Float64Array;
  labels: Label[];
}

function space(point: number[]): number[] {
  return [point[0] ?? 0, point[1] ?? 0, point[2] ?? 0];
}

/** Edges of the box whose corners include the least and the largest of the points. */
function boxEdges(points: number[][], dimension: number): number[] {
  const all = points.map(space);
  const min = [0, 1, 2].map((axis) => Math.min(...all.map((p) => p[axis])));
  const max = [0, 1, 2].map((axis) => Math.max(...all.map((p) => p[axis])));
  const corner = (code: number) =>
    [0, 1, 2].map((axis) => ((code >> axis) & 1 ? max[axis] : min[axis]));
  const edges: number[] = [];
  for (let code = 0; code < 2 ** dimension; ++code) {
    for (let axis = 0; axis < dimension; ++axis) {
      if (!((code >> axis) & 1)) edges.push(...corner(code), ...corner(code | (1 << axis)));
    }
  }
  return edges;
}

function isBox(probe: Probe): boolean {
  return probe.points.length > 2 || /box|region|volume/.test(probe.kind);
}

export function probeShapes(particles: Particles): ProbeShapes {
  const segments: number[] = [];
  const dots: number[] = [];
  const labels: Label[] = [];
  for (const probe of particles.probes) {
    if (probe.points.length === 0) continue;
    if (isBox(probe)) segments.push(...boxEdges(probe.points, particles.dimension));
    else if (probe.points.length === 2) segments.push(...probe.points.flatMap(space));
    else dots.push(...space(probe.points[0]));
    labels.push({ text: probe.name, point: space(probe.points[0]) });
  }
  return { segments: Float64Array.from(segments), dots: Float64Array.from(dots), labels };
}
