"""What all tests share: one browser, the samples' pages, and the questions they ask of a page."""
import json
import pathlib
import shutil
import tempfile
import time
import unittest

import browser
import samples
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

WAIT = 10  # s; a loaded machine needs its time


class Shared:
    driver = None
    pages = None
    downloads = None

    @classmethod
    def start(cls):
        if cls.driver is None:
            cls.downloads = pathlib.Path(tempfile.mkdtemp(prefix="moraine-downloads-"))
            cls.pages = browser.write_samples(samples.SAMPLES)
            cls.driver = browser.start(cls.downloads)

    @classmethod
    def stop(cls):
        if cls.driver is not None:
            cls.driver.quit()
            cls.driver = None
            for folder in (cls.pages, cls.downloads):
                shutil.rmtree(folder, ignore_errors=True)


class ReportTest(unittest.TestCase):
    # Errors that a test provokes itself.
    expected_errors = ()

    @classmethod
    def setUpClass(cls):
        Shared.start()

    def setUp(self):
        self.driver = Shared.driver
        browser.set_size(self.driver, browser.LAPTOP)
        self.driver.get_log("browser")
        self.driver.get_log("performance")

    def tearDown(self):
        bad = [
            entry
            for entry in self.driver.get_log("browser")
            if entry["level"] in ("SEVERE", "WARNING")
        ]
        # Remarks of the software renderer on reading pixels back are none of ours.
        bad = [
            e
            for e in bad
            if "GPU stall due to ReadPixels" not in e["message"]
            and not any(x in e["message"] for x in self.expected_errors)
        ]
        self.assertEqual(bad, [], "the browser's console")

    def open(self, name):
        self.driver.get((Shared.pages / f"{name}.html").as_uri())
        self.wait(lambda: self.all("main section:not([hidden])"))

    def wait(self, condition, message=""):
        def ask(_):
            return condition()

        return WebDriverWait(self.driver, WAIT, 0.05).until(ask, message)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def one(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def run_script(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def text(self, selector):
        """Text of an element, also where it is scrolled out of view."""
        return (
            self.run_script("return arguments[0].textContent", self.one(selector))
            .replace("\u00a0", " ")
            .replace("\u2212", "-")
            .replace("\u202f", "")
        )

    def button(self, within, text):
        for found in within.find_elements(By.TAG_NAME, "button"):
            if found.text.strip() == text or found.get_attribute("aria-label") == text:
                return found
        self.fail(f"no button '{text}'")

    def click(self, element):
        self.run_script(
            "arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", element
        )
        element.click()

    def charts(self, section="curves"):
        self.wait(lambda: self.all(f"#{section} .chart .u-over"))
        return self.all(f"#{section} .chart")

    def hover(self, chart, share_x, share_y=0.5):
        """Moves the mouse to a place given in shares of the plotting area; returns what it met in x."""
        over = chart.find_element(By.CSS_SELECTOR, ".u-over")
        self.run_script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", over)
        place = over.rect
        view = self.run_script(
            "const r = arguments[0].getBoundingClientRect(); return [r.left, r.top]", over
        )
        x, y = round(view[0] + share_x * place["width"]), round(view[1] + share_y * place["height"])
        # Twice: the first one enters the plot.
        for shift in (1, 0):
            self.mouse("mouseMoved", x + shift, y)
        return (x - view[0]) / place["width"]

    def mouse(self, kind, x, y, **more):
        self.driver.execute_cdp_cmd(
            "Input.dispatchMouseEvent", {"type": kind, "x": x, "y": y, **more}
        )

    def readings(self, chart):
        """Curve names and their values as (number, unit), as the chart shows them."""
        items = self.run_script(
            "return [...arguments[0].querySelectorAll('.reading li')].map(li => [li.querySelector('.name').textContent, li.querySelector('output').textContent])",
            chart,
        )
        return {name: parse(value) for name, value in items}

    def downloaded(self, suffix, before):
        def find():
            return [
                p for p in Shared.downloads.iterdir() if p.name.endswith(suffix) and p not in before
            ]

        return self.wait(lambda: find() and find()[0])

    def requests(self):
        """Addresses that the page asked for since the test began."""
        found = []
        for entry in self.driver.get_log("performance"):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
        return found


def parse(text):
    """(4.32, "kPa") from "4.32 kPa"."""
    text = text.replace("\u2212", "-").replace("\u202f", "")
    number, _, unit = text.partition("\u00a0")
    if "\u00b710" in number:
        mantissa, exponent = number.split("\u00b710")
        table = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
        number = f"{mantissa}e{exponent.translate(table)}"
    return (None if number == "–" else float(number)), unit


__all__ = ["By", "Keys", "ReportTest", "Shared", "parse", "time"]
