import assert from "node:assert/strict";
import { test } from "node:test";
import { wallOutlines } from "../src/player/outlines";
import { probeShapes } from "../src/player/probes";

const box = { min: [0, 0, 0], max: [2, 1, 0], dimension: 2, spacing: 0.1 };

test("open sides of walls are not drawn", () => {
  const wall = { name: "tank", min: [0, 0, 0], max: [2, 1, 0], open: ["y+"] };
  const drawn = wallOutlines([wall], box);
  assert.equal(drawn.length, 3 * 6);
  for (let i = 0; i < drawn.length; i += 6)
    assert.ok(!(drawn[i + 1] === 1 && drawn[i + 4] === 1), "no edge along the open top");
});

test("an edge in space is drawn where one of its two sides is closed", () => {
  const space = { ...box, max: [2, 1, 1], dimension: 3 };
  const wall = { name: "tank", min: [0, 0, 0], max: [2, 1, 1], open: [] };
  assert.equal(wallOutlines([wall], space).length, 12 * 6);
  assert.equal(wallOutlines([{ ...wall, open: ["z+"] }], space).length, 12 * 6);
  assert.equal(wallOutlines([{ ...wall, open: ["z+", "x-"] }], space).length, 11 * 6);
});

test("walls of a profile stand at its ends, those without an end are not drawn", () => {
  const line = { ...box, dimension: 1 };
  const wall = { name: "ends", min: [0, 0, 0], max: [2, 0, 0], open: ["x-"] };
  assert.deepEqual([...wallOutlines([wall], line)], [2, 0, 0, 2, 1, 0]);
  assert.equal(wallOutlines([{ ...wall, max: [null, NaN, 0] }], line).length, 0);
});

test("boxes of probes are cut to the picture", () => {
  const probe = (points) => ({ name: "p", kind: "bubble", shape: "box", points });
  const { segments, labels } = probeShapes(
    [
      probe([
        [-1e9, -1e9, 0],
        [1, 1e9, 0],
      ]),
    ],
    box,
  );
  assert.deepEqual(labels, [{ text: "p", point: [0, 0, 0] }]);
  assert.equal(Math.max(...segments), 1);
  assert.equal(
    probeShapes(
      [
        probe([
          [5, 5, 0],
          [6, 6, 0],
        ]),
      ],
      box,
    ).segments.length,
    0,
  );
});
