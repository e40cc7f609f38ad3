"""Writes report pages as report/FORMAT.md describes them, as the program itself does."""
import array
import base64
import html
import json
import math
import pathlib
import sys
import zlib

DIST = pathlib.Path(__file__).resolve().parents[2] / "report" / "dist"
CODES = {"f64": "d", "f32": "f", "u32": "I", "u16": "H", "u8": "B"}


class Blocks:
    """Named blocks of numbers; several lists of numbers may share a block."""

    def __init__(self):
        self.bytes = {}

    def add(self, block, values, kind="f64"):
        data = array.array(CODES[kind], values)
        if sys.byteorder != "little":
            data.byteswap()
        held = self.bytes.setdefault(block, bytearray())
        # Odd places are allowed: the page must not rely on aligned ones.
        offset = len(held)
        held += data.tobytes()
        return {"block": block, "offset": offset, "count": len(data), "type": kind}

    def encoded(self):
        return {
            name: base64.b64encode(zlib.compress(bytes(data), 6)).decode()
            for name, data in self.bytes.items()
        }


def report(runs, sweep=None, live=None):
    return {
        "format": 1,
        "program": {"name": "moraine", "version": "0.9.0", "revision": "abc1234"},
        "made": "2024-05-06T07:08:09Z",
        "cite": {
            "text": "Moraine 0.9.0, a particle solver.",
            "bibtex": "@software{moraine,\n  title = {Moraine}\n}",
        },
        "live": live,
        "runs": runs,
        "sweep": sweep,
    }


def run(name, title, **parts):
    made = {
        "name": name,
        "title": title,
        "state": "ended",
        "end_reason": "end time reached",
        "progress": None,
        "facts": [],
        "quality": [],
        "comparisons": [],
        "stages": [],
        "tables": [],
        "references": [],
        "measures": [],
        "decays": [],
        "votes": [],
        "timing": [],
        "settings": [],
        "particles": None,
    }
    made.update(parts)
    return made


def column(blocks, block, label, gauge, name, unit, group, values, kind="f64"):
    return {
        "label": label,
        "gauge": gauge,
        "name": name,
        "unit": unit,
        "group": group,
        "data": blocks.add(block, values, kind),
    }


def quantise(value, low, high, steps):
    if math.isnan(value):
        return steps + 1
    if high <= low:
        return 0
    return max(0, min(steps, round((value - low) / (high - low) * steps)))


def page(content, blocks, title):
    """The whole page. The player is in it only where a run has particles, or data are to come."""
    needs_player = content["live"] is not None or any(run["particles"] for run in content["runs"])
    data = json.dumps(content, allow_nan=False).replace("<", "\\u003c")
    scripts = [f'<script type="application/json" id="report">{data}</script>']
    for name, text in blocks.encoded().items():
        scripts.append(f'<script type="text/plain" id="block:{html.escape(name)}">{text}</script>')
    player = f"<script>{(DIST / 'player.js').read_text()}</script>" if needs_player else ""
    text = (DIST / "page.html").read_text()
    for mark, value in (
        ("@@TITLE@@", html.escape(title)),
        ("@@PLAYER@@", player),
        ("@@DATA@@", "\n".join(scripts)),
    ):
        before, after = text.split(mark)
        text = before + value + after
    return text
