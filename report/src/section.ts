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

/** Shows or hides a section; the list of contents follows by the event. */
export function setVisible(section: Section, isVisible: boolean): void {
  if (section.root.hidden === !isVisible) return;
  section.root.hidden = !isVisible;
  document.dispatchEvent(new Event("sections"));
}
