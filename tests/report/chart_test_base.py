"""What tests of charts share: numbers as they are shown, and the chart of the pressures."""
from report_test import ReportTest
from sample_report import END, ROWS
from selenium.webdriver.common.by import By

FACTORS = {"kPa": 1e3, "Pa": 1.0, "m": 1.0, "mm": 1e-3, "ms": 1e-3, "s": 1.0}
DIGITS = 1e-5  # six digits are shown


def si(reading):
    value, unit = reading
    return value * FACTORS[unit]


def nearest_time(share, rows=ROWS):
    return END * round(share * (rows - 1)) / (rows - 1)


class ChartTest(ReportTest):
    def pressure_chart(self):
        return next(
            chart
            for chart in self.charts()
            if "ressure" in chart.find_element(By.TAG_NAME, "h3").text
        )

    def cursor_time(self, chart):
        """s, as the chart says it."""
        text = chart.find_element(By.CSS_SELECTOR, ".at").text.replace("\u00a0", " ")
        value, unit = text.split()[1:]
        return float(value) * FACTORS[unit]

    def edges(self, chart):
        """Left, top, width and height of the plotting area in the window."""
        over = chart.find_element(By.CSS_SELECTOR, ".u-over")
        return self.run_script(
            "const r = arguments[0].getBoundingClientRect();"
            "return [r.left, r.top, r.width, r.height]",
            over,
        )
