// What all parts of the page share: the data, the chosen run, and who wants to hear of changes.
import { Blocks } from "./blocks";
import type { Report, Run } from "./format";

/**
 * data: new live data; run: another run chosen; shown: other curves overlaid; theme; time: of the
 * player.
 */
export type Change = "data" | "run" | "shown" | "theme" | "time";

export class App {
  readonly blocks: Blocks;
  /** Time of the player's frame [s], a line in the charts. */
  playerTime: number | null = null;
  private chosen = "";
  /**
   * Names of the runs whose curves are drawn; null until somebody chooses, then new runs stay out.
   */
  private overlaid: Set<string> | null = null;
  private readonly listeners = new Map<Change, Set<() => void>>();

  constructor(public report: Report) {
    this.blocks = new Blocks(report.live ? (report.blocks ?? {}) : null);
  }

  on(changes: Change[], listener: () => void): void {
    for (const change of changes) {
      const known = this.listeners.get(change) ?? new Set();
      this.listeners.set(change, known.add(listener));
    }
  }

  tell(change: Change): void {
    for (const listener of this.listeners.get(change) ?? []) listener();
  }

  get run(): Run | null {
    return this.report.runs.find((run) => run.name === this.chosen) ?? this.report.runs[0] ?? null;
  }

  choose(name: string): void {
    if (this.run?.name === name) return;
    this.chosen = name;
    this.playerTime = null;
    this.tell("run");
  }

  /** Runs whose curves are drawn over each other. */
  get shown(): Run[] {
    const { runs } = this.report;
    if (this.overlaid) return runs.filter((run) => this.overlaid?.has(run.name));
    return runs.slice(0, MOST_RUNS_AT_FIRST);
  }

  isShown(run: Run): boolean {
    return this.shown.includes(run);
  }

  show(names: string[], isShown: boolean): void {
    this.overlaid ??= new Set(this.shown.map((run) => run.name));
    for (const name of names) {
      if (isShown) this.overlaid.add(name);
      else this.overlaid.delete(name);
    }
    this.tell("shown");
  }

  showOnly(names: string[]): void {
    this.overlaid = new Set(names);
    this.tell("shown");
  }

  /** New live data. */
  replace(report: Report): void {
    this.blocks.replace(report.blocks ?? {});
    this.report = report;
    this.tell("data");
  }
}

/** More curves than this over each other are read by nobody; all runs can be chosen by hand. */
const MOST_RUNS_AT_FIRST = 8;

/** A part of the page. It hides itself where there is nothing to show. */
export interface Section {
  id: string;
  title: string;
  root: HTMLElement;
}
