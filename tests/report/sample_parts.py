"""What all sample runs have in common: facts, quality, timing, settings."""

from sample_measures import decays, measures

SHA_256 = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"


def common_parts():
    return {
        "facts": [
            {"label": "Particles", "value": "20 000"},
            {"label": "Dimension", "value": "2"},
            {"label": "Spacing", "value": "5 mm"},
            {"label": "Physical time", "value": "0.5 s"},
            {"label": "Steps", "value": "25 013"},
            {"label": "Computing time", "value": "3 min 12 s on 8 threads"},
            {"label": "Precision", "value": "mixed"},
            {"label": "Case", "value": "cases/dam-break-2d/case.toml"},
            {"label": "SHA-256 of the case", "value": SHA_256},
        ],
        "quality": [
            {
                "name": "energy balance",
                "verdict": "good",
                "value": "0.12 %",
                "limit": "1 %",
                "meaning": "drift of the energy balance over the run, as a share of the energy that was exchanged",
            },
            {
                "name": "density range",
                "verdict": "doubtful",
                "value": "2.7 %",
                "limit": "2 %",
                "meaning": "largest departure from the density at rest; more than two per cent says that the sound speed is too low",
            },
            {
                "name": "lost particles",
                "verdict": "bad",
                "value": "31",
                "limit": "0",
                "meaning": "particles that left the domain and were removed",
            },
            {
                "name": "resolution",
                "verdict": "unknown",
                "value": "–",
                "limit": "–",
                "meaning": "needs a second run with another spacing",
            },
        ],
        "comparisons": [
            {
                "name": "largest pressure at P1",
                "unit": "Pa",
                "value": 4321.0,
                "reference": 4500.0,
                "tolerance": 450.0,
                "verdict": "good",
                "source": "Example and Sample (1999), table 2",
            },
            {
                "name": "arrival of the wave",
                "unit": "s",
                "value": 0.0312,
                "reference": 0.025,
                "tolerance": 0.002,
                "verdict": "bad",
                "source": "Example and Sample (1999), table 3",
            },
            {
                "name": "height of the run-up",
                "unit": "m",
                "value": None,
                "reference": 0.3,
                "tolerance": None,
                "verdict": "unknown",
                "source": "theory",
            },
        ],
        "stages": [
            {"name": "settling", "time_s": 0.0, "step": 0, "cause": "start"},
            {
                "name": "gate opens",
                "time_s": 0.1,
                "step": 5013,
                "cause": "kinetic energy below 1e-3 J",
            },
        ],
        "measures": measures(),
        "decays": decays(),
        "votes": [
            {"reason": "sound speed", "steps": 20010, "share": 0.8, "least_time_step_s": 1.9e-5},
            {"reason": "viscosity", "steps": 5003, "share": 0.2, "least_time_step_s": 1.2e-5},
        ],
        "timing": [
            {"label": "pair forces", "seconds": 120.5, "calls": 50026},
            {"label": "neighbour search", "seconds": 40.2, "calls": 1200},
            {"label": "output", "seconds": 6.1, "calls": 200},
            {"label": "equations of state", "seconds": 0.4, "calls": 25013},
        ],
        "settings": [
            {
                "section": "domain",
                "key": "spacing",
                "value": "0.005",
                "unit": "m",
                "is_default": False,
                "meaning": "distance of particles at the start",
            },
            {
                "section": "solver",
                "key": "kernel",
                "value": "wendland_c2",
                "unit": "",
                "is_default": True,
                "meaning": "smoothing kernel",
            },
            {
                "section": "material.water",
                "key": "sound_speed",
                "value": "40",
                "unit": "m/s",
                "is_default": False,
                "meaning": "numerical speed of sound",
            },
            {
                "section": "solver",
                "key": "courant",
                "value": "0.25",
                "unit": "",
                "is_default": True,
                "meaning": "share of the largest stable time step",
            },
        ],
    }
