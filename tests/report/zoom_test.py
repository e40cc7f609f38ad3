"""Zooming of charts by every way there is, and back."""
import unittest

import browser
from chart_test_base import ChartTest, nearest_time
from report_test import time
from sample_report import END, ROWS
from selenium.webdriver.common.by import By

STEP = END / (ROWS - 1)


class ZoomTest(ChartTest):
    def setUp(self):
        super().setUp()
        self.open("gauges")
        self.chart = self.pressure_chart()
        self.plot = self.chart.find_element(By.CSS_SELECTOR, ".plot")

    def span(self):
        """Times [s] near both ends of what is shown."""
        ends = []
        for share in (0.01, 0.99):
            self.hover(self.chart, share)
            ends.append(self.cursor_time(self.chart))
        return ends[1] - ends[0]

    def assert_whole(self):
        met = self.hover(self.chart, 0.99)
        self.assertAlmostEqual(self.cursor_time(self.chart), nearest_time(met), delta=1e-9)

    def drag(self, low, high):
        self.hover(self.chart, low)
        left, top, width, height = self.edges(self.chart)
        y = round(top + height / 2)
        places = [round(left + share * width) for share in (low, 0.5 * (low + high), high)]
        self.mouse("mousePressed", places[0], y, button="left", clickCount=1)
        for x in places[1:]:
            self.mouse("mouseMoved", x, y, button="left", buttons=1)
        self.mouse("mouseReleased", places[2], y, button="left", clickCount=1)

    def test_by_drag(self):
        self.drag(0.2, 0.4)
        met = self.hover(self.chart, 0.5)
        self.assertAlmostEqual(self.cursor_time(self.chart), END * (0.2 + 0.2 * met), delta=STEP)
        self.click(self.button(self.chart, "Reset zoom"))
        self.assert_whole()

    def test_back_by_double_click(self):
        self.drag(0.6, 0.9)
        self.hover(self.chart, 0.5)
        left, top, width, height = self.edges(self.chart)
        x, y = round(left + width / 2), round(top + height / 2)
        for count in (1, 2):
            for kind in ("mousePressed", "mouseReleased"):
                self.mouse(kind, x, y, button="left", clickCount=count)
        self.assert_whole()

    def test_by_wheel_only_with_the_focus(self):
        self.hover(self.chart, 0.3)
        left, top, width, _ = self.edges(self.chart)
        wheel = {"deltaX": 0, "deltaY": -400}
        self.mouse("mouseWheel", round(left + 0.3 * width), round(top + 50), **wheel)
        time.sleep(0.2)
        self.assertGreater(self.span(), 0.9 * END)
        self.run_script("arguments[0].focus({preventScroll: true})", self.plot)
        self.hover(self.chart, 0.3)
        left, top, width, _ = self.edges(self.chart)
        self.mouse("mouseWheel", round(left + 0.3 * width), round(top + 50), **wheel)
        self.wait(lambda: self.span() < 0.7 * END)

    def test_by_keys(self):
        self.run_script("arguments[0].focus()", self.plot)
        self.plot.send_keys("+", "+")
        self.assertAlmostEqual(self.span(), 0.98 * 0.49 * END, delta=0.05 * END)
        self.plot.send_keys("0")
        self.assert_whole()

    def test_by_two_fingers(self):
        browser.set_size(self.driver, browser.PHONE, is_phone=True)
        self.open("gauges")
        self.chart = self.pressure_chart()
        self.hover(self.chart, 0.5)
        left, top, width, height = self.edges(self.chart)
        for share in (0.1, 0.15, 0.2, 0.3, 0.4):
            fingers = [
                {"x": left + (0.5 + side * share) * width, "y": top + height / 2, "id": number}
                for number, side in enumerate((-1, 1))
            ]
            kind = "touchStart" if share == 0.1 else "touchMove"
            self.driver.execute_cdp_cmd(
                "Input.dispatchTouchEvent", {"type": kind, "touchPoints": fingers}
            )
        self.driver.execute_cdp_cmd(
            "Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []}
        )
        self.assertLess(self.span(), 0.5 * END)


if __name__ == "__main__":
    unittest.main()
