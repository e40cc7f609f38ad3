// The player by keys alone.
import type { Stage } from "./stage";
import type { Transport } from "./transport";

export function addPlayerKeys(
  stage: Stage,
  transport: Transport,
  resetView: (axis: number) => void,
  stepped: () => void,
): void {
  const { scene } = stage;
  const step = (by: number) => () => {
    transport.step(by);
    // The step loads first; announced is where it arrives.
    setTimeout(stepped, 300);
  };
  const plain: Record<string, () => void> = {
    ArrowLeft: step(-1),
    ArrowRight: step(1),
    PageDown: step(10),
    PageUp: step(-10),
    Home: step(-Infinity),
    End: step(Infinity),
    " ": () => transport.toggle(),
    "+": () => scene.zoom(1.2),
    "-": () => scene.zoom(1 / 1.2),
    "0": () => resetView(-1),
  };
  const shifted: Record<string, () => void> = {
    ArrowLeft: () => scene.turn(-1, 0),
    ArrowRight: () => scene.turn(1, 0),
    ArrowUp: () => scene.turn(0, 1),
    ArrowDown: () => scene.turn(0, -1),
  };
  stage.root.addEventListener("keydown", (event) => {
    if (event.target !== stage.root || event.altKey || event.metaKey || event.ctrlKey) return;
    const action = (event.shiftKey ? shifted[event.key] : undefined) ?? plain[event.key];
    if (!action) return;
    event.preventDefault();
    action();
    stage.draw();
  });
  stage.root.setAttribute(
    "aria-label",
    "Particles. Left and right step the frames, space plays, plus and minus zoom, zero shows all, shift and arrows turn or move the view.",
  );
}
