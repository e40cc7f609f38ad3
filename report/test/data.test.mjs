import assert from "node:assert/strict";
import { deflateSync } from "node:zlib";
import { test } from "node:test";
import { inflate, view } from "../src/blocks";
import { align } from "../src/charts/align";
import { nearestRow } from "../src/charts/curves";
import { viridis } from "../src/player/colours";
import { indexOfId } from "../src/player/frames";
import { sorted } from "../src/sweep/rows";

test("blocks are inflated and read at any place", async () => {
  const bytes = Buffer.concat([
    Buffer.from([7]),
    Buffer.from(Float64Array.of(1.5, -2).buffer),
    Buffer.from(Uint16Array.of(65535, 1).buffer),
  ]);
  const held = await inflate(deflateSync(bytes).toString("base64"));
  const numbers = (offset, count, type) => view(held, { block: "b", offset, count, type });
  assert.deepEqual([...numbers(0, 1, "u8")], [7]);
  assert.deepEqual([...numbers(1, 2, "f64")], [1.5, -2]);
  assert.deepEqual([...numbers(17, 2, "u16")], [65535, 1]);
  assert.throws(() => numbers(17, 3, "u16"), /ends before/);
});

test("curves with times of their own share one list of times", () => {
  const curve = (x, y) => ({ x, y });
  const curves = [curve([0, 1, 2], [5, NaN, 7]), curve([0.5, 2], [1, 2])];
  assert.deepEqual(align(curves, false, false), [
    [0, 0.5, 1, 2],
    [5, null, null, 7],
    [undefined, 1, undefined, 2],
  ]);
  assert.deepEqual(align([curve([0, 1], [-1, 3])], true, true), [[1], [3]]);
});

test("the nearest row", () => {
  const x = [0, 1, 3];
  const places = [-5, 0.4, 0.6, 1.9, 2.1, 9, Infinity];
  assert.deepEqual(
    places.map((time) => nearestRow(x, time)),
    [0, 0, 1, 1, 2, 2, 2],
  );
  assert.equal(nearestRow([], 1), -1);
});

test("particles are found by their number", () => {
  const ids = Uint32Array.of(2, 5, 9, 4000000000);
  assert.deepEqual(
    [2, 9, 4000000000, 3].map((id) => indexOfId(ids, id)),
    [0, 2, 3, -1],
  );
});

test("the colours begin and end where viridis does, and rise in lightness", () => {
  const table = viridis();
  assert.deepEqual([...table.slice(0, 3)], [0x44, 0x01, 0x54]);
  assert.deepEqual([...table.slice(1020, 1023)], [0xfd, 0xe7, 0x25]);
  const lightness = (i) => 0.21 * table[4 * i] + 0.72 * table[4 * i + 1] + 0.07 * table[4 * i + 2];
  for (let i = 1; i < 256; ++i) assert.ok(lightness(i) >= lightness(i - 1) - 0.5, `colour ${i}`);
});

test("members are sorted with what is missing last", () => {
  const members = [{ v: 3 }, { v: null }, { v: "run 10" }, { v: 1 }, { v: "run 9" }];
  const order = (isAscending) =>
    sorted(members, { cell: ({ v }) => v }, isAscending).map((m) => m.v);
  assert.deepEqual(order(true), [1, 3, "run 9", "run 10", null]);
  assert.equal(order(false).at(-1), null);
});
