// The particle that is read: found by a click or by its number, followed by its number from frame
// to frame.
import type { App } from "../app";
import { indexOfId, valuesOf, type Picture } from "./frames";
import { pick, place, project } from "./pick";
import { PickedPanel } from "./picked_panel";
import type { SceneBox } from "./scene_interface";
import type { Stage } from "./stage";
import { sceneBox, type PlayerState } from "./state";

/** A click counts this far beside a dot [px]: fingers are not exact. */
const LEAST_REACH = 8;

export class Followed {
  readonly panel: PickedPanel;
  private picture: Picture | null = null;
  private id: number | null = null;
  private staysInView = false;

  constructor(
    private readonly app: App,
    private readonly state: PlayerState,
    private readonly stage: () => Stage,
  ) {
    this.panel = new PickedPanel({
      find: (id) => this.follow(id),
      release: () => this.release(),
      stayInView: (stays) => {
        this.staysInView = stays;
        void this.read();
      },
    });
  }

  /** Another frame is shown. */
  async show(picture: Picture): Promise<void> {
    this.picture = picture;
    await this.read();
  }

  pickAt(x: number, y: number): void {
    if (!this.picture) return;
    const { state } = this;
    const stage = this.stage();
    const [width, height] = stage.size;
    const matrix = stage.scene.matrix();
    const box = sceneBox(state.particles);
    const reach = Math.max(LEAST_REACH, this.dotRadius(stage, box));
    const { slice, isHidden } = state;
    const { quads, ids } = this.picture;
    const found = pick({ matrix, width, height, box, quads, slice, isHidden, reach }, x, y);
    if (found >= 0) this.follow(ids[found]);
  }

  /** In pixels; in perspective of a dot in the middle of the box. */
  private dotRadius(stage: Stage, box: SceneBox): number {
    const radius = 0.5 * this.state.dotScale * box.spacing;
    const metres = stage.scene.metresPerPixel();
    if (metres > 0) return radius / metres;
    const [x, y, z] = box.min.map((min, i) => 0.5 * (min + box.max[i]));
    const [width, height] = stage.size;
    const spots = [z, z + radius].map((at) =>
      project(stage.scene.matrix(), x, y, at, width, height),
    );
    return Math.hypot(spots[0].x - spots[1].x, spots[0].y - spots[1].y);
  }

  private follow(id: number): void {
    this.id = id;
    void this.read();
  }

  private release(): void {
    this.id = null;
    this.panel.clear();
    this.stage().mark(null);
  }

  private async read(): Promise<void> {
    const { id, picture, state } = this;
    if (id === null || !picture) return;
    const index = indexOfId(picture.ids, id);
    if (index < 0) {
      this.panel.showMissing(id);
      this.stage().mark(null);
      return;
    }
    const point = place(sceneBox(state.particles), picture.quads, index);
    const values = await valuesOf(this.app, state.particles, picture.frame, index);
    if (picture !== this.picture || id !== this.id) return;
    this.panel.show(state.particles, id, point, values);
    const isSomewhere = point.every((x) => Number.isFinite(x));
    this.stage().mark(isSomewhere ? point : null);
    if (this.staysInView && isSomewhere) this.stage().scene.lookAt(point);
  }
}
