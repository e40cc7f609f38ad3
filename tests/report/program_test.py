"""The program's own pages: a run from case to report, hostile names, several runs, and a live page."""
import csv
import json
import os
import re
import subprocess
import unittest
import urllib.request

from chart_test_base import DIGITS, si
from contract_test import key_sets
from program_base import GAUGE, MEASURED, NO_PROGRAM, PROGRAM, ProgramRun
from sample_sweep import live_data

@unittest.skipUnless(PROGRAM, NO_PROGRAM)
class ProgramTest(ProgramRun):
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

    def test_all_measured_curves_have_names_and_sources(self):
        self.open_file("one/report.html")
        chart = self.pressure_chart()
        self.hover(chart, 0.99)
        readings = self.readings(chart)
        for name, value in MEASURED.items():
            self.assertEqual(si(readings[name]), value)
            self.assertIn(f"logbook of {name}", chart.text)
        looks = self.run_script(
            "return [...arguments[0].querySelectorAll('.swatch circle')]"
            ".map(dot => dot.getAttribute('stroke') + dot.getAttribute('fill'))",
            chart,
        )
        self.assertEqual(len(set(looks)), len(MEASURED), looks)

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
        # Few frames: each answer reads all of them, and the run is quick.
        self.write_case("long.toml", 1000, frames=0.5)
        run = subprocess.Popen(
            [PROGRAM, "run", "long.toml", "--output", "long"],
            cwd=self.folder,
            # The browser needs processors too.
            env={**os.environ, "OMP_NUM_THREADS": "1"},
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
                with urllib.request.urlopen(address + "data.json") as answer:
                    sets, known = key_sets(json.load(answer)), key_sets(live_data(1, 20, 2))
                for part in (".", ".runs[].progress."):
                    self.assertEqual(sets[part], known[part], part)
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
