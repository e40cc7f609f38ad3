import assert from "node:assert/strict";
import { test } from "node:test";
import {
  displayUnit,
  duration,
  formatNumber,
  formatTicks,
  typesetUnit,
  withUnit,
} from "../src/units";

test("units are typeset", () => {
  assert.equal(typesetUnit("kg/m^3"), "kg/m³");
  assert.equal(typesetUnit("m/s2"), "m/s²");
  assert.equal(typesetUnit("m s^-2"), "m·s⁻²");
  assert.equal(typesetUnit("1/s"), "1/s");
});

test("prefixes go to units that take one", () => {
  const unit = (...given) => displayUnit(...given).unit;
  assert.equal(unit("Pa", 4.2e6), "MPa");
  assert.equal(unit("s", 2e-5), "µs");
  assert.equal(unit("s", 5000), "s");
  assert.equal(unit("m", 2e6), "km");
  assert.equal(unit("m/s", 340), "m/s");
  assert.equal(unit("J/kg", 4.2e6), "MJ/kg");
  assert.equal(unit("kg", 2e-5), "mg");
  assert.equal(unit("m^2", 1e-9), "10⁻⁹ m²");
  assert.equal(unit("kg/m^3", 1000), "kg/m³");
  assert.equal(unit("", 2e7), "10⁶");
});

test("a display unit and its factor belong together", () => {
  for (const [unit, size] of [
    ["Pa", 3.3e4],
    ["kg", 2e-5],
    ["m", 0.02],
    ["kg/m^3", 3e7],
    ["s", 1e-13],
  ]) {
    const { factor } = displayUnit(unit, size);
    const shown = size / factor;
    assert.ok(shown >= 0.0999 && shown < 1000.1, `${size} ${unit} is shown as ${shown}`);
  }
});

test("numbers", () => {
  assert.equal(formatNumber(0), "0");
  assert.equal(formatNumber(-1.25), "−1.25");
  assert.equal(formatNumber(123456.7), "123\u202f457");
  assert.equal(formatNumber(25013), "25\u202f013");
  assert.equal(formatNumber(5000), "5000");
  assert.equal(formatNumber(3.2e-9, 3), "3.2·10⁻⁹");
  assert.equal(formatNumber(NaN), "–");
  assert.equal(formatNumber(null), "–");
  assert.equal(withUnit(0.0312, "s", 3), "31.2\u00a0ms");
});

test("ticks have the decimals that their step needs", () => {
  assert.deepEqual(formatTicks([0, 2500, 5000], 1e3, false), ["0.0", "2.5", "5.0"]);
  assert.deepEqual(formatTicks([-0.2, -0.1, 2e-17, 0.1], 1, false), ["−0.2", "−0.1", "0.0", "0.1"]);
  assert.deepEqual(formatTicks([10000, 20000], 1, false), ["10\u202f000", "20\u202f000"]);
  assert.deepEqual(formatTicks([1e-3, 1, null], 1, true), ["0.001", "1", ""]);
});

test("durations", () => {
  assert.equal(duration(48), "48\u00a0s");
  assert.equal(duration(192), "3\u00a0min");
  assert.equal(duration(7500), "2\u00a0h 5\u00a0min");
});
