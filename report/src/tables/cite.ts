// How to cite, with buttons that copy.
import type { App, Section } from "../app";
import { announce, button, element } from "../dom";
import { makeSection, setVisible } from "../section";

async function copy(text: string, source: HTMLElement): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    announce("Copied");
    source.dataset.copied = "yes";
  } catch {
    // A page from a file may not write to the clipboard in every browser: select it instead.
    getSelection()?.selectAllChildren(source);
    announce("Selected; copy with the keyboard");
  }
}

function entry(title: string, text: string): HTMLElement {
  const shown = element("pre", { attributes: { tabindex: "0" } }, text);
  const done = element("span", { class: "hint" });
  const copying = button(`Copy ${title}`, () => {
    void copy(text, shown).then(() => {
      done.textContent = shown.dataset.copied ? "copied" : "selected: copy with the keyboard";
    });
  });
  return element(
    "div",
    { class: "citation" },
    shown,
    element("p", { class: "controls" }, copying, done),
  );
}

export function citeSection(app: App): Section {
  const content = element("div");
  const section = makeSection("cite", "How to cite", content);
  const { text, bibtex } = app.report.cite;
  if (text) content.append(entry("text", text));
  if (bibtex) content.append(entry("BibTeX", bibtex));
  setVisible(section, content.childElementCount > 0);
  return section;
}
