// The page: reads the data, makes its sections, and follows a running program.
import { App } from "./app";
import { chartsSection } from "./charts/section";
import { element } from "./dom";
import { requireReport, type Report } from "./format";
import { makeHeader } from "./header";
import { followProgram } from "./live";
import { measuresSection } from "./measures/section";
import { playerSection } from "./player/section";
import { citeSection } from "./tables/cite";
import { energySection } from "./energy/section";
import { factsSection } from "./tables/facts";
import { qualitySection } from "./tables/quality";
import { settingsSection } from "./tables/settings";
import { sweepSection } from "./sweep/section";
import { stagesSection, timingSection } from "./tables/timing";

const SECTIONS = [
  qualitySection,
  sweepSection,
  factsSection,
  chartsSection,
  measuresSection,
  playerSection,
  energySection,
  timingSection,
  stagesSection,
  settingsSection,
  citeSection,
];

function readReport(): Report {
  const text = document.getElementById("report")?.textContent;
  if (!text) throw new Error("there are no data in this page");
  return requireReport(JSON.parse(text));
}

function start(main: HTMLElement): void {
  const app = new App(readReport());
  const sections = SECTIONS.map((make) => make(app));
  const header = makeHeader(app, sections);
  main.replaceChildren(...sections.map((section) => section.root));
  document.body.insertBefore(header, main);
  if (app.report.live) followProgram(app, header);
}

const main = document.querySelector("main");
if (main) {
  try {
    start(main);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    main.replaceChildren(
      element("p", { class: "problem" }, `This report cannot be shown: ${reason}.`),
    );
  }
}
