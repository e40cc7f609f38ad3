"""Curves: what is read, chosen, zoomed and saved. Expected values follow from the samples' formulas."""
import csv
import unittest

from chart_test_base import DIGITS, ChartTest, nearest_time, si
from report_test import Shared, parse
from sample_report import END, OVERLAID, ROWS, level, pressure
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys


class ChartsTest(ChartTest):
    def test_hovering_reads_the_value_of_the_sample(self):
        self.open("gauges")
        chart = self.pressure_chart()
        for share in (0.11, 0.5, 0.83):
            met = self.hover(chart, share)
            at = nearest_time(met)
            readings = self.readings(chart)
            shown = parse(
                chart.find_element(By.CSS_SELECTOR, ".at")
                .text.replace(" ms", "\u00a0ms")
                .removeprefix("time ")
            )
            self.assertAlmostEqual(si(shown), at, delta=1e-9)
            for gauge in (1, 2, 3):
                expected = pressure(at, gauge)
                self.assertAlmostEqual(
                    si(readings[f"P{gauge} pressure"]),
                    expected,
                    delta=abs(expected) * DIGITS + 1e-6,
                )

    def test_measured_values_are_dots_with_their_own_times(self):
        self.open("gauges")
        chart = self.pressure_chart()
        met = self.hover(chart, 0.42)
        at = 0.02 * round(nearest_time(met) / 0.02)
        self.assertAlmostEqual(
            si(self.readings(chart)["measured"]), 1.1 * pressure(at), delta=abs(pressure(at)) * 2e-5
        )
        self.assertEqual(len(chart.find_elements(By.CSS_SELECTOR, ".swatch circle")), 1)

    def test_keys_move_the_cursor_and_say_what_it_reads(self):
        self.open("gauges")
        chart = self.pressure_chart()
        plot = chart.find_element(By.CSS_SELECTOR, ".plot")
        self.run_script("arguments[0].focus()", plot)
        plot.send_keys(Keys.HOME, *[Keys.ARROW_RIGHT] * 7, Keys.ARROW_LEFT)
        expected = pressure(6 * END / (ROWS - 1), 2)
        self.assertAlmostEqual(
            si(self.readings(chart)["P2 pressure"]), expected, delta=abs(expected) * DIGITS
        )
        self.wait(lambda: self.all("#announcer") and "P2 pressure" in self.text("#announcer"))
        self.assertIn("time 6 ms", self.text("#announcer"))

    def test_holes_stay_holes(self):
        self.open("gauges")
        chart = next(c for c in self.charts() if "evel" in c.find_element(By.TAG_NAME, "h3").text)
        self.hover(chart, 0.5)
        self.assertIsNone(self.readings(chart)["H1 level"][0])
        met = self.hover(chart, 0.1)
        self.assertAlmostEqual(
            si(self.readings(chart)["H1 level"]), level(nearest_time(met)), delta=1e-6
        )

    def test_no_line_crosses_a_hole(self):
        for name in ("gauges", "overlaid"):
            self.open(name)
            chart = next(
                c for c in self.charts() if "evel" in c.find_element(By.TAG_NAME, "h3").text
            )
            self.assertEqual([self.coloured(chart, 0.25), self.coloured(chart, 0.5)], [True, False])

    def coloured(self, chart, share):
        """Whether a column of pixels of the plotting area has any colour but grey."""
        return self.run_script(
            """const over = arguments[0].querySelector('.u-over').getBoundingClientRect();
            const canvas = arguments[0].querySelector('canvas');
            const edge = canvas.getBoundingClientRect();
            const x = Math.round(over.left - edge.left + arguments[1] * over.width);
            const top = over.top - edge.top;
            const copy = new OffscreenCanvas(canvas.width, canvas.height);
            const context = copy.getContext('2d', { willReadFrequently: true });
            context.drawImage(canvas, 0, 0);
            const { data } = context.getImageData(x, top, 1, over.height);
            for (let i = 0; i < data.length; i += 4) {
              const [low, , high] = [...data.slice(i, i + 3)].sort((a, b) => a - b);
              if (data[i + 3] > 100 && high - low > 60) return true;
            }
            return false""",
            chart,
            share,
        )

    def test_all_runs_are_drawn_over_each_other(self):
        self.open("overlaid")
        chart = self.pressure_chart()
        met = self.hover(chart, 0.6)
        readings = self.readings(chart)
        cursor = nearest_time(met)
        for name, (rows, scale) in OVERLAID.items():
            at = nearest_time(cursor / END, rows)
            expected = pressure(at, 1, scale)
            self.assertAlmostEqual(
                si(readings[f"P1 pressure · Dam break, {name}"]),
                expected,
                delta=abs(expected) * 2 * DIGITS,
            )
        colours = {
            line.get_attribute("stroke")
            for line in chart.find_elements(By.CSS_SELECTOR, ".swatch line")
        }
        self.assertEqual(len(colours), 3)
        box = self.one("#curves .overlay input")
        self.click(box)
        self.wait(
            lambda: not any("coarse" in name for name in self.readings(self.pressure_chart()))
        )

    def test_several_units_have_axes_of_their_own(self):
        self.open("gauges")
        chart = self.pressure_chart()
        self.click(self.button(chart, "Choose curves"))
        for name in ("H1 (level)", "P1 (point)"):
            group = next(
                g for g in chart.find_elements(By.CSS_SELECTOR, "details") if name in g.text
            )
            self.click(group.find_elements(By.CSS_SELECTOR, "input")[-1])
        self.wait(lambda: {"H1 level", "P1 density"} <= set(self.readings(chart)))
        self.assertEqual(len(chart.find_elements(By.CSS_SELECTOR, ".u-axis")), 4)
        met = self.hover(chart, 0.2)
        expected = level(nearest_time(met))
        self.assertAlmostEqual(si(self.readings(chart)["H1 level"]), expected, delta=1e-6)

    def test_columns_are_chosen(self):
        self.open("gauges")
        self.click(self.button(self.one("#curves"), "Add a chart"))
        chart = self.all("#curves .chart")[-1]
        search = chart.find_element(By.CSS_SELECTOR, ".chooser input[type=search]")
        search.send_keys("kinetic")
        boxes = chart.find_elements(By.CSS_SELECTOR, ".chooser input[type=checkbox]")
        self.assertEqual(len(boxes), 1)
        self.click(boxes[0])
        self.wait(lambda: "kinetic energy" in self.readings(chart))
        self.click(self.button(chart, "log y"))
        self.wait(lambda: "logarithmic" in chart.text)

    def test_csv_holds_all_shown_columns_of_all_runs(self):
        self.open("overlaid")
        before = set(Shared.downloads.iterdir())
        self.click(self.button(self.pressure_chart(), "CSV"))
        with open(self.downloaded(".csv", before), newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0][0], "time [s]")
        self.assertEqual(len(rows[0]), 1 + 6)
        self.assertEqual(len(rows), 1 + ROWS)  # the times of the finest run are those of all
        column = rows[0].index("middle: P2 pressure [Pa]")
        held = [(float(row[0]), float(row[column])) for row in rows[1:] if row[column]]
        self.assertEqual(len(held), OVERLAID["middle"][0])
        for at, value in held:
            self.assertEqual(value, pressure(at, 2, OVERLAID["middle"][1]))

    def test_png_is_a_picture(self):
        self.open("gauges")
        before = set(Shared.downloads.iterdir())
        self.click(self.button(self.pressure_chart(), "PNG"))
        self.assertEqual(self.downloaded(".png", before).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main()
