// Lines of the picture: the box, outlines of walls, the probes.
import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
} from "three";
import type { SceneBox, SceneTheme } from "./scene_interface";

const EDGES: [number, number][] = [
  [0, 1],
  [2, 3],
  [4, 5],
  [6, 7],
  [0, 2],
  [1, 3],
  [4, 6],
  [5, 7],
  [0, 4],
  [1, 5],
  [2, 6],
  [3, 7],
];

function corner(box: SceneBox, index: number): number[] {
  return [0, 1, 2].map((axis) => ((index >> axis) & 1 ? box.max[axis] : box.min[axis]));
}

function withPositions(positions: Float32Array): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  return geometry;
}

export class Lines {
  readonly group = new Group();
  private readonly box = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly walls = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
  private readonly probes = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ depthTest: false }),
  );
  private readonly dots = new Points(
    new BufferGeometry(),
    new PointsMaterial({ size: 9, sizeAttenuation: false, depthTest: false }),
  );

  constructor() {
    for (const part of [this.box, this.walls, this.probes, this.dots]) {
      part.frustumCulled = false;
      part.renderOrder = part === this.box || part === this.walls ? 0 : 3;
      this.group.add(part);
    }
  }

  setTheme(theme: SceneTheme): void {
    this.box.material.color.setStyle(theme.line);
    this.walls.material.color.setStyle(theme.wall);
    this.probes.material.color.setStyle(theme.accent);
    this.dots.material.color.setStyle(theme.accent);
  }

  setBox(box: SceneBox): void {
    const edges = box.dimension === 3 ? EDGES : EDGES.filter(([a, b]) => a < 4 && b < 4);
    this.box.geometry.dispose();
    this.box.geometry = withPositions(
      new Float32Array(edges.flatMap(([a, b]) => [...corner(box, a), ...corner(box, b)])),
    );
  }

  setWalls(segments: Float32Array): void {
    this.walls.geometry.dispose();
    this.walls.geometry = withPositions(segments);
    this.walls.visible = segments.length > 0;
  }

  setProbes(segments: Float32Array, dots: Float32Array): void {
    this.probes.geometry.dispose();
    this.probes.geometry = withPositions(segments);
    this.probes.visible = segments.length > 0;
    this.dots.geometry.dispose();
    this.dots.geometry = withPositions(dots);
    this.dots.visible = dots.length > 0;
  }
}
