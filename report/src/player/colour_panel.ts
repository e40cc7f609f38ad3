// What the colours stand for: field, range, colour bar; for categories a legend that also hides.
import { checkbox, element, field, select, setChoices } from "../dom";
import { displayUnit, formatNumber, typesetUnit, words } from "../units";
import { categoryColour, viridis } from "./colours";
import type { PlayerState, RangeMode } from "./state";

const MODES: { value: RangeMode; text: string }[] = [
  { value: "all", text: "of all frames" },
  { value: "frame", text: "of this frame" },
  { value: "typed", text: "typed" },
];

export class ColourPanel {
  readonly root = element("fieldset", {}, element("legend", {}, "Colour"));
  private readonly fields: HTMLSelectElement;
  private readonly modes: HTMLSelectElement;
  private readonly ends = ["lowest", "highest"].map((name) =>
    element("input", {
      attributes: {
        type: "text",
        inputmode: "decimal",
        "aria-label": `${name} value of the colours`,
      },
    }),
  );
  private readonly bar = element("canvas", {
    class: "colour-bar",
    attributes: { width: "256", height: "1", role: "img" },
  });
  private readonly ticks = element("div", { class: "ticks" });
  private readonly range = element("div", { class: "range" });
  private readonly legend = element("div", { class: "legend" });

  constructor(
    private readonly state: PlayerState,
    private readonly changed: (isOtherField: boolean) => void,
  ) {
    this.fields = select("Colour by", [], "", (value) => {
      state.field = Number(value);
      state.rangeMode = "all";
      state.hidden.clear();
      this.changed(true);
    });
    this.modes = select("Range", MODES, "all", (value) => {
      state.typed = state.range();
      state.rangeMode = value as RangeMode;
      this.changed(false);
    });
    for (const end of this.ends) end.addEventListener("change", () => this.readEnds());
    this.range.append(
      this.bar,
      this.ticks,
      field("Range", this.modes),
      element("div", { class: "ends" }, this.ends[0], element("span", {}, "to"), this.ends[1]),
    );
    this.root.append(field("By", this.fields), this.range, this.legend);
    drawBar(this.bar);
    this.update();
  }

  update(): void {
    const { state } = this;
    const choices = state.particles.fields.map((f, i) => ({
      value: String(i),
      text: `${words(f.name)}${f.unit ? ` [${typesetUnit(f.unit)}]` : ""}`,
    }));
    setChoices(this.fields, choices, String(state.field));
    this.modes.value = state.rangeMode;
    this.range.hidden = state.isCategory || !state.fieldOf;
    this.legend.hidden = !state.isCategory;
    if (state.isCategory) this.drawLegend();
    else this.drawTicks();
  }

  private drawTicks(): void {
    const [low, high] = this.state.range();
    const unit = displayUnit(
      this.state.fieldOf?.unit ?? "",
      Math.max(Math.abs(low), Math.abs(high)),
    );
    const at = [0, 0.5, 1].map((share) => low + share * (high - low));
    this.ticks.replaceChildren(
      ...at.map((value) => element("span", {}, formatNumber(value / unit.factor, 4))),
    );
    this.bar.setAttribute(
      "aria-label",
      `colours from ${formatNumber(low / unit.factor, 4)} to ${formatNumber(high / unit.factor, 4)} ${unit.unit}`,
    );
    this.ticks.append(element("span", { class: "unit" }, unit.unit));
    this.ends.forEach((end, i) => {
      if (document.activeElement !== end) end.value = String(Number([low, high][i].toPrecision(6)));
      end.title = `in ${typesetUnit(this.state.fieldOf?.unit ?? "")}`;
    });
  }

  private drawLegend(): void {
    const { state } = this;
    const isMaterial = state.fieldOf?.name === "material";
    const count = Math.max(
      isMaterial ? state.particles.materials.length : 0,
      (state.fieldOf?.max ?? 0) + 1,
    );
    const entries = Array.from({ length: Math.min(count, 64) }, (_, i) => {
      const name = (isMaterial && state.particles.materials[i]) || String(i);
      const entry = checkbox(name, !state.hidden.has(i), (isShown) => {
        if (isShown) state.hidden.delete(i);
        else state.hidden.add(i);
        this.changed(false);
      });
      entry.style.setProperty("--swatch", categoryColour(i));
      entry.classList.add("swatched");
      return entry;
    });
    if (!this.legend.contains(document.activeElement)) this.legend.replaceChildren(...entries);
  }

  private readEnds(): void {
    const typed = this.ends.map((end) => Number(end.value.replace(",", ".")));
    const isUsable = typed.every(Number.isFinite) && typed[0] < typed[1];
    for (const end of this.ends) end.setAttribute("aria-invalid", String(!isUsable));
    if (!isUsable) return;
    this.state.typed = [typed[0], typed[1]];
    this.state.rangeMode = "typed";
    this.changed(false);
  }
}

function drawBar(bar: HTMLCanvasElement): void {
  const context = bar.getContext("2d");
  if (!context) return;
  const pixels = context.createImageData(256, 1);
  pixels.data.set(viridis());
  context.putImageData(pixels, 0, 0);
}
