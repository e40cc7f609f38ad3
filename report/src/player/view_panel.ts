// How the picture is drawn: size of the dots, walls, probes, where it is seen from.
import { button, checkbox, element, field, select } from "../dom";
import type { Particles } from "../format";
import type { PlayerState } from "./state";

export interface ViewEvents {
  resized(): void;
  wallsSwitched(): void;
  probesSwitched(): void;
  /** Seen along an axis; -1: from where all is seen. */
  resetView(axis: number): void;
  savePicture(): void;
}

/** Diameters of dots in particle distances. */
const SIZES = [0.5, 1, 1.5, 2, 3];

export function viewPanel(
  particles: Particles,
  state: PlayerState,
  events: ViewEvents,
): HTMLElement {
  const sizes = SIZES.map((size) => ({ value: String(size), text: `${size} × distance` }));
  const size = select("Size of the dots", sizes, "1", (value) => {
    state.dotScale = Number(value);
    events.resized();
  });
  const walls = checkbox("Walls", true, (shows) => {
    state.showsWalls = shows;
    events.wallsSwitched();
  });
  const probes = checkbox("Probes", true, (shows) => {
    state.showsProbes = shows;
    events.probesSwitched();
  });
  const axes = particles.dimension === 3 ? ["x", "y", "z"] : [];
  const views = axes.map((name, axis) => button(`along ${name}`, () => events.resetView(axis)));
  const whole = button("Whole", () => events.resetView(-1));
  const picture = button("PNG", () => events.savePicture(), "save the picture");
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
    element("div", { class: "controls" }, whole, ...views, picture),
  );
}
