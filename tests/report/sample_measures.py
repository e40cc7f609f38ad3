"""What the gauges of samples come to."""

TIMES = ("time_of_largest", "time_of_smallest", "arrival", "duration")
# Pa and s; by gauge: largest, its time, impulse, arrival.
PEAKS = {
    "P1": (4321.0, 0.0312, 61.5, 0.0121),
    "P2": (25.5e6, 0.00021, 1250.0, 0.00018),
    "P3": (950.0, 0.2, None, None),
}


def measure(gauge, column, unit, seen=True, **numbers):
    names = ("first", "largest", "smallest", "integral_over_time", "impulse", *TIMES)
    made = {"gauge": gauge, "column": column, "unit": unit, "seen": seen}
    made.update({name: numbers.get(name) for name in names})
    return made


def measures(scale=1.0):
    """Pressures follow the scale."""
    rows = [
        measure(
            gauge,
            "pressure",
            "Pa",
            first=0.0,
            largest=scale * largest,
            time_of_largest=time,
            smallest=-12.5,
            time_of_smallest=0.4,
            integral_over_time=3.25,
            impulse=impulse,
            arrival=arrival,
        )
        for gauge, (largest, time, impulse, arrival) in PEAKS.items()
    ]
    rows.append(measure("H1", "level", "m", largest=0.15, time_of_largest=0.0))
    rows.append(measure("blind", "detached_share", "", seen=False))
    return rows


def decays():
    return [{"gauge": "line <b>", "exponent": -1.13, "points": 5, "scatter": 0.021}]
