// Following a running program: asks for its data, shows how far it is, and says when it ends or is
// silent.
import type { App } from "./app";
import { element } from "./dom";
import { requireReport, type Progress, type Report, type Run } from "./format";
import { stateText } from "./tables/facts";
import { duration, formatNumber, withUnit } from "./units";

/** As many missing answers in a row as make the program count as gone. */
const SILENT_AFTER = 3;

function progressBar(progress: Progress): HTMLElement {
  const share = progress.end_time_s > 0 ? Math.min(1, progress.time_s / progress.end_time_s) : 0;
  const bar = element("progress", {
    attributes: { max: "1", "aria-label": "Progress of the run" },
  });
  bar.value = share;
  const facts: [string, string][] = [
    [
      "time",
      `${withUnit(progress.time_s, "s", 4, progress.end_time_s)} of ${withUnit(progress.end_time_s, "s", 4)}`,
    ],
    ["done", `${(100 * share).toFixed(1)}\u00a0%`],
    ["time left", progress.time_left_s === null ? "–" : duration(progress.time_left_s)],
    [
      "steps",
      `${formatNumber(progress.step, 9)}${progress.steps_per_second === null ? "" : `, ${formatNumber(progress.steps_per_second, 3)} a second`}`,
    ],
    [
      "time step",
      `${withUnit(progress.time_step_s, "s", 3)}, limited by ${progress.limited_by || "–"}`,
    ],
    ["particles", formatNumber(progress.particles, 9)],
  ];
  const list = element("dl", { class: "facts" });
  for (const [label, value] of facts)
    list.append(element("div", {}, element("dt", {}, label), element("dd", {}, value)));
  return element("div", { class: "progress" }, bar, list);
}

function runState(run: Run): HTMLElement {
  if (run.progress && run.state === "running") return progressBar(run.progress);
  return element("p", {}, `${run.title || run.name} has ${stateText(run)}.`);
}

class Follower {
  readonly root = element("div", { class: "live" });
  private readonly message = element(
    "p",
    { class: "live-message", attributes: { role: "status" } },
    "Asking the program for its data …",
  );
  private readonly runs = element("div");
  private missed = 0;
  private lastAnswer = "";
  /** Why the last answer cannot be shown, or "". */
  private problem = "";

  constructor(
    private readonly app: App,
    private readonly address: string,
    private readonly interval: number,
  ) {
    this.root.append(this.message, this.runs);
  }

  async poll(): Promise<void> {
    try {
      const news = await this.ask();
      this.missed = 0;
      this.lastAnswer = new Date().toLocaleTimeString();
      if (news) this.show(news);
      if (!this.problem) this.sayState();
    } catch {
      ++this.missed;
      if (this.missed >= SILENT_AFTER) this.saySilent();
    }
    // A silent program may come back, an ended one only if the reader starts it again.
    const pause = this.missed >= SILENT_AFTER || this.hasEnded() ? 4 : 1;
    setTimeout(() => void this.poll(), 1000 * this.interval * pause);
  }

  /** The program's data; null where nothing has changed. */
  private async ask(): Promise<Report | null> {
    const { revision } = this.app.report;
    const known = this.lastAnswer !== "" && revision !== undefined;
    const mark = this.address.includes("?") ? "&" : "?";
    const address = known ? `${this.address}${mark}since=${revision}` : this.address;
    const answer = await fetch(address, { cache: "no-store" });
    if (answer.status === 304) return null;
    if (!answer.ok) throw new Error(`status ${answer.status}`);
    return (await answer.json()) as Report;
  }

  private show(news: Report): void {
    this.problem = "";
    try {
      const report = requireReport(news);
      this.app.replace({ ...report, live: this.app.report.live });
      this.runs.replaceChildren(...report.runs.map(runState));
    } catch (error) {
      this.problem = error instanceof Error ? error.message : String(error);
      this.say(`The program's answer cannot be shown: ${this.problem}.`, true);
    }
  }

  private sayState(): void {
    const text = this.hasEnded()
      ? "The run has ended. This page shows its last state."
      : `Live; last answer ${this.lastAnswer}.`;
    this.say(text);
  }

  private hasEnded(): boolean {
    const { runs } = this.app.report;
    return runs.length > 0 && runs.every((run) => run.state !== "running");
  }

  private saySilent(): void {
    const since = this.lastAnswer
      ? ` Its last answer came at ${this.lastAnswer}; what it said until then stays here.`
      : "";
    const end = this.hasEnded()
      ? "The run has ended, and the program with it."
      : "The program no longer answers.";
    this.say(end + since, !this.hasEnded());
  }

  private say(text: string, isProblem = false): void {
    if (this.message.textContent !== text) this.message.textContent = text;
    this.message.classList.toggle("problem", isProblem);
  }
}

export function followProgram(app: App, header: HTMLElement): void {
  const { live } = app.report;
  if (!live) return;
  const follower = new Follower(app, live.data, Math.max(0.2, live.interval_s));
  header.after(follower.root);
  void follower.poll();
}
