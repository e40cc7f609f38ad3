// Canvas with what lies over it: names of probes, the ring around the picked particle, the scale.
import { element, styleColour } from "../dom";
import { withUnit } from "../units";
import { project } from "./pick";
import type { MakeScene, ParticleScene, SceneBox } from "./scene_interface";

export interface Label {
  text: string;
  point: number[];
}

/** A pointer that moved further than this between down and up has dragged and not clicked. */
const CLICK_PIXELS = 4;

export class Stage {
  readonly root = element("div", {
    class: "stage",
    attributes: { tabindex: "0", role: "application", "aria-roledescription": "particle player" },
  });
  readonly canvas = element("canvas");
  readonly scene: ParticleScene;
  private readonly over = element("div", { class: "over", attributes: { "aria-hidden": "true" } });
  private readonly ring = element("div", { class: "ring" });
  private readonly scale = element("div", { class: "scale" });
  private labels: { place: HTMLElement; point: number[] }[] = [];
  private marked: number[] | null = null;
  private waiting = 0;

  constructor(
    make: MakeScene,
    box: SceneBox,
    /** A click in the picture, in pixels. */
    private readonly clicked: (x: number, y: number) => void,
  ) {
    this.scene = make({ canvas: this.canvas, isFlat: box.dimension < 3, moved: () => this.draw() });
    this.over.append(this.ring, this.scale);
    this.root.append(this.canvas, this.over);
    this.setBox(box);
    new ResizeObserver(() => this.resize()).observe(this.root);
    this.listenForClicks();
    // The wheel belongs to the page until the player has the focus, or the control key is held.
    this.root.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !this.root.contains(document.activeElement)) event.stopPropagation();
      },
      { capture: true },
    );
  }

  get size(): [number, number] {
    return [this.root.clientWidth, this.root.clientHeight];
  }

  setBox(box: SceneBox): void {
    this.scene.setBox(box);
    const aspect =
      box.dimension === 3
        ? 1.5
        : (box.max[0] - box.min[0]) / Math.max(1e-30, box.max[1] - box.min[1]);
    this.root.style.setProperty("--aspect", String(Math.min(3, Math.max(1, aspect))));
    this.draw();
  }

  setTheme(): void {
    const colour = (name: string) => styleColour(`--${name}`);
    this.scene.setTheme({
      background: colour("background"),
      line: colour("grid-strong"),
      accent: colour("probe"),
      wall: colour("wall"),
      none: colour("none"),
    });
    this.draw();
  }

  setLabels(labels: Label[]): void {
    for (const { place } of this.labels) place.remove();
    this.labels = labels.map(({ text, point }) => ({
      place: element("span", { class: "label" }, text),
      point,
    }));
    this.over.append(...this.labels.map(({ place }) => place));
    this.draw();
  }

  mark(point: number[] | null): void {
    this.marked = point;
    this.draw();
  }

  /** At the next picture of the browser; many calls before it make one drawing. */
  draw(): void {
    if (this.waiting !== 0) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.drawNow();
    });
  }

  drawNow(): void {
    this.scene.render();
    const [width, height] = this.size;
    const matrix = this.scene.matrix();
    const move = (part: HTMLElement, [x, y, z]: number[]) => {
      const spot = project(matrix, x, y, z, width, height);
      part.hidden = spot.depth > 1 || spot.x < 0 || spot.y < 0 || spot.x > width || spot.y > height;
      part.style.transform = `translate(${spot.x.toFixed(1)}px, ${spot.y.toFixed(1)}px)`;
    };
    for (const { place, point } of this.labels) move(place, point);
    if (this.marked) move(this.ring, this.marked);
    else this.ring.hidden = true;
    this.drawScale(width);
  }

  /** Names in the picture with their places in pixels, as of the last drawing. */
  labelSpots(): { text: string; x: number; y: number }[] {
    const [width, height] = this.size;
    return this.labels.map(({ place, point: [x, y, z] }) => {
      const spot = project(this.scene.matrix(), x, y, z, width, height);
      return { text: place.textContent ?? "", x: spot.x, y: spot.y };
    });
  }

  private drawScale(width: number): void {
    const metres = this.scene.metresPerPixel();
    this.scale.hidden = metres === 0 || width === 0;
    if (this.scale.hidden) return;
    const most = 0.25 * width * metres;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map((step) => step * power).find((step) => step <= most) ?? power;
    this.scale.style.width = `${(length / metres).toFixed(1)}px`;
    this.scale.textContent = withUnit(length, "m", 3);
  }

  private resize(): void {
    const [width, height] = this.size;
    if (width === 0 || height === 0) return;
    this.scene.resize(width, height);
    this.drawNow();
  }

  private listenForClicks(): void {
    let down: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      down = [event.clientX, event.clientY];
      this.root.focus({ preventScroll: true });
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (!down || Math.hypot(event.clientX - down[0], event.clientY - down[1]) > CLICK_PIXELS)
        return;
      const edge = this.canvas.getBoundingClientRect();
      this.clicked(event.clientX - edge.left, event.clientY - edge.top);
    });
  }
}
