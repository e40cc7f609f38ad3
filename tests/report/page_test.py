"""The page as a whole: what it shows, that it stays by itself, that names do nothing."""
import unittest

import browser
from report_test import ReportTest, Shared, time
from sample_particles import MANY_NOTE
from sample_parts import SHA_256
from sample_report import HOSTILE
from samples import SAMPLES
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select


class PageTest(ReportTest):
    def test_every_sample_opens_by_itself_and_fits_a_phone(self):
        for name in SAMPLES:
            with self.subTest(name):
                browser.set_size(self.driver, browser.PHONE, is_phone=True)
                self.open(name)
                time.sleep(0.2)
                self.assert_no_requests()
                width = self.run_script("return document.documentElement.scrollWidth")
                self.assertLessEqual(width, browser.PHONE[0])
                self.assertEqual(self.all("main > .problem"), [])

    def assert_no_requests(self):
        own = ("file:", "data:", "blob:")
        self.assertEqual([url for url in self.requests() if not url.startswith(own)], [])
        script = "return performance.getEntriesByType('resource').map(e => e.name)"
        loaded = self.run_script(script)
        self.assertEqual([url for url in loaded if not url.startswith(own[1:])], [])

    def test_pages_without_particles_stay_small(self):
        for name in ("gauges", "overlaid", "sweep"):
            self.assertLess((Shared.pages / f"{name}.html").stat().st_size, 1_000_000, name)

    def test_sections_come_in_order(self):
        self.open("plane")
        shown = [section.get_attribute("id") for section in self.all("main section:not([hidden])")]
        self.assertEqual(
            shown,
            [
                "quality",
                "facts",
                "curves",
                "measures",
                "particles",
                "energy",
                "timing",
                "stages",
                "settings",
                "cite",
            ],
        )

    def test_verdicts_are_words_and_shapes(self):
        self.open("gauges")
        marks = [mark.text.split() for mark in self.all("#quality .verdicts + .scroller .verdict")]
        self.assertEqual([mark[1] for mark in marks], ["good", "doubtful", "bad", "unknown"])
        self.assertEqual(len({mark[0] for mark in marks}), 4)
        text = self.text("#quality")
        for wanted in (
            "0.12 %",
            "4.321 kPa",
            "-3.98 %",
            "Example and Sample (1999), table 2",
            "sound speed",
            "80 %",
            "19 µs",
        ):
            self.assertIn(wanted, text)

    def test_the_page_begins_with_the_verdict(self):
        self.open("gauges")
        first = self.one("main section p, main section table")
        self.assertEqual(
            first.text.split("\n")[-1],
            "1 good, 1 unknown, 1 doubtful, 1 bad. "
            "Beside reference values: 1 good, 1 unknown, 1 bad.",
        )
        self.assertEqual(self.text(".verdicts .verdict"), "✖bad")

    def is_seen(self, element):
        """Not so inside of what is folded, which the driver takes for displayed."""
        return self.run_script("return arguments[0].checkVisibility()", element)

    def test_facts_are_folded_on_a_phone_and_long_ones_everywhere(self):
        self.open("gauges")
        value = self.one("#facts .long > code")
        self.assertFalse(self.is_seen(value))
        self.assertEqual(self.one("#facts .long summary").text, f"{SHA_256[:8]}…")
        self.click(self.one("#facts .long summary"))
        self.assertEqual(value.text, SHA_256)
        browser.set_size(self.driver, browser.PHONE, is_phone=True)
        self.open("gauges")
        self.assertFalse(self.is_seen(self.one("#facts dl")))
        self.assertIn("end time reached", self.one("#facts summary").text)
        self.click(self.one("#facts summary"))
        self.assertTrue(self.is_seen(self.one("#facts dl")))

    def test_the_run_is_chosen(self):
        self.open("overlaid")
        rows = "#quality .verdicts + .scroller tbody tr"
        self.assertEqual(len(self.all(rows)), 2)
        Select(self.one("#run")).select_by_visible_text("Dam break, fine")
        self.assertEqual(len(self.all(rows)), 4)
        heads = [cell.text for cell in self.all("#facts thead th")]
        self.assertEqual(heads[1:], ["Dam break, coarse", "Dam break, middle", "Dam break, fine"])
        self.assertEqual(
            [cell.text for cell in self.all("#facts td strong")], ["20 mm", "10 mm", "5 mm"]
        )

    def test_facts_of_many_runs_scroll_in_their_box(self):
        browser.set_size(self.driver, browser.PHONE, is_phone=True)
        self.open("sweep")
        self.click(self.one("#facts summary"))
        box, first = self.one("#facts .scroller"), self.one("#facts tbody td")
        self.run_script("arguments[0].scrollLeft = 1e4", box)
        scrolled, left = self.run_script(
            "return [arguments[0].scrollLeft, arguments[1].getBoundingClientRect().left]", box, first
        )
        self.assertGreater(scrolled, 0)
        self.assertGreaterEqual(left, 0)
        self.assertLessEqual(
            self.run_script("return document.documentElement.scrollWidth"), browser.PHONE[0]
        )

    def test_a_damaged_block_is_told_and_the_rest_stays(self):
        text = (Shared.pages / "plane.html").read_text()
        text = text.replace('id="block:gauges"', 'id="block:gone"').replace(
            'id="block:frame3"', 'id="block:lost"'
        )
        (Shared.pages / "damaged.html").write_text(text)
        self.driver.get((Shared.pages / "damaged.html").as_uri())
        self.wait(lambda: "cannot be read" in self.text("#curves .chart"))
        self.wait(lambda: "500 mJ" in self.text("#energy .summary"))
        slider = self.one(".transport input[type=range]")
        slider.send_keys(*[Keys.ARROW_RIGHT] * 3)
        self.wait(lambda: "Frame 4 cannot be read" in self.text("#particles .problem"))

    def test_time_and_energy(self):
        self.open("gauges")
        self.assertIn("72.1 %", self.text("#timing"))
        self.wait(lambda: "500 mJ" in self.text("#energy .summary"))
        self.assertIn(
            "4.17 %", self.text("#energy .summary")
        )  # 0.5 J of the 12 J of the kinetic energy

    def test_settings_are_filtered(self):
        self.open("gauges")
        field = self.one("#settings input[type=search]")
        field.send_keys("kernel")
        self.assertEqual(len(self.all("#settings tbody tr")), 1)
        self.assertIn("default", self.text("#settings tbody"))
        field.clear()
        field.send_keys("zzz")
        self.assertEqual(len(self.all("#settings tbody tr")), 0)

    def test_hostile_names_are_texts(self):
        self.open("hostile")
        time.sleep(0.5)
        self.assertIsNone(self.run_script("return window.hurt ?? null"))
        self.assertEqual(
            self.run_script(
                "return document.querySelectorAll('main img, main script, main svg:not(.swatch), [onload], [onerror], [onmouseover]').length"
            ),
            0,
        )
        for section in ("facts", "quality", "stages", "timing", "settings", "cite", "curves", "measures"):
            self.assertIn(HOSTILE[0], self.text(f"#{section}"), section)
        self.assertIn(HOSTILE[1], self.text("#particles .note"))
        self.assertIn(HOSTILE[2], [label.text for label in self.all(".stage .label")])
        self.assertEqual(self.run_script("return document.title"), HOSTILE[1])
        self.one("#run").send_keys("A")
        self.assertIsNone(self.run_script("return window.hurt ?? null"))

    def test_a_million_particles_open_at_once_and_say_what_is_missing(self):
        began = time.monotonic()
        self.open("many")
        self.wait(lambda: self.all(".count[data-drawn='20000']"))
        self.assertLess(time.monotonic() - began, 10.0)
        self.assertTrue(self.one("#particles .note").is_displayed())
        self.assertIn(MANY_NOTE, self.text("#particles .note"))

    def test_dark_and_light(self):
        ground = "return getComputedStyle(document.body).backgroundColor"
        browser.set_size(self.driver, browser.LAPTOP, theme="dark")
        self.open("gauges")
        self.assertEqual(self.run_script(ground), "rgb(20, 23, 26)")
        browser.set_size(self.driver, browser.LAPTOP, theme="light")
        self.wait(lambda: self.run_script(ground) == "rgb(255, 255, 255)")
        for expected in ("rgb(255, 255, 255)", "rgb(20, 23, 26)"):  # light, dark
            self.one("#theme").click()
            self.assertEqual(self.run_script(ground), expected)

    def test_keyboard_reaches_everything(self):
        self.open("plane")
        names = self.run_script(
            """const bad = [];
            for (const control of document.querySelectorAll('main button, main select, main input, header button, header select')) {
              if (control.closest('[hidden]')) continue;
              const name = control.getAttribute('aria-label') || control.textContent || control.labels?.[0]?.textContent;
              if (!name?.trim() || control.tabIndex < 0) bad.push(control.outerHTML);
            }
            return bad"""
        )
        self.assertEqual(names, [])
        self.assertEqual(
            self.run_script(
                "document.querySelector('.skip').focus(); return document.activeElement.textContent"
            ),
            "Skip to the content",
        )

    def test_data_of_another_format_are_refused(self):
        text = (Shared.pages / "gauges.html").read_text().replace('"format": 1', '"format": 2')
        (Shared.pages / "other.html").write_text(text)
        self.driver.get((Shared.pages / "other.html").as_uri())
        self.assertIn("this page reads format 1", self.text("main .problem"))


if __name__ == "__main__":
    unittest.main()
