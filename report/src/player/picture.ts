// The picture of the player as a file: particles, time, colour bar or legend.
import { styleColour } from "../dom";
import { displayUnit, formatNumber, words } from "../units";
import { categoryColour, viridis } from "./colours";
import type { Stage } from "./stage";
import type { PlayerState } from "./state";

const MARGIN = 14;
const HEAD = 46;
const FOOT = 58;
const FONT = "13px system-ui, sans-serif";

function drawBar(
  context: CanvasRenderingContext2D,
  state: PlayerState,
  top: number,
  width: number,
): void {
  const field = state.fieldOf;
  if (!field) return;
  const [low, high] = state.range();
  const unit = displayUnit(field.unit, Math.max(Math.abs(low), Math.abs(high)));
  const length = Math.min(320, width - 2 * MARGIN);
  const table = viridis();
  for (let i = 0; i < 256; ++i) {
    context.fillStyle = `rgb(${table[4 * i]}, ${table[4 * i + 1]}, ${table[4 * i + 2]})`;
    context.fillRect(MARGIN + (i * length) / 256, top, length / 256 + 0.5, 12);
  }
  context.fillStyle = styleColour("--text");
  [0, 0.5, 1].forEach((share, i) => {
    context.textAlign = (["left", "center", "right"] as const)[i];
    context.fillText(
      formatNumber((low + share * (high - low)) / unit.factor, 4),
      MARGIN + share * length,
      top + 28,
    );
  });
  context.textAlign = "left";
  context.fillText(`${words(field.name)}${unit.unit ? ` [${unit.unit}]` : ""}`, MARGIN, top - 6);
}

function drawLegend(context: CanvasRenderingContext2D, state: PlayerState, top: number): void {
  let x = MARGIN;
  state.particles.materials.forEach((name, i) => {
    if (state.hidden.has(i)) return;
    context.fillStyle = categoryColour(i);
    context.fillRect(x, top, 12, 12);
    context.fillStyle = styleColour("--text");
    context.fillText(name, x + 18, top + 11);
    x += 18 + context.measureText(name).width + 20;
  });
}

export function playerPicture(
  title: string,
  time: string,
  state: PlayerState,
  stage: Stage,
): HTMLCanvasElement {
  const drawn = stage.canvas;
  const ratio = drawn.width / Math.max(1, drawn.clientWidth);
  const [width, height] = [drawn.clientWidth, drawn.clientHeight];
  const canvas = document.createElement("canvas");
  canvas.width = drawn.width;
  canvas.height = Math.round((height + HEAD + FOOT) * ratio);
  const context = canvas.getContext("2d");
  if (!context) return canvas;
  context.scale(ratio, ratio);
  context.fillStyle = styleColour("--background");
  context.fillRect(0, 0, width, height + HEAD + FOOT);
  context.drawImage(drawn, 0, HEAD, width, height);
  context.font = FONT;
  context.fillStyle = styleColour("--probe");
  for (const { text, x, y } of stage.labelSpots()) context.fillText(text, x + 6, HEAD + y + 4);
  context.fillStyle = styleColour("--text");
  context.font = `600 ${FONT}`;
  context.fillText(title, MARGIN, 20);
  context.font = FONT;
  context.fillText(
    `${time}${state.particles.note ? ` · ${state.particles.note}` : ""}`,
    MARGIN,
    38,
  );
  if (state.isCategory) drawLegend(context, state, HEAD + height + 18);
  else drawBar(context, state, HEAD + height + 20, width);
  return canvas;
}
