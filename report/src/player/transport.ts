// Time: slider, play and pause, single steps, speed, loop.
import { button, checkbox, element, field, select } from "../dom";
import type { Frame } from "../format";
import { withUnit } from "../units";
import type { PlayerState } from "./state";

const SPEEDS = [1, 2, 5, 10, 20, 30, 60];

export class Transport {
  readonly root = element("div", { class: "transport" });
  private readonly slider = element("input", {
    attributes: { type: "range", min: "0", step: "1", "aria-label": "Frame" },
  });
  private readonly time = element("output", { class: "time" });
  private readonly playing: HTMLButtonElement;
  private run = 0;
  private isPlaying = false;

  constructor(
    private readonly state: PlayerState,
    /** Shows a frame; resolves when it is drawn. */
    private readonly show: (frame: number) => Promise<void>,
  ) {
    this.playing = button("▶ Play", () => this.toggle());
    this.playing.classList.add("play");
    this.slider.addEventListener("input", () => {
      this.pause();
      void this.show(Number(this.slider.value));
    });
    const speeds = SPEEDS.map((speed) => ({ value: String(speed), text: `${speed} frames/s` }));
    const speed = select(
      "Speed",
      speeds,
      String(state.framesPerSecond),
      (value) => (state.framesPerSecond = Number(value)),
    );
    const loop = checkbox("Loop", state.isLooping, (isLooping) => (state.isLooping = isLooping));
    const steps = [
      button("|◀", () => this.step(-Infinity), "first frame"),
      button("◀", () => this.step(-1), "one frame back"),
      this.playing,
      button("▶", () => this.step(1), "one frame on"),
      button("▶|", () => this.step(Infinity), "last frame"),
    ];
    this.root.append(
      element("div", { class: "controls" }, ...steps, this.time),
      this.slider,
      element("div", { class: "controls" }, field("Speed", speed), loop),
    );
    this.update();
  }

  private get frames(): Frame[] {
    return this.state.particles.frames;
  }

  update(): void {
    const { frame } = this.state;
    const last = this.frames.length - 1;
    this.slider.max = String(Math.max(0, last));
    this.slider.value = String(frame);
    const at = this.timeText();
    this.slider.setAttribute("aria-valuetext", at);
    this.time.textContent = `${at} · frame ${frame + 1} of ${last + 1}`;
  }

  timeText(): string {
    const { frame } = this.state;
    const end = this.frames[this.frames.length - 1]?.time_s ?? 0;
    return `t = ${withUnit(this.frames[frame]?.time_s, "s", 5, end)}`;
  }

  toggle(): void {
    if (this.isPlaying) this.pause();
    else void this.play();
  }

  step(by: number): void {
    this.pause();
    const last = this.frames.length - 1;
    void this.show(Math.min(last, Math.max(0, this.state.frame + by)));
  }

  pause(): void {
    this.isPlaying = false;
    ++this.run;
    this.playing.textContent = "▶ Play";
  }

  private async play(): Promise<void> {
    const run = ++this.run;
    this.isPlaying = true;
    this.playing.textContent = "❚❚ Pause";
    if (this.state.frame >= this.frames.length - 1) await this.show(0);
    while (run === this.run) {
      const started = performance.now();
      const next = this.state.frame + 1;
      if (next >= this.frames.length && !this.state.isLooping) break;
      await this.show(next % this.frames.length);
      const rest = 1000 / this.state.framesPerSecond - (performance.now() - started);
      await new Promise((resolve) => setTimeout(resolve, Math.max(0, rest)));
    }
    if (run === this.run) this.pause();
  }
}
