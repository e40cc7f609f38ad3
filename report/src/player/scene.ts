// The WebGL part of the player. Draws on demand only: nothing moves unless the page or the reader
// says so.
import { Matrix4, Scene as World, Vector3, WebGLRenderer } from "three";
import { Dots } from "./dots";
import { Lines } from "./lines";
import { View } from "./view";
import type {
  Colouring,
  ParticleScene,
  SceneBox,
  SceneOptions,
  SceneTheme,
  Slice,
} from "./scene_interface";

class Scene implements ParticleScene {
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly view: View;
  private readonly particles: Dots;
  private readonly walls: Dots;
  private readonly lines: Lines;
  private readonly seen = new Matrix4();
  private readonly toWorld = new Matrix4();
  /**
   * World lengths of a metre: in the world the box has size one, wherever and however small it is.
   */
  private unit = 1;
  private spacing = 1;
  private scale = 1;

  constructor(options: SceneOptions) {
    const { canvas, isFlat } = options;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.view = new View(canvas, isFlat, options.moved);
    this.particles = new Dots("particles", isFlat);
    this.walls = new Dots("walls", isFlat);
    this.lines = new Lines();
    this.walls.points.renderOrder = isFlat ? 0 : 2;
    this.particles.points.renderOrder = 1;
    this.world.add(this.walls.points, this.particles.points, this.lines.group);
  }

  setTheme(theme: SceneTheme): void {
    this.renderer.setClearColor(theme.background);
    this.particles.setNone(theme.none);
    this.walls.setNone(theme.wall);
    this.lines.setTheme(theme);
  }

  setBox(box: SceneBox): void {
    const extents = box.max.map((max, i) => max - box.min[i]);
    const centre = box.min.map((min, i) => min + 0.5 * extents[i]);
    this.unit = 1 / Math.max(...extents, box.spacing, 1e-30);
    this.toWorld
      .makeScale(this.unit, this.unit, this.unit)
      .multiply(new Matrix4().makeTranslation(-centre[0], -centre[1], -centre[2]));
    this.spacing = box.spacing * this.unit;
    const [min, max] = [this.place(box.min), this.place(box.max)];
    const scaled = { ...box, min, max, spacing: this.spacing };
    this.view.setBox(scaled);
    for (const dots of [this.particles, this.walls]) dots.setBox(scaled);
    this.lines.setBox(scaled);
    this.setPointScale(this.scale);
  }

  private place(point: ArrayLike<number>): number[] {
    return new Vector3(point[0], point[1], point[2]).applyMatrix4(this.toWorld).toArray();
  }

  private places(points: Float64Array): Float32Array {
    const placed = new Float32Array(points.length);
    for (let i = 0; i < points.length; i += 3) placed.set(this.place(points.subarray(i, i + 3)), i);
    return placed;
  }

  setParticles(quads: Uint16Array): void {
    this.particles.setQuads(quads);
  }

  setWalls(quads: Uint16Array | null): void {
    this.walls.setQuads(quads ?? new Uint16Array(0));
  }

  setWallOutlines(segments: Float64Array): void {
    this.lines.setWalls(this.places(segments));
  }

  setProbes(segments: Float64Array, dots: Float64Array): void {
    this.lines.setProbes(this.places(segments), this.places(dots));
  }

  setColouring(colouring: Colouring): void {
    this.particles.setColouring(colouring);
  }

  setSlice(slice: Slice | null): void {
    const shift = slice ? this.toWorld.elements[12 + slice.axis] : 0;
    const scaled = slice && {
      ...slice,
      low: slice.low * this.unit + shift,
      high: slice.high * this.unit + shift,
    };
    for (const dots of [this.particles, this.walls]) dots.setSlice(scaled);
  }

  setPointScale(scale: number): void {
    this.scale = scale;
    this.particles.setDotSize(this.spacing * scale);
    this.walls.setDotSize(this.spacing * scale * 0.7);
  }

  lookAt(point: number[]): void {
    this.view.lookAt(new Vector3().fromArray(this.place(point)));
  }

  resetView(axis: number): void {
    this.view.reset(axis);
  }

  turn(right: number, up: number): void {
    this.view.turn(right, up);
  }

  zoom(factor: number): void {
    this.view.zoom(factor);
  }

  resize(width: number, height: number): void {
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.view.resize(width, height);
  }

  matrix(): ArrayLike<number> {
    return this.seen.elements;
  }

  metresPerPixel(): number {
    return this.view.lengthOfPixel() / this.unit;
  }

  render(): void {
    const ratio = this.renderer.getPixelRatio();
    this.view.update();
    for (const dots of [this.particles, this.walls])
      dots.setPixelScale(this.view.pixelScale() * ratio);
    this.seen
      .multiplyMatrices(this.view.camera.projectionMatrix, this.view.camera.matrixWorldInverse)
      .multiply(this.toWorld);
    this.renderer.render(this.world, this.view.camera);
  }

  dispose(): void {
    this.view.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

window.moraineScene = (options) => new Scene(options);
