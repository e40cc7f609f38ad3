"""Reports with particles in one, two and three dimensions."""
import math

from report_writer import Blocks, column, page, quantise, report, run
from sample_parts import common_parts
from sample_report import gauges_table, sums_table

FRAMES = 30
CENTRE_ID = 7777
NOWHERE_ID = 9999
PRESSURE = (-500.0, 2500.0)  # Pa, over all frames
SPEED = (0.0, 3.0)  # m/s
PLANE = ((0.0, 0.0, 0.0), (2.0, 1.0, 0.0))
CUBE = ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))


def frame_time(k):
    return 0.01 * k


def field(name, unit, limits, kind="number"):
    return {"name": name, "unit": unit, "kind": kind, "min": limits[0], "max": limits[1]}


FIELDS = [
    field("pressure", "Pa", PRESSURE),
    field("speed", "m/s", SPEED),
    field("material", "", (0, 1), "category"),
]


def make_frame(blocks, k, box, rows, dimension, prefix=""):
    """rows: (id, position, pressure, speed, material) of each particle."""
    rows = sorted(rows)
    block = f"{prefix}frame{k}"
    low, high = box
    places = [
        [quantise(row[1][axis], low[axis], high[axis], 65534) for row in rows]
        for axis in range(dimension)
    ]
    return {
        "time_s": frame_time(k),
        "count": len(rows),
        "id": blocks.add(block, [row[0] for row in rows], "u32"),
        "position": [blocks.add(block, place, "u16") for place in places],
        "values": [
            blocks.add(block, [quantise(row[2], *PRESSURE, 65534) for row in rows], "u16"),
            blocks.add(block, [quantise(row[3], *SPEED, 65534) for row in rows], "u16"),
            blocks.add(block, [row[4] for row in rows], "u8"),
        ],
    }


def centre_pressure(k):
    """Pa, of the particle that starts in the middle of the box."""
    return 1000.0 + 10.0 * k


def plane_rows(k, side=20):
    """A lattice in the lower half that sways, and one particle alone in the middle of the box."""
    rows = []
    for i in range(side):
        for j in range(side - (i == 0)):
            x = 0.05 + 1.9 * i / (side - 1) + 0.05 * math.sin(0.2 * k) * j / side
            y = 0.02 + 0.36 * j / (side - 1) + 0.06 * math.sin(0.2 * k + 3 * x)
            p = 2000.0 * (0.45 - y) * (1 + 0.3 * math.sin(0.3 * k + 4 * x))
            rows.append(
                (
                    i * side + j,
                    (min(1.99, x), max(0.0, y), 0),
                    p if (i + j) % 97 else math.nan,
                    0.5 + abs(math.sin(x + 0.1 * k)),
                    int(x > 1),
                )
            )
    rows.append((CENTRE_ID, (1.0 + 0.02 * k, 0.5, 0), centre_pressure(k), 2.0, 1))
    return rows


def cloud(dimension, box, spacing, frames, total, note, walls=None, probes=()):
    return {
        "dimension": dimension,
        "spacing": spacing,
        "box": {"min": list(box[0]), "max": list(box[1])},
        "total": total,
        "shown": frames[0]["count"],
        "note": note,
        "fields": FIELDS,
        "materials": ["water", "light oil"],
        "frames": frames,
        "walls": walls,
        "probes": list(probes),
    }


def outline(box, *open_sides):
    """A wall without particles."""
    wall = {"name": "tank", "min": list(box[0]), "max": list(box[1]), "open": list(open_sides)}
    return {"frames": [], "boxes": [wall]}


def plane():
    blocks = Blocks()
    nowhere = (NOWHERE_ID, (math.nan, 0.5, 0), 1000.0, 1.0, 0)
    frames = [
        make_frame(blocks, k, PLANE, [*plane_rows(k), nowhere], 2) for k in range(FRAMES)
    ]
    border = [(2.0 * i / 100, 0.0) for i in range(101)] + [
        (x, i / 50) for i in range(51) for x in (0.0, 2.0)
    ]
    wall = {
        "count": len(border),
        "position": [
            blocks.add(
                "walls", [quantise(p[a], PLANE[0][a], PLANE[1][a], 65534) for p in border], "u16"
            )
            for a in (0, 1)
        ],
    }
    probes = [
        {"name": "P1", "kind": "point", "shape": "dot", "points": [[1.9, 0.1, 0]]},
        {"name": "H1 level", "kind": "level", "shape": "line", "points": [[0.5, 0, 0], [0.5, 0.9, 0]]},
        {
            "name": "inlet",
            "kind": "expression",
            "shape": "box",
            "points": [[1.2, 0.1, 0], [1.5, 0.3, 0]],
        },
    ]
    made = run(
        "plane",
        "Swaying water in a tank",
        particles=cloud(2, PLANE, 0.05, frames, 400, "", {"frames": [wall], "boxes": []}, probes),
        tables=[gauges_table(blocks), sums_table(blocks)],
        **common_parts(),
    )
    return page(report([made]), blocks, "Swaying water")


def cube_rows(k, side=12):
    rows = []
    for i in range(side):
        for j in range(side):
            for m in range(side):
                x, y, z = ((n + 0.5) / side for n in (i, j, m))
                height = 0.45 + 0.25 * math.sin(0.2 * k + 2.5 * x)
                p = 2400.0 * (1 - z) * height
                rows.append(
                    ((i * side + j) * side + m, (x, y, z * height), p, 2.5 * z, int(y > 0.5))
                )
    return rows


def cube():
    blocks = Blocks()
    frames = [make_frame(blocks, k, CUBE, cube_rows(k), 3) for k in range(20)]
    floor = [(i / 24, j / 24, 0.0) for i in range(25) for j in range(25)] + [
        (1.0, i / 24, j / 24) for i in range(25) for j in range(25)
    ]
    wall = {
        "count": len(floor),
        "position": [
            blocks.add("walls", [quantise(p[a], 0, 1, 65534) for p in floor], "u16")
            for a in range(3)
        ],
    }
    probes = [
        {"name": "P1", "kind": "point", "shape": "dot", "points": [[0.99, 0.5, 0.1]]},
        {"name": "H1", "kind": "level", "shape": "line", "points": [[0.3, 0.5, 0], [0.3, 0.5, 1]]},
        {
            "name": "box",
            "kind": "wall",
            "shape": "box",
            "points": [[0.6, 0.3, 0.1], [0.8, 0.7, 0.4]],
        },
    ]
    made = run(
        "cube",
        "Wave in a cubic tank",
        particles=cloud(3, CUBE, 1 / 12, frames, 1728, "", {"frames": [wall], "boxes": []}, probes),
        **common_parts(),
    )
    return page(report([made]), blocks, "Cubic tank")


def line():
    blocks = Blocks()
    box = ((-1.0, 0, 0), (1.0, 0, 0))
    frames = []
    for k in range(FRAMES):
        rows = [
            (
                i,
                (-1 + 2 * i / 199, 0, 0),
                1000 + 1000 * math.tanh(20 * (0.02 * k - 0.3 - (-1 + 2 * i / 199))),
                1.0,
                int(i > 100),
            )
            for i in range(200)
        ]
        frames.append(make_frame(blocks, k, box, rows, 1))
    made = run(
        "tube", "Shock tube", particles=cloud(1, box, 0.01, frames, 200, "", outline(box)), **common_parts()
    )
    return page(report([made]), blocks, "Shock tube")


def bare():
    """As little as the format allows: one particle without fields, a row without a value."""
    blocks = Blocks()
    frames = [
        {
            "time_s": 0.0,
            "count": count,
            "id": blocks.add("c", range(count), "u32"),
            "position": [blocks.add("c", [0] * count, "u16")] * 3,
            "values": [],
        }
        for count in (1, 0)
    ]
    particles = cloud(3, (CUBE[0], CUBE[0]), 0.1, frames, 1, "")
    particles.update(fields=[], materials=[], probes=[{"name": "P", "kind": "", "shape": "dot", "points": []}])
    tables = [
        {
            "name": name,
            "rows": rows,
            "rows_of": rows,
            "time": blocks.add("t", [0.0] * rows),
            "columns": [column(blocks, "t", "a", gauge, "a", "J", "energy", [math.nan] * rows)],
        }
        for name, rows, gauge in (("gauges", 1, "P"), ("sums", 0, ""))
    ]
    made = run("bare", "", particles=particles, tables=tables, end_reason="")
    return page(report([made]), blocks, "bare")


MANY_NOTE = "20 000 of 1 000 000 particles, 40 of 200 frames"


def many():
    blocks = Blocks()
    side_x, side_y = 200, 100
    frames = []
    base = [
        (i, j, 2.0 * (i + 0.5) / side_x, 0.9 * (j + 0.5) / side_y)
        for i in range(side_x)
        for j in range(side_y)
    ]
    for k in range(40):
        rows = [
            (
                (i * side_y + j) * 50,
                (x, y * (0.8 + 0.2 * math.sin(3 * x + 0.3 * k)), 0),
                2400.0 * (1 - y),
                2 * y,
                int(x > 1),
            )
            for i, j, x, y in base
        ]
        frames.append(make_frame(blocks, k, PLANE, rows, 2))
    made = run(
        "many",
        "A million particles",
        particles=cloud(2, PLANE, 0.002, frames, 10**6, MANY_NOTE, outline(PLANE, "y+")),
        tables=[gauges_table(blocks)],
        **common_parts(),
    )
    return page(report([made]), blocks, "A million particles")
