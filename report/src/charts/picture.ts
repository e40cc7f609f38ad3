// A chart as a picture: title, plot and legend on one canvas.
import { styleColour } from "../dom";
import type { Entry } from "./reading";

const MARGIN = 14;
const LINE = 20;
const FONT = "13px system-ui, sans-serif";
const ENTRY_GAP = 24;

interface Placed {
  entry: Entry;
  x: number;
  y: number;
}

function placeEntries(
  context: CanvasRenderingContext2D,
  entries: Entry[],
  width: number,
): Placed[] {
  let [x, y] = [MARGIN, 0];
  return entries.map((entry) => {
    const need = 34 + context.measureText(entry.name).width + ENTRY_GAP;
    if (x > MARGIN && x + need > width) [x, y] = [MARGIN, y + LINE];
    const placed = { entry, x, y };
    x += need;
    return placed;
  });
}

function drawEntry(context: CanvasRenderingContext2D, { entry, x, y }: Placed, top: number): void {
  context.strokeStyle = entry.style.colour;
  context.lineWidth = 2;
  context.setLineDash(entry.curve.isDots ? [] : entry.style.dash);
  context.beginPath();
  if (entry.curve.isDots) context.arc(x + 13, top + y + 10, 3, 0, 2 * Math.PI);
  else {
    context.moveTo(x, top + y + 10);
    context.lineTo(x + 26, top + y + 10);
  }
  context.stroke();
  context.fillStyle = entry.style.colour;
  if (entry.curve.isDots && entry.style.isFilled) context.fill();
  context.setLineDash([]);
  context.fillStyle = styleColour("--text");
  context.fillText(entry.name, x + 34, top + y + 14);
}

export function chartPicture(
  title: string,
  plot: HTMLCanvasElement,
  entries: Entry[],
): HTMLCanvasElement {
  const ratio = devicePixelRatio || 1;
  const [width, height] = [plot.width / ratio, plot.height / ratio];
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  context.font = FONT;
  const placed = placeEntries(context, entries, width);
  const legend = placed.length > 0 ? placed[placed.length - 1].y + LINE : 0;
  const total = MARGIN + LINE + height + legend + MARGIN;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(total * ratio);
  context.scale(ratio, ratio);
  context.fillStyle = styleColour("--background");
  context.fillRect(0, 0, width, total);
  context.fillStyle = styleColour("--text");
  context.font = `600 ${FONT}`;
  context.fillText(title, MARGIN, MARGIN + 10);
  context.drawImage(plot, 0, MARGIN + LINE, width, height);
  context.font = FONT;
  for (const entry of placed) drawEntry(context, entry, MARGIN + LINE + height + 4);
  return canvas;
}
