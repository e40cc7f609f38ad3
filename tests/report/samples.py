"""All samples by name."""
import sample_particles
import sample_report
import sample_sweep

SAMPLES = {
    "gauges": sample_report.gauges_only,
    "overlaid": sample_report.overlaid,
    "hostile": sample_report.hostile,
    "plane": sample_particles.plane,
    "bare": sample_particles.bare,
    "cube": sample_particles.cube,
    "line": sample_particles.line,
    "many": sample_particles.many,
    "sweep": sample_sweep.sweep,
}
