// A verdict by word and shape; the colour only repeats it.
import { element } from "../dom";
import type { Verdict } from "../format";

const SHAPES: Record<Verdict, string> = { good: "●", doubtful: "▲", bad: "✖", unknown: "○" };

export function verdictMark(verdict: Verdict): HTMLElement {
  const known = verdict in SHAPES ? verdict : "unknown";
  return element(
    "span",
    { class: `verdict ${known}` },
    element("span", { class: "shape", attributes: { "aria-hidden": "true" } }, SHAPES[known]),
    element("span", {}, known),
  );
}
