// Top of the page: title, what made it, list of contents, chooser of the run, dark or light.
import type { App, Section } from "./app";
import { button, element, field, select, setChoices } from "./dom";

const THEMES = ["automatic", "light", "dark"] as const;
type Theme = (typeof THEMES)[number];

function themeButton(app: App): HTMLButtonElement {
  let theme: Theme = "automatic";
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    document.documentElement.dataset.theme =
      theme === "automatic" ? (dark.matches ? "dark" : "light") : theme;
    made.textContent = `Theme: ${theme}`;
    app.tell("theme");
  };
  const made = button("", () => {
    theme = THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length];
    apply();
  });
  made.id = "theme";
  dark.addEventListener("change", apply);
  apply();
  return made;
}

function contents(sections: Section[]): HTMLElement {
  const list = element("ul");
  const draw = () => {
    const links = sections
      .filter((s) => !s.root.hidden)
      .map((s) => element("li", {}, element("a", { attributes: { href: `#${s.id}` } }, s.title)));
    list.replaceChildren(...links);
  };
  document.addEventListener("sections", draw);
  draw();
  return element("nav", { attributes: { "aria-label": "Contents" } }, list);
}

function runChooser(app: App): HTMLElement {
  const list = select("Run", [], "", (name) => app.choose(name));
  list.id = "run";
  const holder = field("Run", list);
  const draw = () => {
    const { runs } = app.report;
    holder.hidden = runs.length < 2;
    if (document.activeElement !== list)
      setChoices(
        list,
        runs.map((run) => ({ value: run.name, text: run.title || run.name })),
        app.run?.name ?? "",
      );
  };
  holder.title = "for quality, particles, energy, computing time, stages and settings";
  app.on(["data", "run"], draw);
  draw();
  return holder;
}

function titleOf(app: App): string {
  const { runs, sweep } = app.report;
  if (sweep) return sweep.title;
  if (runs.length === 0) return "Waiting for the program";
  if (runs.length === 1) return runs[0].title || runs[0].name;
  return `${runs.length} runs: ${runs
    .map((run) => run.title || run.name)
    .slice(0, 4)
    .join(" · ")}${runs.length > 4 ? " …" : ""}`;
}

function madeText(app: App): string {
  const { program, made } = app.report;
  const date = new Date(made);
  const when = Number.isNaN(date.getTime())
    ? made
    : `${date.toISOString().slice(0, 16).replace("T", " ")} UTC`;
  const revision = program.revision ? ` (${program.revision})` : "";
  return `${program.name} ${program.version}${revision} · ${when}`;
}

export function makeHeader(app: App, sections: Section[]): HTMLElement {
  const title = element("h1");
  const made = element("p", { class: "made" });
  const draw = () => {
    title.textContent = titleOf(app);
    made.textContent = madeText(app);
  };
  app.on(["data"], draw);
  draw();
  const top = element("div", { class: "top" }, element("div", {}, title, made), themeButton(app));
  const bar = element("div", { class: "bar-of-contents" }, contents(sections), runChooser(app));
  return element("header", {}, top, bar);
}
