"""A report of a sweep, and the growing data of a running program."""
import math

from report_writer import Blocks, column, page, report, run
from sample_particles import PLANE, cloud, make_frame, plane_rows
from sample_parts import common_parts
from sample_report import gauges_table

SPACINGS = (0.02, 0.01, 0.005)
KERNELS = ("wendland_c2", "cubic_spline")
LIVE_END = 0.5


def peak(spacing, kernel):
    """Pa."""
    return 4500.0 - 60000.0 * spacing - (100.0 if kernel == KERNELS[1] else 0.0)


def sweep():
    blocks = Blocks()
    runs, members = [], []
    for kernel in KERNELS:
        for spacing in SPACINGS:
            name = f"{kernel}-{spacing}"
            failed = kernel == KERNELS[1] and spacing == 0.005
            index = None
            if not failed:
                index = len(runs)
                parts = common_parts()
                parts["tables"] = [gauges_table(blocks, 201, peak(spacing, kernel) / 4500.0, name)]
                runs.append(run(name, f"spacing {spacing * 1000:g} mm, {kernel}", **parts))
            members.append(
                {
                    "name": name,
                    "state": "failed" if failed else "done",
                    "message": "density out of bounds at step 812" if failed else "",
                    "run": index,
                    "values": [spacing, kernel],
                    "outputs": [None, None] if failed else [peak(spacing, kernel), 30.0 / spacing],
                    "steps": 812 if failed else 25013,
                    "wall_time_s": 30.0 / spacing,
                }
            )
    members.append(
        {
            "name": "wendland_c2-0.0025",
            "state": "waiting",
            "message": "",
            "run": None,
            "values": [0.0025, KERNELS[0]],
            "outputs": [None, None],
            "steps": None,
            "wall_time_s": None,
        }
    )
    content = report(
        runs,
        {
            "title": "Spacing and kernel",
            "parameters": [{"label": "spacing", "unit": "m"}, {"label": "kernel", "unit": ""}],
            "outputs": [
                {"label": "largest pressure", "unit": "Pa"},
                {"label": "computing time", "unit": "s"},
            ],
            "members": members,
        },
    )
    return page(content, blocks, "Spacing and kernel")


def live_page():
    return page(
        report([], live={"data": "data.json", "interval_s": 0.2}), Blocks(), "A running program"
    )


def live_value(t):
    """Pa."""
    return 1000.0 * math.sin(20.0 * t)


def live_data(revision, rows, frames, state="running"):
    """What the program answers after so many rows and frames."""
    blocks = Blocks()
    at = [0.005 * i for i in range(rows)]
    table = {
        "name": "gauges",
        "rows": rows,
        "rows_of": rows,
        "time": blocks.add("gauges", at),
        "columns": [
            column(
                blocks,
                "gauges",
                "P1 pressure",
                "P1",
                "pressure",
                "Pa",
                "point",
                [live_value(t) for t in at],
            )
        ],
    }
    particles = cloud(
        2,
        PLANE,
        0.05,
        [make_frame(blocks, k, PLANE, plane_rows(k), 2) for k in range(frames)],
        400,
        "",
    )
    progress = {
        "time_s": at[-1],
        "end_time_s": LIVE_END,
        "step": rows * 50,
        "time_step_s": 1e-4,
        "limited_by": "sound speed",
        "steps_per_second": 812.0,
        "time_left_s": 75.0,
        "particles": 400,
    }
    parts = common_parts()
    parts.update(
        tables=[table],
        particles=particles,
        state=state,
        end_reason="" if state == "running" else "end time reached",
        progress=progress if state == "running" else None,
    )
    content = report([run("live", "A running program", **parts)])
    content["revision"] = revision
    content["blocks"] = blocks.encoded()
    return content
