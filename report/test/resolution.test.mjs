import assert from "node:assert/strict";
import { test } from "node:test";
import { stepOf, withResolution } from "../src/player/resolution";

test("no digit is shown that the step does not carry", () => {
  const step = stepOf(0, 1e10); // Pa: 152.6 kPa
  const shown = (value) => withResolution(value, step, "Pa", 4).replaceAll("\u00a0", " ");
  assert.equal(shown(1234567), "1.2 MPa ± 76 kPa");
  assert.equal(shown(3.21e9), "3.21 GPa");
  assert.equal(shown(101325), "100 kPa ± 76 kPa");
  assert.equal(shown(1000), "0 Pa ± 76 kPa");
  assert.equal(withResolution(NaN, step, "Pa", 4), "–");
  assert.equal(withResolution(101325, 0, "Pa", 4), "101.3\u00a0kPa");
});
