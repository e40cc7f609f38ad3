// Making elements. Texts become text nodes; nothing here or elsewhere reads markup from data.

type Child = Node | string | null | undefined | false;

interface Properties {
  class?: string;
  attributes?: Record<string, string>;
  on?: { [K in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[K]) => void };
}

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  properties: Properties = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (properties.class) made.className = properties.class;
  for (const [name, value] of Object.entries(properties.attributes ?? {}))
    made.setAttribute(name, value);
  for (const [name, listener] of Object.entries(properties.on ?? {})) {
    made.addEventListener(name, listener as EventListener);
  }
  append(made, ...children);
  return made;
}

export function append(parent: HTMLElement, ...children: Child[]): void {
  for (const child of children)
    if (child !== null && child !== undefined && child !== false) parent.append(child);
}

export function button(text: string, action: () => void, title = ""): HTMLButtonElement {
  const made = element("button", { attributes: { type: "button" }, on: { click: action } }, text);
  if (title) {
    made.title = title;
    if (text.length <= 2) made.setAttribute("aria-label", title);
  }
  return made;
}

export function toggle(
  text: string,
  pressed: boolean,
  action: (pressed: boolean) => void,
  title = "",
): HTMLButtonElement {
  const made = button(
    text,
    () => {
      const now = made.getAttribute("aria-pressed") !== "true";
      made.setAttribute("aria-pressed", String(now));
      action(now);
    },
    title,
  );
  made.setAttribute("aria-pressed", String(pressed));
  return made;
}

export function checkbox(
  text: string,
  checked: boolean,
  action: (checked: boolean) => void,
): HTMLLabelElement {
  const box = element("input", { attributes: { type: "checkbox" } });
  box.checked = checked;
  box.addEventListener("change", () => action(box.checked));
  return element("label", { class: "check" }, box, element("span", {}, text));
}

export interface Choice {
  value: string;
  text: string;
}

export function select(
  label: string,
  choices: Choice[],
  chosen: string,
  action: (value: string) => void,
): HTMLSelectElement {
  const made = element("select", { attributes: { "aria-label": label } });
  setChoices(made, choices, chosen);
  made.addEventListener("change", () => action(made.value));
  return made;
}

export function setChoices(list: HTMLSelectElement, choices: Choice[], chosen: string): void {
  const options = choices.map(({ value, text }) =>
    element("option", { attributes: { value } }, text),
  );
  list.replaceChildren(...options);
  list.value = chosen;
}

export function field(text: string, control: HTMLElement): HTMLLabelElement {
  return element("label", { class: "field" }, element("span", {}, text), control);
}

/**
 * A table with a head and rows of cells; numbers, given as such in `numeric`, are set to the right.
 */
export function table(
  caption: string,
  head: string[],
  rows: Child[][],
  numeric: number[] = [],
): HTMLElement {
  const cell = (tag: "td" | "th", content: Child, column: number) => {
    const made = element(tag, numeric.includes(column) ? { class: "number" } : {}, content);
    if (tag === "td") made.dataset.label = head[column];
    if (tag === "th") made.setAttribute("scope", "col");
    return made;
  };
  const made = element(
    "table",
    {},
    element("caption", { class: "unseen" }, caption),
    element("thead", {}, element("tr", {}, ...head.map((text, i) => cell("th", text, i)))),
    element(
      "tbody",
      {},
      ...rows.map((row) => element("tr", {}, ...row.map((content, i) => cell("td", content, i)))),
    ),
  );
  return scroller(caption, made);
}

/** The same; on a narrow screen each row becomes a short paragraph. */
export function stackedTable(...given: Parameters<typeof table>): HTMLElement {
  const made = table(...given);
  made.classList.add("stack");
  return made;
}

/** Wide content scrolls inside its own frame, which the keyboard must reach too. */
export function scroller(label: string, content: HTMLElement): HTMLElement {
  return element(
    "div",
    { class: "scroller", attributes: { tabindex: "0", role: "region", "aria-label": label } },
    content,
  );
}

/** Says a text to screen readers. */
export function announce(text: string): void {
  let region = document.getElementById("announcer");
  if (!region) {
    region = element("div", {
      class: "unseen",
      attributes: { id: "announcer", "aria-live": "polite" },
    });
    document.body.append(region);
  }
  region.textContent = text;
}

export function styleColour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
