// The player of one run: brings together picture, time, colours, slice and the followed particle.
import type { App } from "../app";
import { savePicture } from "../charts/save";
import { announce, element } from "../dom";
import type { Particles, Run } from "../format";
import { formatNumber, withUnit } from "../units";
import { ColourPanel } from "./colour_panel";
import { categoryTable, viridis } from "./colours";
import { Followed } from "./followed";
import { loadPicture, loadWalls, type Picture } from "./frames";
import { addPlayerKeys } from "./keys";
import { wallOutlines } from "./outlines";
import { countDrawn } from "./pick";
import { playerPicture } from "./picture";
import { probeShapes } from "./probes";
import type { MakeScene } from "./scene_interface";
import { SlicePanel } from "./slice_panel";
import { Stage, type Label } from "./stage";
import { PlayerState, sceneBox } from "./state";
import { Transport } from "./transport";
import { viewPanel } from "./view_panel";

export class Player {
  readonly root = element("div", { class: "player" });
  private readonly state: PlayerState;
  private readonly stage: Stage;
  private readonly transport: Transport;
  private readonly colours: ColourPanel;
  private readonly slices: SlicePanel;
  private readonly followed: Followed;
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
    const state = new PlayerState(particles);
    this.state = state;
    const box = sceneBox(particles);
    this.followed = new Followed(app, state, () => this.stage);
    this.stage = new Stage(make, box, (x, y) => this.followed.pickAt(x, y));
    this.transport = new Transport(state, (frame) => this.show(frame));
    this.colours = new ColourPanel(state, (isOtherField) => {
      if (isOtherField) this.otherField();
      else this.recolour();
    });
    this.slices = new SlicePanel(box, (slice) => {
      state.slice = slice;
      this.stage.scene.setSlice(slice);
      this.drawn();
    });
    this.problem.hidden = true;
    this.layOut(particles);
    this.stage.setTheme();
    this.showProbes();
    const say = () => announce(this.transport.timeText());
    addPlayerKeys(this.stage, this.transport, (axis) => this.resetView(axis), say);
    void this.show(0);
  }

  private layOut(particles: Particles): void {
    const view = viewPanel(particles, this.state, {
      resized: () => {
        this.stage.scene.setPointScale(this.state.dotScale);
        this.stage.draw();
      },
      wallsSwitched: () => void this.showWalls(),
      probesSwitched: () => this.showProbes(),
      resetView: (axis) => this.resetView(axis),
      savePicture: () => this.savePicture(),
    });
    const slices = particles.dimension === 3 && this.slices.root;
    const { colours, followed, note, stage, transport, count, problem } = this;
    this.root.append(
      element("div", { class: "picture" }, note, stage.root, transport.root, count, problem),
      element("div", { class: "panels" }, colours.root, slices, view, followed.panel.root),
    );
    this.sayNote();
  }

  /** New live data of the same run: what has been chosen stays, the newest frame is followed. */
  update(run: Run, particles: Particles): void {
    const { state } = this;
    const wasAtEnd = state.frame >= state.particles.frames.length - 1;
    if (particles.fields.length !== state.particles.fields.length) state.field = 0;
    this.run = run;
    state.particles = particles;
    const box = sceneBox(particles);
    this.stage.setBox(box);
    this.slices.setBox(box);
    this.showProbes();
    this.sayNote();
    const last = particles.frames.length - 1;
    void this.show(wasAtEnd ? last : Math.min(state.frame, last));
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
      const loading = loadPicture(this.app, particles, frame, state.field);
      const [picture] = await Promise.all([loading, this.showWalls(frame)]);
      if (turn !== this.turn) return;
      state.frame = frame;
      this.picture = picture;
      state.inFrame = { low: picture.low, high: picture.high };
      this.stage.scene.setParticles(picture.quads);
      this.transport.update();
      this.recolour();
      await this.followed.show(picture);
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
    const table = isCategory ? categoryTable(hidden) : viridis();
    this.stage.scene.setColouring({ table, isCategory, low, high });
    this.colours.update();
    this.drawn();
  }

  private drawn(): void {
    const { picture, state } = this;
    if (!picture) return;
    const box = sceneBox(state.particles);
    const drawn = countDrawn(box, picture.quads, state.slice, state.isHidden);
    const of = formatNumber(picture.count, 9);
    this.count.textContent = `${formatNumber(drawn, 9)} of ${of} particles of this frame drawn`;
    this.count.dataset.drawn = String(drawn);
    this.stage.draw();
  }

  private async showWalls(frame = this.state.frame): Promise<void> {
    const { showsWalls, particles } = this.state;
    const boxes = showsWalls ? (particles.walls?.boxes ?? []) : [];
    this.stage.scene.setWallOutlines(wallOutlines(boxes, sceneBox(particles)));
    this.stage.scene.setWalls(showsWalls ? await loadWalls(this.app, particles, frame) : null);
    this.stage.draw();
  }

  private showProbes(): void {
    const shapes = probeShapes(this.state.particles.probes, sceneBox(this.state.particles));
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
    const largest = Math.max(Math.abs(fieldOf.min), Math.abs(fieldOf.max));
    const label = (value: number, y: number) => ({
      text: withUnit(value, fieldOf.unit, 4, largest),
      point: [min[0], y, 0],
    });
    return [label(fieldOf.max, max[1]), label(fieldOf.min, min[1])];
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

  private savePicture(): void {
    this.stage.drawNow();
    const title = this.run.title || this.run.name;
    const time = this.transport.timeText();
    const name = `${title} ${time.replace("=", "")}.png`;
    savePicture(name, playerPicture(title, time, this.state, this.stage));
  }
}
