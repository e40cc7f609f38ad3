// A slice through three dimensions: axis, place and thickness.
import { element, field, select } from "../dom";
import { withUnit } from "../units";
import type { SceneBox, Slice } from "./scene_interface";

const STEPS = 1000;

export class SlicePanel {
  readonly root = element("fieldset", {}, element("legend", {}, "Slice"));
  private axis = -1;
  private readonly place = slider("Place of the slice", 500);
  private readonly thickness = slider("Thickness of the slice", 100);
  private readonly text = element("output");
  private readonly sliders: HTMLElement;

  constructor(
    private box: SceneBox,
    private readonly changed: (slice: Slice | null) => void,
  ) {
    const choices = [
      { value: "-1", text: "none" },
      ...["x", "y", "z"].map((text, i) => ({ value: String(i), text })),
    ];
    const axis = select("Axis of the slice", choices, "-1", (value) => {
      this.axis = Number(value);
      this.tell();
    });
    for (const input of [this.place, this.thickness])
      input.addEventListener("input", () => this.tell());
    this.sliders = element(
      "div",
      {},
      field("Place", this.place),
      field("Thickness", this.thickness),
      this.text,
    );
    this.sliders.hidden = true;
    this.root.append(field("Across", axis), this.sliders);
  }

  setBox(box: SceneBox): void {
    this.box = box;
    if (this.axis >= 0) this.tell();
  }

  private tell(): void {
    this.sliders.hidden = this.axis < 0;
    if (this.axis < 0) {
      this.changed(null);
      return;
    }
    const [min, max] = [this.box.min[this.axis], this.box.max[this.axis]];
    const middle = min + (Number(this.place.value) / STEPS) * (max - min);
    // Thinner than a particle distance a slice would fall between the particles.
    const half =
      0.5 * Math.max(this.box.spacing, (Number(this.thickness.value) / STEPS) * (max - min));
    const name = "xyz"[this.axis];
    this.text.textContent = `${name} = ${withUnit(middle, "m", 4)} ± ${withUnit(half, "m", 3)}`;
    this.changed({ axis: this.axis, low: middle - half, high: middle + half });
  }
}

function slider(label: string, value: number): HTMLInputElement {
  return element("input", {
    attributes: {
      type: "range",
      min: "0",
      max: String(STEPS),
      value: String(value),
      "aria-label": label,
    },
  });
}
