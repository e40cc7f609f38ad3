"""The JSON that the program writes has the members of the samples, which the page is tested with."""
import json
import re
import unittest

from program_base import NO_PROGRAM, PROGRAM, ProgramRun
from report_test import Shared

SWEEP = """title = "ends"
case = "case.toml"
method = "grid"
at_once = 2
[[parameter]]
key = "time.end"
label = "end"
values = [0.004, 0.006]
[[output]]
gauge = "{gauge}"
column = "pressure"
measure = "largest"
"""
STAGES = """[[stage]]
name = "first"
until = { after = 0.002 }
[[stage]]
name = "second"
"""
DECAY = """[[gauge]]
name = "along"
kind = "line"
line = { from = [0.02, 0.02], to = [0.18, 0.02], points = 4, origin = [0.0, 0.0] }
"""
# Only live data have it, which are compared where the program is watched.
LIVE_ONLY = ".runs[].progress."


def key_sets(value, path="", found=None):
    """Names of members of all objects, by the place of the object with numbers of rows left out."""
    found = {} if found is None else found
    if isinstance(value, dict):
        found.setdefault(f"{path}.", set()).update(value)
        for key, part in value.items():
            key_sets(part, f"{path}.{key}", found)
    elif isinstance(value, list):
        for part in value:
            key_sets(part, f"{path}[]", found)
    return found


def data_of(page):
    return json.loads(re.search(r'<script type="application/json" id="report">(.*?)</script>', page, re.S)[1])


@unittest.skipUnless(PROGRAM, NO_PROGRAM)
class ContractTest(ProgramRun):
    def test_the_program_writes_what_the_samples_hold(self):
        case = (self.folder / "case.toml").read_text()
        gauge = re.search(r'gauge = "(.*)"', case)[1]
        (self.folder / "staged.toml").write_text(case + STAGES + DECAY)
        (self.folder / "sweep.toml").write_text(SWEEP.format(gauge=gauge))
        self.call("run", "staged.toml", "--output", "staged")
        self.call("sweep", "sweep.toml", "--output", "swept")
        written, known = {}, {}
        for page in ("staged/report.html", "swept/sweep.html"):
            key_sets(data_of((self.folder / page).read_text()), found=written)
        for page in sorted(Shared.pages.glob("*.html")):
            key_sets(data_of(page.read_text()), found=known)
        known.pop(LIVE_ONLY, None)
        self.maxDiff = None
        self.assertEqual(written, known)


if __name__ == "__main__":
    unittest.main()
