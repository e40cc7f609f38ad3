// The frame of a part of the page: heading, content, and whether there is anything to show.
import { element } from "./dom";
import type { Section } from "./app";

export function makeSection(id: string, title: string, ...content: (Node | string)[]): Section {
  const heading = element("h2", { attributes: { id: `${id}-heading` } }, title);
  const root = element(
    "section",
    { attributes: { id, "aria-labelledby": `${id}-heading` } },
    heading,
    ...content,
  );
  return { id, title, root };
}

/** Draws only where `parts` have changed: what a reader has scrolled or selected stays. */
export function onlyChanged(parts: () => unknown, draw: () => void): () => void {
  let known: string | null = null;
  return () => {
    const now = JSON.stringify(parts()) ?? "";
    if (now === known) return;
    known = now;
    draw();
  };
}

/** Shows or hides a section; the list of contents follows by the event. */
export function setVisible(section: Section, isVisible: boolean): void {
  if (section.root.hidden === !isVisible) return;
  section.root.hidden = !isVisible;
  document.dispatchEvent(new Event("sections"));
}
