"""Sweeps: the table sorts, members choose curves, outputs are plotted over parameters."""
import csv
import unittest

from report_test import ReportTest, Shared
from sample_sweep import KERNELS, SPACINGS, peak
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import Select


class SweepTest(ReportTest):
    def cells(self, column):
        return self.run_script(
            "return [...document.querySelectorAll('#sweep tbody tr')].map(r => r.cells[arguments[0]].textContent)",
            column,
        )

    def test_the_table_sorts(self):
        self.open("sweep")
        self.assertEqual(len(self.cells(1)), 7)
        heads = self.all("#sweep thead button")
        self.click(heads[3])  # largest pressure
        self.assertIn("largest pressure [kPa]", self.text("#sweep thead"))
        rising = [float(text) for text in self.cells(4) if text != "–"]
        self.assertEqual(
            rising,
            sorted(peak(s, k) / 1000 for s in SPACINGS for k in KERNELS if (s, k) != (0.005, KERNELS[1])),
        )
        self.click(self.all("#sweep thead button")[3])
        self.assertEqual([float(t) for t in self.cells(4) if t != "–"], rising[::-1])
        self.assertEqual(self.cells(4)[-1], "–")
        self.assertIn("density out of bounds", self.text("#sweep tbody"))

    def test_members_choose_the_curves(self):
        self.open("sweep")
        self.charts()
        self.click(self.button(self.one("#sweep"), "Draw none"))
        boxes = self.all("#sweep tbody input")
        self.assertEqual(len(boxes), 5)
        for box in boxes[:2]:
            self.click(box)
        self.wait(lambda: len(self.readings(self.all("#curves .chart")[0])) == 2)

    def test_outputs_over_parameters(self):
        self.open("sweep")
        chart = self.charts("sweep")[0]
        self.click(self.button(chart, "lines"))
        self.wait(lambda: len(self.readings(chart)) == 2)
        self.hover(chart, 0.99)
        self.assertAlmostEqual(
            self.readings(chart)[f"kernel {KERNELS[1]}"][0], peak(0.02, KERNELS[1]) / 1000
        )
        Select(
            chart.find_element(By.CSS_SELECTOR, "select[aria-label=Parameter]")
        ).select_by_visible_text("kernel")
        self.wait(lambda: len(self.readings(chart)) == 3)

    def test_csv(self):
        self.open("sweep")
        before = set(Shared.downloads.iterdir())
        self.click(self.button(self.one("#sweep > div > .controls"), "CSV"))
        with open(self.downloaded(".csv", before), newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 7)
        for row in rows[:5]:
            self.assertEqual(
                float(row["largest pressure [Pa]"]), peak(float(row["spacing [m]"]), row["kernel"])
            )
        self.assertEqual(rows[5]["largest pressure [Pa]"], "")


if __name__ == "__main__":
    unittest.main()
