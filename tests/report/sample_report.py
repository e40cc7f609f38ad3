"""Reports of runs that never were: all numbers follow from formulas that the tests know too."""
import math

from report_writer import Blocks, column, page, quantise, report, run
from sample_measures import measure, measures
from sample_parts import common_parts

END = 0.5  # s, of all runs with gauges
ROWS = 501
HOSTILE = [
    '<img src=x onerror="window.hurt=1">',
    "</script><script>window.hurt=2</script>",
    '"onmouseover="window.hurt=3',
    "'><svg onload=window.hurt=4>",
    "<!--<script>",
]


def times(rows=ROWS, end=END):
    return [end * i / (rows - 1) for i in range(rows)]


def pressure(t, gauge=1, scale=1.0):
    """Pa. A decaying swing of some kilopascals."""
    return scale * 5000.0 * gauge * math.exp(-3.0 * t) * math.sin(2 * math.pi * 8.0 * t)


def level(t):
    """m. Has no value between 0.2 s and 0.3 s."""
    return math.nan if 0.2 < t < 0.3 else 0.12 + 0.03 * math.cos(2 * math.pi * 4.0 * t)


def gauges_table(blocks, rows=ROWS, scale=1.0, prefix=""):
    block = prefix + "gauges"
    at = times(rows)
    columns = [
        column(
            blocks,
            block,
            f"P{g} pressure",
            f"P{g}",
            "pressure",
            "Pa",
            "point",
            [pressure(t, g, scale) for t in at],
        )
        for g in (1, 2, 3)
    ]
    columns += [
        column(
            blocks,
            block,
            f"P{g} density",
            f"P{g}",
            "density",
            "kg/m^3",
            "point",
            [1000.0 + pressure(t, g, scale) / 2.2e3 for t in at],
            "f32",
        )
        for g in (1, 2, 3)
    ]
    columns.append(
        column(blocks, block, "H1 level", "H1", "level", "m", "level", [level(t) for t in at])
    )
    return {
        "name": "gauges",
        "rows": rows,
        "rows_of": rows * 4,
        "time": blocks.add(block, at),
        "columns": columns,
    }


def sums_table(blocks, rows=ROWS, prefix=""):
    block = prefix + "sums"
    at = times(rows)
    kinetic = [12.0 * math.sin(math.pi * t / END) ** 2 for t in at]
    potential = [40.0 - 10.0 * math.sin(math.pi * t / END) ** 2 - 3.0 * t for t in at]
    internal = [2000.0 + 4.0 * t for t in at]
    work = [2.0 * math.sin(math.pi * t / END) ** 2 for t in at]
    terms = [
        ("kinetic_energy", kinetic),
        ("internal_energy", internal),
        ("potential_energy", potential),
        ("total_energy", [sum(v) for v in zip(kinetic, internal, potential)]),
        ("wall_work", work),
        ("lost_energy", [0.0] * rows),
    ]
    columns = [
        column(blocks, block, name, "", name, "J", "energy", values) for name, values in terms
    ]
    columns.append(
        column(
            blocks,
            block,
            "time_step",
            "",
            "time_step",
            "s",
            "step",
            [2e-5 * (1.1 + math.sin(40 * t)) for t in at],
        )
    )
    columns.append(
        column(
            blocks,
            block,
            "momentum_x",
            "",
            "momentum_x",
            "kg m/s",
            "momentum",
            [math.sin(9 * t) for t in at],
        )
    )
    return {
        "name": "sums",
        "rows": rows,
        "rows_of": rows,
        "time": blocks.add(block, at),
        "columns": columns,
    }


def reference(blocks):
    at = [0.02 * i for i in range(26)]
    return {
        "name": "measured",
        "table": "gauges",
        "column": "P1 pressure",
        "source": "Example and Sample (1999), figure 3",
        "time": blocks.add("reference", at),
        "value": blocks.add("reference", [1.1 * pressure(t) for t in at]),
    }


def gauges_only():
    blocks = Blocks()
    made = run(
        "dam",
        "Dam break onto a dry bed",
        tables=[gauges_table(blocks), sums_table(blocks)],
        references=[reference(blocks)],
        **common_parts(),
    )
    return page(report([made]), blocks, "Dam break")


OVERLAID = {"coarse": (101, 0.8), "middle": (251, 0.9), "fine": (501, 1.0)}  # rows, scale


def overlaid():
    blocks = Blocks()
    runs = []
    for name, (rows, scale) in OVERLAID.items():
        parts = common_parts()
        parts["facts"][2]["value"] = {"coarse": "20 mm", "middle": "10 mm", "fine": "5 mm"}[name]
        parts["measures"] = measures(scale)
        parts["quality"] = parts["quality"][: 2 if name == "coarse" else 4]
        parts["tables"] = [gauges_table(blocks, rows, scale, name), sums_table(blocks, rows, name)]
        runs.append(run(name, f"Dam break, {name}", **parts))
    return page(report(runs), blocks, "Three resolutions")


def hostile():
    blocks = Blocks()
    at = times(11)
    bad = HOSTILE
    columns = [
        column(blocks, "g", f"{text} pressure", text, "pressure", "Pa", text, at) for text in bad
    ]
    parts = {
        "facts": [{"label": t, "value": t} for t in bad],
        "quality": [
            {"name": t, "verdict": "good", "value": t, "limit": t, "meaning": t} for t in bad
        ],
        "comparisons": [
            {
                "name": bad[0],
                "unit": bad[2],
                "value": 1.0,
                "reference": 2.0,
                "tolerance": 0.1,
                "verdict": "bad",
                "source": bad[1],
            }
        ],
        "stages": [{"name": bad[0], "time_s": 0.0, "step": 0, "cause": bad[1]}],
        "tables": [
            {
                "name": "gauges",
                "rows": 11,
                "rows_of": 11,
                "time": blocks.add("g", at),
                "columns": columns,
            }
        ],
        "references": [
            {
                "name": bad[0],
                "table": "gauges",
                "column": f"{bad[0]} pressure",
                "source": bad[1],
                "time": blocks.add("g", at),
                "value": blocks.add("g", at),
            }
        ],
        "measures": [measure(t, t, t, seen=False, largest=1.0) for t in bad],
        "decays": [{"gauge": t, "exponent": -1.0, "points": 2, "scatter": 0.0} for t in bad],
        "votes": [{"reason": t, "steps": 1, "share": 0.2, "least_time_step_s": None} for t in bad],
        "timing": [{"label": t, "seconds": 1.0, "calls": 1} for t in bad],
        "settings": [
            {"section": t, "key": t, "value": t, "unit": t, "is_default": True, "meaning": t}
            for t in bad
        ],
        "particles": small_cloud(blocks, bad[0], bad[1], bad[2:]),
    }
    content = report(
        [run(bad[0], bad[1], end_reason=bad[2], **parts), run(bad[2], bad[0], **parts)]
    )
    content["cite"] = {"text": bad[0], "bibtex": bad[1]}
    return page(content, blocks, bad[1])


def small_cloud(blocks, field, note, names):
    frame = {
        "time_s": 0.0,
        "count": 3,
        "id": blocks.add("c", [1, 2, 9], "u32"),
        "position": [blocks.add("c", [0, 30000, 65534], "u16") for _ in "xy"],
        "values": [blocks.add("c", [0, 1, 65534], "u16"), blocks.add("c", [0, 1, 2], "u8")],
    }
    return {
        "dimension": 2,
        "spacing": 0.1,
        "box": {"min": [0, 0, 0], "max": [1, 1, 0]},
        "total": 3,
        "shown": 3,
        "note": note,
        "fields": [
            {"name": field, "unit": names[0], "kind": "number", "min": 0, "max": 1},
            {"name": "material", "unit": "", "kind": "category", "min": 0, "max": 2},
        ],
        "materials": names,
        "frames": [frame],
        "walls": None,
        "probes": [{"name": n, "kind": n, "shape": "dot", "points": [[0.5, 0.5, 0]]} for n in names],
    }
