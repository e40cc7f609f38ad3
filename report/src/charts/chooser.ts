// Which columns a chart shows: a search field over check boxes, grouped by gauge.
import { button, element, field } from "../dom";
import { typesetUnit, words } from "../units";
import type { Available } from "./curves";

/** More boxes than this open only their groups' heads. */
const OPEN_AT_MOST = 40;

function groups(columns: Available[]): Map<string, Available[]> {
  const found = new Map<string, Available[]>();
  for (const entry of columns) {
    const { gauge, group } = entry.column;
    const name = gauge
      ? group
        ? `${gauge} (${words(group)})`
        : gauge
      : `${words(entry.table)}: ${words(group)}`;
    found.set(name, [...(found.get(name) ?? []), entry]);
  }
  return found;
}

export class Chooser {
  readonly root: HTMLElement;
  private readonly search = element("input", {
    attributes: { type: "search", placeholder: "gauge or quantity" },
  });
  private readonly list = element("div", { class: "groups" });
  private drawnFor = "";

  constructor(
    private columns: Available[],
    private chosen: Set<string>,
    private readonly changed: (chosen: Set<string>) => void,
  ) {
    const all = button("all found", () => this.setAll(true));
    const none = button("none", () => this.setAll(false));
    this.root = element(
      "div",
      { class: "chooser" },
      element("div", { class: "controls" }, field("Search", this.search), all, none),
      this.list,
    );
    this.search.addEventListener("input", () => this.draw());
  }

  /** New data: boxes are made anew only where columns have come or gone. */
  update(columns: Available[], chosen: Set<string>): void {
    this.columns = columns;
    this.chosen = chosen;
    const now = columns.map((entry) => entry.key).join("\n\n");
    if (now !== this.drawnFor) {
      this.drawnFor = now;
      this.draw();
    }
  }

  private get found(): Available[] {
    const wanted = this.search.value.toLowerCase().split(/\s+/);
    return this.columns.filter(({ column, table }) => {
      const text = words(
        `${table} ${column.label} ${column.gauge} ${column.group} ${column.unit}`,
      ).toLowerCase();
      return wanted.every((word) => text.includes(word));
    });
  }

  private setAll(isChosen: boolean): void {
    for (const { key } of this.found) {
      if (isChosen) this.chosen.add(key);
      else this.chosen.delete(key);
    }
    this.draw();
    this.changed(this.chosen);
  }

  private draw(): void {
    const found = this.found;
    this.list.replaceChildren();
    for (const [name, entries] of groups(found)) {
      const boxes = entries.map((entry) => this.box(entry));
      const isOpen =
        found.length <= OPEN_AT_MOST || entries.some(({ key }) => this.chosen.has(key));
      const group = element(
        "details",
        isOpen ? { attributes: { open: "" } } : {},
        element("summary", {}, name),
        ...boxes,
      );
      this.list.append(group);
    }
    if (found.length === 0)
      this.list.append(element("p", { class: "hint" }, "Nothing by that name."));
  }

  private box({ key, column }: Available): HTMLElement {
    const box = element("input", { attributes: { type: "checkbox" } });
    box.checked = this.chosen.has(key);
    box.addEventListener("change", () => {
      if (box.checked) this.chosen.add(key);
      else this.chosen.delete(key);
      this.changed(this.chosen);
    });
    const unit = column.unit ? ` [${typesetUnit(column.unit)}]` : "";
    return element(
      "label",
      { class: "check" },
      box,
      element("span", {}, `${words(column.name || column.label)}${unit}`),
    );
  }
}
