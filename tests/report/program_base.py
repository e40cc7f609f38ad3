"""A run of the program itself, for tests of the pages that it writes."""
import os
import pathlib
import subprocess
import tempfile

from chart_test_base import ChartTest

PROGRAM = os.environ.get("MORAINE_PROGRAM", "")
NO_PROGRAM = "MORAINE_PROGRAM does not name the program"
GAUGE = "bed <img src=x onerror=document.title='bad'>"
MEASURED = {"sensor <b>A</b>": 2500.0, "sensor B": 2600.0}  # Pa at the end

# A column of water that falls over in a tank.
CASE = """title = "dam </script><script>document.title='bad'</script>"
space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution = {{ spacing = 0.02, smoothing_factor = 1.5 }}
time = {{ end = {end} }}
output = {{ frames = {frames}, gauges = {gauges} }}
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
{curves}"""
CURVE = """[[reference]]
name = "{name}"
gauge = "{gauge}"
file = "{file}"
source = "logbook of {name}"
"""


class ProgramRun(ChartTest):
    """Tests of a class share one folder with the run "one"."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="moraine-run-"))
        cls.write_case("case.toml", 0.1)
        cls.call("run", "case.toml", "--output", "one")

    @classmethod
    def write_case(cls, name, end, frames=0.01):
        curves = ""
        for number, (sensor, value) in enumerate(MEASURED.items()):
            file = f"curve-{number}.csv"
            (cls.folder / file).write_text(f"time [s],pressure [Pa]\n0,0\n0.1,{value}\n")
            curves += CURVE.format(name=sensor, gauge=GAUGE, file=file)
        (cls.folder / name).write_text(CASE.format(end=end, frames=frames, gauges=frames / 5, gauge=GAUGE, curves=curves))

    @classmethod
    def call(cls, *arguments):
        subprocess.run([PROGRAM, *arguments], cwd=cls.folder, check=True, capture_output=True)

    def open_file(self, path):
        self.driver.get((self.folder / path).as_uri())
        self.wait(lambda: self.all("main section:not([hidden])"))
