"""Measures of the gauges: sorted, filtered, beside each other, saved."""
import csv
import unittest

import browser
from report_test import ReportTest, Shared
from sample_measures import PEAKS
from sample_report import OVERLAID
from selenium.webdriver.support.ui import Select


class MeasuresTest(ReportTest):
    def rows(self):
        """Texts of the cells of the table."""
        found = self.run_script(
            "return [...document.querySelectorAll('#measures .first-fixed tbody tr')]"
            ".map(row => [...row.cells].map(cell => cell.textContent))"
        )
        return [[cell.replace("\u00a0", " ") for cell in row] for row in found]

    def head(self, text):
        return next(b for b in self.all("#measures thead button") if b.text.startswith(text))

    def test_numbers_have_units_and_none_is_a_dash(self):
        self.open("gauges")
        heads = [button.text for button in self.all("#measures thead button")]
        first = dict(zip(heads, self.rows()[0]))
        self.assertEqual(first["gauge"], "P1 pressure")
        self.assertEqual(first["largest"], "4.321 kPa")
        self.assertEqual(first["time of largest"], "31.2 ms")
        self.assertEqual(first["impulse"], "61.5 Pa·s")
        self.assertEqual(dict(zip(heads, self.rows()[2]))["arrival"], "–")
        self.assertNotIn("duration", heads, "no gauge has one")
        self.assertIn("Have seen nothing: blind.", self.text("#measures"))
        decay = self.text("#measures .stack")
        for wanted in ("line <b>", "-1.13", "0.021"):
            self.assertIn(wanted, decay)

    def test_columns_sort(self):
        self.open("gauges")
        self.click(self.head("largest"))
        sizes = sorted(PEAKS, key=lambda name: -PEAKS[name][0])
        names = [row[0].split()[0] for row in self.rows()]
        self.assertEqual(names, [*sizes, "H1", "blind"])
        self.click(self.head("largest"))
        self.assertEqual([row[0].split()[0] for row in self.rows()], ["H1", *sizes[::-1], "blind"])

    def test_gauges_are_filtered(self):
        self.open("gauges")
        self.one("#measures input[type=search]").send_keys("p2")
        self.assertEqual([row[0] for row in self.rows()], ["P2 pressure"])

    def test_runs_stand_beside_each_other(self):
        self.open("overlaid")
        heads = [button.text for button in self.all("#measures thead button")]
        self.assertEqual(heads[1:], [f"Dam break, {name}" for name in OVERLAID])
        scales = [scale for _, scale in OVERLAID.values()]
        kilopascals = [f"{PEAKS['P1'][0] * scale / 1000:.5g}" for scale in scales]
        self.assertEqual([float(c.split()[0]) for c in self.rows()[0][1:]], [*map(float, kilopascals)])
        Select(self.one("#measures select")).select_by_visible_text("arrival")
        self.assertEqual(self.rows()[0][1:], ["12.1 ms"] * 3)

    def test_csv_holds_all_digits_of_all_runs(self):
        self.open("overlaid")
        before = set(Shared.downloads.iterdir())
        self.click(self.button(self.one("#measures"), "CSV"))
        with open(self.downloaded(".csv", before), newline="") as file:
            rows = list(csv.DictReader(file))
        found = {(row["run"], row["gauge"]): row for row in rows}
        self.assertEqual(len(found), 5 * len(OVERLAID))
        row = found["middle", "P2"]
        self.assertEqual(float(row["largest"]), PEAKS["P2"][0] * OVERLAID["middle"][1])
        self.assertEqual((row["unit"], row["duration"]), ("Pa", ""))

    def test_names_stay_in_sight_on_a_phone(self):
        browser.set_size(self.driver, browser.PHONE, is_phone=True)
        self.open("gauges")
        places = self.run_script(
            """const box = document.querySelector('#measures .first-fixed');
            box.scrollLeft = 1e4;
            const cells = box.querySelector('tbody tr').cells;
            const last = cells[cells.length - 1].getBoundingClientRect();
            return [box.scrollLeft, cells[0].getBoundingClientRect().left, last.right, innerWidth]"""
        )
        scrolled, first, last, width = places
        self.assertGreater(scrolled, 0)
        self.assertTrue(0 <= first < last <= width, places)


if __name__ == "__main__":
    unittest.main()
