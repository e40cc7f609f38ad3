// The player of one run: brings together picture, time, colours, slice and the picked particle.
import type { App } from "../app";
import { savePicture } from "../charts/save";
import { announce, button, checkbox, element, field, select } from "../dom";
import type { Particles, Run } from "../format";
import { formatNumber, withUnit } from "../units";
import { ColourPanel } from "./colour_panel";
import { categoryTable, viridis } from "./colours";
import { indexOfId, loadPicture, loadWalls, valuesOf, type Picture } from "./frames";
import { addPlayerKeys } from "./keys";
import { countDrawn, pick, place, project } from "./pick";
import { PickedPanel } from "./picked_panel";
import { playerPicture } from "./picture";
import { probeShapes } from "./probes";
import type { MakeScene } from "./scene_interface";
import { SlicePanel } from "./slice_panel";
import { Stage, type Label } from "./stage";
import { PlayerState, sceneBox } from "./state";
import { Transport } from "./transport";

const SIZES = [0.5, 1, 1.5, 2, 3];
/** A click counts this far beside a dot [px]: fingers are not exact. */
const LEAST_REACH = 8;

export class Player {
  readonly root = element("div", { class: "player" });
  private readonly state: PlayerState;
  private readonly stage: Stage;
  private readonly transport: Transport;
  private readonly colours: ColourPanel;
  private readonly slices: SlicePanel;
  private readonly picked: PickedPanel;
  private readonly note = element("p", { class: "note" });
  private readonly count = element("p", { class: "hint count" });
  private readonly problem = element("p", { class: "problem", attributes: { role: "alert" } });
  private picture: Picture | null = null;
  private turn = 0;

  constructor(
    private readonly app: App,
    private run: Run,
    particles: Particles,
    make: MakeScene,
  ) {
    this.state = new PlayerState(particles);
    const box = sceneBox(particles);
    this.stage = new Stage(make, box, {
      clicked: (x, y) => this.pickAt(x, y),
      drawn: () => undefined,
    });
    this.transport = new Transport(this.state, { show: (frame) => this.show(frame) });
    this.colours = new ColourPanel(this.state, (isOtherField) =>
      isOtherField ? this.otherField() : this.recolour(),
    );
    this.slices = new SlicePanel(box, (slice) => {
      this.state.slice = slice;
      this.stage.scene.setSlice(slice);
      this.drawn();
    });
    this.picked = new PickedPanel({
      find: (id) => this.follow(id),
      release: () => this.release(),
      stayInView: (stays) => {
        this.state.staysInView = stays;
        void this.showPicked();
      },
    });
    this.problem.hidden = true;
    this.layOut(particles);
    this.stage.setTheme();
    this.showProbes();
    addPlayerKeys(
      this.stage,
      this.transport,
      (axis) => this.resetView(axis),
      () => announce(this.transport.timeText()),
    );
    void this.show(0);
  }

  private layOut(particles: Particles): void {
    const is3D = particles.dimension === 3;
    const panels = element(
      "div",
      { class: "panels" },
      this.colours.root,
      is3D && this.slices.root,
      this.display(particles),
      this.picked.root,
    );
    const picture = element(
      "div",
      { class: "picture" },
      this.note,
      this.stage.root,
      this.transport.root,
      this.count,
      this.problem,
    );
    this.root.append(picture, panels);
    this.sayNote();
  }

  private display(particles: Particles): HTMLElement {
    const sizes = SIZES.map((size) => ({ value: String(size), text: `${size} × spacing` }));
    const size = select("Size of the dots", sizes, "1", (value) => {
      this.state.dotScale = Number(value);
      this.stage.scene.setPointScale(this.state.dotScale);
      this.stage.draw();
    });
    const walls = checkbox("Walls", true, (shows) => {
      this.state.showsWalls = shows;
      void this.showWalls();
    });
    const probes = checkbox("Probes", true, (shows) => {
      this.state.showsProbes = shows;
      this.showProbes();
    });
    const views =
      particles.dimension === 3
        ? ["x", "y", "z"].map((name, axis) => button(`along ${name}`, () => this.resetView(axis)))
        : [];
    const picture = button("PNG", () => this.savePicture(), "save the picture");
    return element(
      "fieldset",
      {},
      element("legend", {}, "View"),
      field("Dots", size),
      element(
        "div",
        { class: "controls" },
        particles.walls && walls,
        particles.probes.length > 0 && probes,
      ),
      element(
        "div",
        { class: "controls" },
        button("Whole", () => this.resetView(-1)),
        ...views,
        picture,
      ),
    );
  }

  /** New live data of the same run: what has been chosen stays, the newest frame is followed. */
  update(run: Run, particles: Particles): void {
    const wasAtEnd = this.state.frame >= this.state.particles.frames.length - 1;
    const isOther = particles.fields.length !== this.state.particles.fields.length;
    this.run = run;
    this.state.particles = particles;
    if (isOther) this.state.field = 0;
    const box = sceneBox(particles);
    this.stage.setBox(box);
    this.slices.setBox(box);
    this.showProbes();
    this.sayNote();
    const last = particles.frames.length - 1;
    void this.show(wasAtEnd ? last : Math.min(this.state.frame, last));
  }

  setTheme(): void {
    this.stage.setTheme();
    this.recolour();
  }

  stop(): void {
    this.transport.pause();
    this.stage.scene.dispose();
  }

  private async show(frame: number): Promise<void> {
    const turn = ++this.turn;
    const { state } = this;
    const { particles } = state;
    if (!particles.frames[frame]) return;
    try {
      const [picture] = await Promise.all([
        loadPicture(this.app, particles, frame, state.field),
        this.showWalls(frame),
      ]);
      if (turn !== this.turn) return;
      state.frame = frame;
      this.picture = picture;
      state.inFrame = { low: picture.low, high: picture.high };
      this.stage.scene.setParticles(picture.quads);
      this.transport.update();
      this.recolour();
      await this.showPicked();
      this.app.playerTime = particles.frames[frame].time_s;
      this.app.tell("time");
      this.problem.hidden = true;
    } catch (error) {
      this.transport.pause();
      this.problem.hidden = false;
      this.problem.textContent = `Frame ${frame + 1} cannot be read: ${String(error)}`;
    }
  }

  private otherField(): void {
    this.showProbes();
    void this.show(this.state.frame);
  }

  private recolour(): void {
    const [low, high] = this.state.quantisedRange();
    const { isCategory, hidden } = this.state;
    this.stage.scene.setColouring({
      table: isCategory ? categoryTable(hidden) : viridis(),
      isCategory,
      low,
      high,
    });
    this.colours.update();
    this.drawn();
  }

  private drawn(): void {
    const { picture, state } = this;
    if (!picture) return;
    const drawn = countDrawn(sceneBox(state.particles), picture.quads, state.slice, state.isHidden);
    this.count.textContent = `${formatNumber(drawn, 9)} of ${formatNumber(picture.count, 9)} particles of this frame drawn`;
    this.count.dataset.drawn = String(drawn);
    this.stage.draw();
  }

  private async showWalls(frame = this.state.frame): Promise<void> {
    const quads = this.state.showsWalls
      ? await loadWalls(this.app, this.state.particles, frame)
      : null;
    this.stage.scene.setWalls(quads);
    this.stage.draw();
  }

  private showProbes(): void {
    const shapes = probeShapes(this.state.particles);
    const none = new Float64Array(0);
    const shows = this.state.showsProbes;
    this.stage.scene.setProbes(shows ? shapes.segments : none, shows ? shapes.dots : none);
    this.stage.setLabels([...(shows ? shapes.labels : []), ...this.profileLabels()]);
  }

  /** Of a profile: what the upper and the lower edge stand for. */
  private profileLabels(): Label[] {
    const { particles, fieldOf } = this.state;
    if (particles.dimension !== 1 || !fieldOf) return [];
    const { min, max } = sceneBox(particles);
    const text = (value: number) =>
      withUnit(value, fieldOf.unit, 4, Math.max(Math.abs(fieldOf.min), Math.abs(fieldOf.max)));
    return [
      { text: text(fieldOf.max), point: [min[0], max[1], 0] },
      { text: text(fieldOf.min), point: [min[0], min[1], 0] },
    ];
  }

  private sayNote(): void {
    const { note } = this.state.particles;
    this.note.hidden = note === "";
    this.note.textContent = note && `Shown: ${note}`;
  }

  private resetView(axis: number): void {
    this.stage.scene.resetView(axis);
    this.stage.draw();
  }

  private pickAt(x: number, y: number): void {
    if (!this.picture) return;
    const [width, height] = this.stage.size;
    const matrix = this.stage.scene.matrix();
    const { state } = this;
    const box = sceneBox(state.particles);
    const metres = this.stage.scene.metresPerPixel();
    const radius =
      metres > 0
        ? (0.5 * state.dotScale * box.spacing) / metres
        : this.radiusInMiddle(matrix, height);
    const found = pick(
      {
        matrix,
        width,
        height,
        box,
        quads: this.picture.quads,
        slice: state.slice,
        isHidden: state.isHidden,
        reach: Math.max(LEAST_REACH, radius),
      },
      x,
      y,
    );
    if (found >= 0) this.follow(this.picture.ids[found]);
  }

  /** Pixels of the radius of a dot in the middle of the box. */
  private radiusInMiddle(matrix: ArrayLike<number>, height: number): number {
    const box = sceneBox(this.state.particles);
    const [x, y, z] = box.min.map((min, i) => 0.5 * (min + box.max[i]));
    const r = 0.5 * box.spacing * this.state.dotScale;
    const [a, b] = [project(matrix, x, y, z, 1, height), project(matrix, x, y, z + r, 1, height)];
    return Math.abs(a.y - b.y);
  }

  private follow(id: number): void {
    this.state.pickedId = id;
    void this.showPicked();
  }

  private release(): void {
    this.state.pickedId = null;
    this.picked.clear();
    this.stage.mark(null);
  }

  private async showPicked(): Promise<void> {
    const { picture, state } = this;
    if (state.pickedId === null || !picture) return;
    const index = indexOfId(picture.ids, state.pickedId);
    if (index < 0) {
      this.picked.showMissing(state.pickedId);
      this.stage.mark(null);
      return;
    }
    const point = place(sceneBox(state.particles), picture.quads, index);
    const values = await valuesOf(this.app, state.particles, state.frame, index);
    if (picture !== this.picture) return;
    this.picked.show(state.particles, state.pickedId, point, values);
    this.stage.mark(point);
    if (state.staysInView) this.stage.scene.lookAt(point);
  }

  private savePicture(): void {
    this.stage.drawNow();
    const title = this.run.title || this.run.name;
    const time = this.transport.timeText();
    savePicture(
      `${title} ${time.replace("=", "")}.png`,
      playerPicture(title, time, this.state, this.stage),
    );
  }
}
