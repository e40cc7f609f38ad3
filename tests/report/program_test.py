"""The program's own pages: a run from case to report, hostile names, several runs, and a live page."""
import csv
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from chart_test_base import DIGITS, ChartTest, si
from report_test import By

PROGRAM = os.environ.get("MORAINE_PROGRAM", "")
GAUGE = "bed <img src=x onerror=document.title='bad'>"

# A column of water that falls over in a tank.
CASE = """title = "dam </script><script>document.title='bad'</script>"
space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution = {{ spacing = 0.02, smoothing_factor = 1.5 }}
time = {{ end = {end} }}
output = {{ frames = 0.01, gauges = 0.002 }}
material.water = {{ eos = "tait", reference_sound_speed = 20.0 }}
[[region]]
name = "column"
material = "water"
box = {{ min = [0.0, 0.0], max = [0.2, 0.3] }}
hydrostatic_level = 0.3
[[wall]]
name = "tank"
container = {{ min = [0.0, 0.0], max = [0.6, 0.4] }}
[[gauge]]
name = "{gauge}"
position = [0.1, 0.02]
[[reference]]
name = "hydrostatic"
gauge = "{gauge}"
value = 2747
tolerance = 0.2
source = "rho g h"
"""


@unittest.skipUnless(PROGRAM, "MORAINE_PROGRAM does not name the program")
class ProgramTest(ChartTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="moraine-run-"))
        cls.write_case("case.toml", 0.1)
        cls.call("run", "case.toml", "--output", "one")

    @classmethod
    def write_case(cls, name, end):
        (cls.folder / name).write_text(CASE.format(end=end, gauge=GAUGE))

    @classmethod
    def call(cls, *arguments):
        subprocess.run([PROGRAM, *arguments], cwd=cls.folder, check=True, capture_output=True)

    def open_file(self, path):
        self.driver.get((self.folder / path).as_uri())
        self.wait(lambda: self.all("main section:not([hidden])"))

    def table(self, run="one"):
        with open(self.folder / run / "gauges.csv", newline="") as file:
            rows = list(csv.reader(file))
        column = next(i for i, name in enumerate(rows[0]) if name.endswith("pressure [Pa]"))
        return [(float(row[0]), float(row[column])) for row in rows[1:]]

    def test_a_run_shows_its_readings(self):
        self.open_file("one/report.html")
        chart = self.pressure_chart()
        for share in (0.2, 0.7):
            self.hover(chart, share)
            at = self.cursor_time(chart)
            written = min(self.table(), key=lambda row: abs(row[0] - at))
            readings = self.readings(chart)
            self.assertAlmostEqual(written[0], at, delta=1e-6)
            self.assertAlmostEqual(
                si(readings[f"{GAUGE} pressure"]), written[1], delta=abs(written[1]) * DIGITS
            )
        self.assertEqual([u for u in self.requests() if not u.startswith(("file:", "data:"))], [])

    def test_names_stay_names(self):
        self.open_file("one/report.html")
        self.assertNotEqual(self.driver.title, "bad")
        self.assertIn("dam </script><script>", self.text("h1"))
        self.assertIn("hydrostatic", self.text("#quality"))

    def test_the_player_draws_all_particles(self):
        self.open_file("one/report.html")
        self.wait(lambda: "150 of 150 particles" in self.text("#particles"))

    def test_two_runs_are_drawn_over_each_other(self):
        self.write_case("longer.toml", 0.12)
        self.call("run", "longer.toml", "--output", "two", "--force")
        self.call("report", "one", "two", "--output", "both.html")
        self.open_file("both.html")
        chart = self.pressure_chart()
        self.hover(chart, 0.5)
        names = list(self.readings(chart))
        self.assertTrue(any("one" in name for name in names), names)
        self.assertTrue(any("two" in name for name in names), names)

    def test_a_run_is_watched_while_it_goes_on(self):
        self.write_case("long.toml", 1000)
        run = subprocess.Popen(
            [PROGRAM, "run", "long.toml", "--output", "long"],
            cwd=self.folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            self.wait(lambda: (self.folder / "long" / "status.json").exists())
            watch = subprocess.Popen(
                [PROGRAM, "watch", "long", "--web"], cwd=self.folder, stdout=subprocess.PIPE, text=True
            )
            try:
                address = re.search(r"http://[\d.:]+/", watch.stdout.readline()).group()
                self.driver.get(address)
                self.wait(lambda: self.all("#curves .chart .u-over"))
                before = self.progress()
                self.wait(lambda: self.progress() > before)
                self.assertEqual([u for u in self.requests() if not u.startswith((address, "data:"))], [])
                self.driver.get("about:blank")
            finally:
                watch.terminate()
                watch.wait()
                watch.stdout.close()
        finally:
            run.terminate()
            run.wait()

    def progress(self):
        return self.run_script("return document.querySelector('progress').value")


if __name__ == "__main__":
    unittest.main()
