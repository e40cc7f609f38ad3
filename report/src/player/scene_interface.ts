// What the page asks of the WebGL part, which is a script of its own: pages without particles go
// without it.

export interface SceneTheme {
  background: string;
  line: string;
  accent: string;
  wall: string;
  none: string;
}

export interface SceneBox {
  min: number[];
  max: number[];
  dimension: number; // 1: the plot of a value over x
  spacing: number;
}

export interface Slice {
  axis: number;
  low: number; // m
  high: number;
}

export interface Colouring {
  /** 256 colours, RGBA. */
  table: Uint8Array;
  isCategory: boolean;
  /** Of the quantised values: what the first and the last colour stand for. */
  low: number;
  high: number;
}

export interface ParticleScene {
  setTheme(theme: SceneTheme): void;
  setBox(box: SceneBox): void;
  /** x, y, z and value of each particle, quantised over the box. */
  setParticles(quads: Uint16Array): void;
  setWalls(quads: Uint16Array | null): void;
  /** Places [m], three numbers each; two places make a segment. */
  setWallOutlines(segments: Float64Array): void;
  /** Places [m], three numbers each; two places make a segment. */
  setProbes(segments: Float64Array, dots: Float64Array): void;
  setColouring(colouring: Colouring): void;
  setSlice(slice: Slice | null): void;
  setPointScale(scale: number): void;
  /** Moves what is looked at. */
  lookAt(point: number[]): void;
  /** The whole box; seen along an axis, or from a corner for -1. */
  resetView(axis: number): void;
  turn(right: number, up: number): void;
  zoom(factor: number): void;
  resize(width: number, height: number): void;
  /** Sixteen numbers, by columns, that take a place [m] to clip space; as of the last picture. */
  matrix(): ArrayLike<number>;
  /** Length of a pixel [m] in a flat view; 0 in perspective. */
  metresPerPixel(): number;
  render(): void;
  dispose(): void;
}

export interface SceneOptions {
  canvas: HTMLCanvasElement;
  isFlat: boolean;
  /** The view has been moved by the reader. */
  moved(): void;
}

/** Throws where there is no WebGL. */
export type MakeScene = (options: SceneOptions) => ParticleScene;

declare global {
  interface Window {
    moraineScene?: MakeScene;
  }
}
