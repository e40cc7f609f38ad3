"""The player: it plays, cuts, reads particles, follows them, and goes without WebGL."""
import base64
import math
import unittest

from report_test import ReportTest, Shared, time
from sample_particles import (
    CENTRE_ID,
    CUBE,
    FRAMES,
    NOWHERE_ID,
    PRESSURE,
    centre_pressure,
    cube_rows,
    frame_time,
    plane_rows,
)
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select


class PlayerTest(ReportTest):
    def open_player(self, name, count):
        self.open(name)
        self.wait(lambda: self.all(f".count[data-drawn='{count}']"))
        self.run_script(
            "arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})",
            self.one(".stage"),
        )

    def picture(self):
        data = self.run_script(
            "return document.querySelector('.stage canvas').toDataURL('image/png')"
        )
        return base64.b64decode(data.split(",")[1])

    def frame(self):
        return int(self.text(".transport .time").split("frame ")[1].split(" ")[0])

    def drawn(self):
        return int(self.one(".count").get_attribute("data-drawn"))

    def click_stage(self, share_x, share_y):
        left, top, width, height = self.run_script(
            "const r = document.querySelector('.stage canvas').getBoundingClientRect(); return [r.left, r.top, r.width, r.height]"
        )
        x, y = round(left + share_x * width), round(top + share_y * height)
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left" if kind != "mouseMoved" else "none", clickCount=1)

    def values(self):
        pairs = self.run_script(
            "return [...document.querySelectorAll('.values > div')].map(d => [...d.children].map(c => c.textContent))"
        )
        return {name: value.replace("\u00a0", " ").replace("\u2212", "-") for name, value in pairs}

    def test_it_plays_and_pauses(self):
        self.open_player("plane", 400)
        first = self.picture()
        self.click(self.one(".transport .play"))
        self.wait(lambda: self.frame() >= 4)
        self.click(self.one(".transport .play"))
        time.sleep(0.3)
        rests = self.frame()
        self.assertNotEqual(self.picture(), first)
        time.sleep(0.3)
        self.assertEqual(self.frame(), rests)

    def test_slider_and_keys_step(self):
        self.open_player("plane", 400)
        slider = self.one(".transport input[type=range]")
        slider.send_keys(Keys.END)
        self.wait(lambda: self.frame() == FRAMES)
        self.assertIn(f"t = {frame_time(FRAMES - 1) * 1000:g} ms", self.text(".transport .time"))
        stage = self.one(".stage")
        self.run_script("arguments[0].focus()", stage)
        stage.send_keys(Keys.ARROW_LEFT)
        self.wait(lambda: self.frame() == FRAMES - 1)
        stage.send_keys(Keys.HOME)
        self.wait(lambda: self.frame() == 1)
        stage.send_keys(Keys.SPACE)
        self.wait(lambda: self.frame() > 1)
        stage.send_keys(Keys.SPACE)

    def test_a_click_reads_the_particle_and_follows_it(self):
        self.open_player("plane", 400)
        self.click_stage(0.5, 0.5)
        self.wait(lambda: self.values().get("id") == str(CENTRE_ID))
        values = self.values()
        self.assertEqual((values["x"], values["y"]), ("1 m", "500 mm ± 7.6 µm"))  # 16 bits over the box
        self.assertEqual(values["pressure"], f"{centre_pressure(0) / 1000:g} kPa")
        self.assertEqual((values["speed"], values["material"]), ("2 m/s", "light oil"))
        self.one(".transport input[type=range]").send_keys(*[Keys.ARROW_RIGHT] * 5)
        self.wait(lambda: self.values()["x"] == "1.1 m")
        self.assertEqual(self.values()["pressure"], f"{centre_pressure(5) / 1000:g} kPa")

    def test_a_typed_id_is_followed_and_holes_are_none(self):
        self.open_player("plane", 400)
        rows = {row[0]: row for row in plane_rows(0)}
        hole = next(i for i, row in rows.items() if math.isnan(row[2]))
        field = self.one(".panels input[inputmode=numeric]")
        field.send_keys(str(hole), Keys.ENTER)
        self.wait(lambda: self.values().get("id") == str(hole))
        self.assertEqual(self.values()["pressure"], "–")
        field.clear()
        field.send_keys("123456", Keys.ENTER)
        self.wait(lambda: "not in this frame" in self.text(".values"))

    def test_digits_are_those_that_16_bits_carry(self):
        self.open_player("plane", 400)
        rows = [row for row in plane_rows(0) if not math.isnan(row[2])]
        number, _, pressure, *_ = min(rows, key=lambda row: abs(abs(row[2]) - 5.0))
        self.one(".panels input[inputmode=numeric]").send_keys(str(number), Keys.ENTER)
        self.wait(lambda: self.values().get("id") == str(number))
        value, error = self.values()["pressure"].split(" ± ")
        half_step = 0.5 * (PRESSURE[1] - PRESSURE[0]) / 65534  # Pa
        self.assertEqual(error, f"{1000 * half_step:.2g} mPa")
        self.assertAlmostEqual(float(value.split()[0]), pressure, delta=half_step + 0.005)
        self.assertRegex(value, r"^-?\d+(\.\d{1,2})? Pa$")

    def test_a_particle_that_is_nowhere_is_not_drawn(self):
        self.open_player("plane", 400)
        self.assertIn("400 of 401 particles", self.text(".count"))
        self.one(".panels input[inputmode=numeric]").send_keys(str(NOWHERE_ID), Keys.ENTER)
        self.wait(lambda: self.values().get("id") == str(NOWHERE_ID))
        self.assertEqual(self.values()["x"], "–")
        self.assertFalse(self.one(".stage .ring").is_displayed())

    def test_colours_are_those_of_the_values(self):
        self.open_player("plane", 400)
        ends = self.all(".ends input")
        # The middle particle has 1000 Pa: the last, the middle and the first colour of viridis.
        for low, high, colour in (
            (0, 1000, (0xFD, 0xE7, 0x25)),
            (0, 2000, (0x21, 0x91, 0x8C)),
            (1000, 3000, (0x44, 0x01, 0x54)),
        ):
            for end, value in zip(ends, (low, high)):
                end.clear()
                end.send_keys(str(value))
            ends[1].send_keys(Keys.TAB)
            self.wait(lambda: self.middle_pixel(colour), f"{colour} in the middle")

    def test_the_range_of_one_frame(self):
        self.open_player("plane", 400)
        Select(self.one(".panels select[aria-label='Range']")).select_by_value("frame")
        values = [row[2] for row in plane_rows(0) if not math.isnan(row[2])]
        for end, expected in zip(self.all(".ends input"), (min(values), max(values))):
            self.assertAlmostEqual(float(end.get_attribute("value")), expected, delta=0.1)

    def middle_pixel(self, colour):
        pixel = self.run_script(
            """const c = document.querySelector('.stage canvas'), to = document.createElement('canvas');
            to.width = c.width; to.height = c.height;
            const context = to.getContext('2d'); context.drawImage(c, 0, 0);
            return [...context.getImageData(c.width / 2, c.height / 2, 1, 1).data]"""
        )
        return all(abs(a - b) <= 3 for a, b in zip(pixel, colour))

    def test_categories_have_names_and_can_be_hidden(self):
        self.open_player("plane", 400)
        Select(self.one(".panels select[aria-label='Colour by']")).select_by_visible_text(
            "material"
        )
        self.wait(lambda: [e.text for e in self.all(".legend .check")] == ["water", "light oil"])
        water = sum(1 for row in plane_rows(0) if row[4] == 0)
        self.click(self.all(".legend input")[0])
        self.wait(lambda: self.drawn() == 400 - water)

    def test_a_slice_draws_what_is_in_it(self):
        total = len(cube_rows(0))
        self.open_player("cube", total)
        whole = self.picture()
        Select(self.one("select[aria-label='Axis of the slice']")).select_by_visible_text("x")
        # Ten per cent about the middle of the box: x = 11/24 and 13/24 are in it.
        expected = sum(1 for row in cube_rows(0) if abs(row[1][0] - 0.5) <= 0.05)
        self.wait(lambda: self.drawn() == expected)
        time.sleep(0.1)
        self.assertNotEqual(self.picture(), whole)
        self.assertEqual(CUBE[1][0], 1.0)

    def test_three_dimensions_are_picked_in_front(self):
        self.open_player("cube", len(cube_rows(0)))
        self.click(self.button(self.one(".panels"), "along z"))
        time.sleep(0.2)
        before = self.picture()
        self.click_stage(0.52, 0.52)
        self.wait(lambda: "id" in self.values())
        top = {row[0] for row in cube_rows(0) if row[0] % 12 == 11}
        self.assertIn(int(self.values()["id"]), top)
        self.assertEqual(before[:4], b"\x89PNG")

    def test_walls_and_probes_can_be_switched(self):
        self.open_player("plane", 400)
        self.assertEqual(
            [label.text for label in self.all(".stage .label")], ["P1", "H1 level", "inlet"]
        )
        shown = self.picture()
        boxes = {label.text: label for label in self.all(".panels .check")}
        self.click(boxes["Walls"])
        self.wait(lambda: self.picture() != shown)
        self.click(boxes["Probes"])
        self.wait(lambda: not self.all(".stage .label"))

    def test_walls_without_particles_are_outlines(self):
        for name, count in (("many", 20000), ("line", 200)):
            self.open_player(name, count)
            shown = self.picture()
            self.click(next(box for box in self.all(".panels .check") if box.text == "Walls"))
            self.wait(lambda: self.picture() != shown, name)

    def test_one_dimension_is_a_profile(self):
        self.open_player("line", 200)
        self.click_stage(0.5, 0.5)
        self.assertEqual(self.all("#particles .problem:not([hidden])"), [])

    def test_the_picture_is_saved(self):
        self.open_player("plane", 400)
        before = set(Shared.downloads.iterdir())
        self.click(self.button(self.one(".panels"), "PNG"))
        self.assertEqual(self.downloaded(".png", before).read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_without_webgl_the_rest_works(self):
        script = "const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind.startsWith('webgl') ? null : get.call(this, kind, ...more); };"
        added = self.driver.execute_cdp_cmd(
            "Page.addScriptToEvaluateOnNewDocument", {"source": script}
        )
        try:
            self.open("plane")
            self.assertIn("no WebGL", self.text("#particles .problem"))
            self.assertTrue(self.charts())
            self.assertEqual(len(self.all("#quality .verdicts + .scroller tbody tr")), 4)
        finally:
            self.driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", added)


if __name__ == "__main__":
    unittest.main()
