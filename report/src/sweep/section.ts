import type { App, Section } from "../app";
import { makeSection, setVisible } from "../section";
export function sweepSection(_app: App): Section {
  const section = makeSection("sweep", "Sweep");
  setVisible(section, false);
  return section;
}
