// A cloud of round dots.
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  GLSL3,
  NearestFilter,
  Points,
  RawShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import type { Colouring, SceneBox, Slice } from "./scene_interface";
import { PARTICLE_FRAGMENT, PARTICLE_VERTEX, WALL_FRAGMENT, WALL_VERTEX } from "./shaders";

const EVERYTHING = 3e38;

export class Dots {
  readonly points: Points<BufferGeometry, RawShaderMaterial>;
  private readonly values = {
    boxMin: { value: new Vector3() },
    boxSize: { value: new Vector3() },
    sliceAxis: { value: new Vector3() },
    sliceRange: { value: new Vector2(-EVERYTHING, EVERYTHING) },
    dotSize: { value: 1 },
    pixelScale: { value: 1 },
    isFlat: { value: 0 },
    colours: { value: new DataTexture(new Uint8Array(1024), 256, 1) },
    range: { value: new Vector2(0, 1) },
    isCategory: { value: 0 },
    none: { value: new Vector4() },
  };

  constructor(kind: "particles" | "walls", isFlat: boolean) {
    this.values.isFlat.value = isFlat ? 1 : 0;
    const isWall = kind === "walls";
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: isWall ? WALL_VERTEX : PARTICLE_VERTEX,
      fragmentShader: isWall ? WALL_FRAGMENT : PARTICLE_FRAGMENT,
      uniforms: this.values,
      transparent: isWall,
      depthWrite: !isWall && !isFlat,
      depthTest: !isFlat,
    });
    this.points = new Points(new BufferGeometry(), material);
    this.points.frustumCulled = false;
  }

  setQuads(quads: Uint16Array): void {
    // A geometry of its own for each frame: buffers of another size cannot be filled again.
    this.points.geometry.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("quad", new BufferAttribute(quads, 4, true));
    geometry.setDrawRange(0, quads.length / 4);
    this.points.geometry = geometry;
    this.points.visible = quads.length > 0;
  }

  setBox(box: SceneBox): void {
    this.values.boxMin.value.fromArray(box.min);
    this.values.boxSize.value.fromArray(box.max.map((max, i) => max - box.min[i]));
  }

  setSlice(slice: Slice | null): void {
    this.values.sliceAxis.value.set(0, 0, 0);
    if (slice) this.values.sliceAxis.value.setComponent(slice.axis, 1);
    this.values.sliceRange.value.set(slice?.low ?? -EVERYTHING, slice?.high ?? EVERYTHING);
  }

  setColouring(colouring: Colouring): void {
    this.values.colours.value.dispose();
    const texture = new DataTexture(colouring.table, 256, 1);
    texture.minFilter = texture.magFilter = NearestFilter;
    texture.needsUpdate = true;
    this.values.colours.value = texture;
    this.values.range.value.set(colouring.low, colouring.high);
    this.values.isCategory.value = colouring.isCategory ? 1 : 0;
  }

  setDotSize(size: number): void {
    this.values.dotSize.value = size;
  }

  setPixelScale(scale: number): void {
    this.values.pixelScale.value = scale;
  }

  setNone(colour: string): void {
    const { r, g, b } = new Color().setStyle(colour, "");
    this.values.none.value.set(r, g, b, 1);
  }
}
