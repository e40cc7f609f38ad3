// The picked particle: its number, place and all its values, followed through the frames.
import { button, checkbox, element, field } from "../dom";
import type { Particles } from "../format";
import { formatNumber, words } from "../units";
import { stepOf, withResolution } from "./resolution";

export interface PickedEvents {
  find(id: number): void;
  release(): void;
  stayInView(stays: boolean): void;
}

export class PickedPanel {
  readonly root = element("fieldset", {}, element("legend", {}, "Particle"));
  private readonly id = element("input", {
    attributes: { type: "text", inputmode: "numeric", size: "9", placeholder: "number" },
  });
  private readonly values = element("dl", { class: "values", attributes: { role: "status" } });
  private readonly more: HTMLElement;

  constructor(private readonly events: PickedEvents) {
    const find = () => {
      const id = Number(this.id.value);
      if (Number.isInteger(id) && this.id.value.trim() !== "") this.events.find(id);
    };
    this.id.addEventListener("keydown", (event) => event.key === "Enter" && find());
    const stay = checkbox("keep in view", false, (stays) => this.events.stayInView(stays));
    this.more = element(
      "div",
      { class: "controls" },
      stay,
      button("Release", () => this.events.release()),
    );
    this.root.append(
      element("div", { class: "controls" }, field("Id", this.id), button("Follow", find)),
      this.values,
      this.more,
    );
    this.clear();
  }

  clear(): void {
    this.more.hidden = true;
    this.values.replaceChildren(
      element("p", { class: "hint" }, "Click a particle to read its values and follow it."),
    );
  }

  showMissing(id: number): void {
    this.id.value = String(id);
    this.more.hidden = false;
    this.values.replaceChildren(
      element("p", { class: "hint" }, `Particle ${id} is not in this frame.`),
    );
  }

  show(particles: Particles, id: number, position: number[], values: number[]): void {
    this.id.value = String(id);
    this.more.hidden = false;
    const rows: [string, string][] = [["id", String(id)]];
    position.slice(0, particles.dimension).forEach((x, axis) => {
      const step = stepOf(particles.box.min[axis], particles.box.max[axis]);
      rows.push(["xyz"[axis], withResolution(x, step, "m", 5)]);
    });
    particles.fields.forEach((f, i) => {
      const isMaterial = f.name === "material" && f.kind === "category";
      const name = isMaterial ? (particles.materials[values[i]] ?? String(values[i])) : null;
      rows.push([
        words(f.name),
        name ??
          (f.kind === "category"
            ? formatNumber(values[i], 9)
            : withResolution(values[i], stepOf(f.min, f.max), f.unit, 4)),
      ]);
    });
    this.values.replaceChildren(
      ...rows.map(([label, value]) =>
        element("div", {}, element("dt", {}, label), element("dd", {}, value)),
      ),
    );
  }
}
