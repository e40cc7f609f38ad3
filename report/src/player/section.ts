// The player of the chosen run, or the reason why there is none.
import type { App, Section } from "../app";
import { element } from "../dom";
import { makeSection, setVisible } from "../section";
import { Player } from "./player";

/** Asked once: each question takes one of the few contexts that a browser gives to a page. */
let known: boolean | null = null;

function hasWebGL(): boolean {
  known ??= document.createElement("canvas").getContext("webgl2") !== null;
  return known;
}

const NO_PLAYER = "This page was written without the part that draws particles.";
const NO_WEBGL =
  "This browser cannot draw particles: it has no WebGL 2, or it is switched off. All other parts of the page work without it.";

export function playerSection(app: App): Section {
  const content = element("div");
  const help = element(
    "p",
    { class: "hint" },
    "Drag to turn or move, click to read a particle. Click the picture, or hold Ctrl, to zoom with the wheel. Keys: ← → step, space plays, + − zoom, 0 all, Shift + arrows turn or move.",
  );
  const section = makeSection("particles", "Particles", content, help);
  let player: Player | null = null;
  let shownRun = "";

  const start = () => {
    const run = app.run;
    const particles = run?.particles;
    setVisible(section, Boolean(particles && particles.frames.length > 0));
    if (!run || !particles || particles.frames.length === 0) return;
    if (player && shownRun === run.name) {
      player.update(run, particles);
      return;
    }
    player?.stop();
    player = null;
    shownRun = run.name;
    const make = window.moraineScene;
    help.hidden = !make || !hasWebGL();
    if (!make || !hasWebGL()) {
      content.replaceChildren(
        element("p", { class: "problem" }, make ? NO_WEBGL : NO_PLAYER),
        element("p", { class: "note" }, particles.note),
      );
      return;
    }
    player = new Player(app, run, particles, make);
    content.replaceChildren(player.root);
  };
  app.on(["data", "run"], start);
  app.on(["theme"], () => player?.setTheme());
  start();
  return section;
}
