// Colours of values and of categories.
import { seriesColour } from "../charts/style";

/**
 * Nine points of the map "viridis", perceptually uniform and readable without seeing colours; between
 * them the map is straight to within 2 of 255. Source: N. Smith, S. van der Walt, "viridis" (2015),
 * matplotlib, given to the public domain (CC0).
 */
const VIRIDIS = [
  0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c, 0x28ae80, 0x5ec962, 0xaddc30, 0xfde725,
];

export const TABLE_SIZE = 256;

function mix(a: number, b: number, share: number): number {
  return Math.round(a + (b - a) * share);
}

export function viridis(): Uint8Array {
  const table = new Uint8Array(4 * TABLE_SIZE);
  for (let i = 0; i < TABLE_SIZE; ++i) {
    const place = (i / (TABLE_SIZE - 1)) * (VIRIDIS.length - 1);
    const below = Math.min(VIRIDIS.length - 2, Math.floor(place));
    const [a, b] = [VIRIDIS[below], VIRIDIS[below + 1]];
    for (let part = 0; part < 3; ++part) {
      const shift = 16 - 8 * part;
      table[4 * i + part] = mix((a >> shift) & 255, (b >> shift) & 255, place - below);
    }
    table[4 * i + 3] = 255;
  }
  return table;
}

function channels(colour: string): [number, number, number] {
  const code = Number.parseInt(colour.replace("#", ""), 16) || 0;
  return [(code >> 16) & 255, (code >> 8) & 255, code & 255];
}

export function categoryColour(index: number): string {
  return seriesColour(index);
}

/** Distinct colours; a hidden category has no alpha and is not drawn. */
export function categoryTable(hidden: Set<number>): Uint8Array {
  const table = new Uint8Array(4 * TABLE_SIZE);
  for (let i = 0; i < TABLE_SIZE; ++i) {
    table.set([...channels(categoryColour(i)), hidden.has(i) ? 0 : 255], 4 * i);
  }
  return table;
}
