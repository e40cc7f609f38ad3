#!/usr/bin/env python3
"""Writes the reference values of this folder from their formulas; needs Python alone.

riemann_*.csv: exact solution of the Riemann problem of an ideal gas, heat capacity ratio 1.4, at
x in [0, 1] with the jump at 0.5. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics
(2009), section 4.3; problems 1 (Sod), 2 ("123") and 3 of table 4.1.
water_hugoniot_steinberg.csv: Us = c + (s1 + s2 up/Us + s3 (up/Us)^2) up with the coefficients of
water of Steinberg, UCID-20974 (1987); density by conservation of mass, 1000 kg/m^3 ahead.

The bisections and the branches are written apart from those of src/exact, to share no mistake.
"""
from math import sqrt
from pathlib import Path

GAMMA = 1.4
folder = Path(__file__).parent


def bisect(function, low, high):
    """Zero of a function that rises from low to high."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
    return 0.5 * (low + high)


def velocity_change(p, rho, p_0):
    """Change of velocity across a wave from p_0 to p: shock (p > p_0) or fan."""
    if p > p_0:
        return (p - p_0) * sqrt(2.0 / (rho * ((GAMMA + 1.0) * p + (GAMMA - 1.0) * p_0)))
    c = sqrt(GAMMA * p_0 / rho)
    return 2.0 * c / (GAMMA - 1.0) * ((p / p_0) ** ((GAMMA - 1.0) / (2.0 * GAMMA)) - 1.0)


def behind_left_wave(s, rho, u, p_0, p, u_star):
    """State at s = x / t <= u_star for a wave that runs to the left into (rho, u, p_0)."""
    c = sqrt(GAMMA * p_0 / rho)
    if p > p_0:
        ratio = (p / p_0 * (GAMMA + 1.0) + GAMMA - 1.0) / (p / p_0 * (GAMMA - 1.0) + GAMMA + 1.0)
        shock = (rho * ratio * u_star - rho * u) / (rho * ratio - rho)
        return (rho, u, p_0) if s < shock else (rho * ratio, u_star, p)
    if s < u - c:
        return rho, u, p_0
    rho_star = rho * (p / p_0) ** (1.0 / GAMMA)
    if s > u_star - sqrt(GAMMA * p / rho_star):
        return rho_star, u_star, p
    # In the fan u - a = s, and u + 2 a / (gamma - 1) is that of the state ahead.
    a = (GAMMA - 1.0) / (GAMMA + 1.0) * (u - s + 2.0 * c / (GAMMA - 1.0))
    return rho * (a / c) ** (2.0 / (GAMMA - 1.0)), s + a, p_0 * (a / c) ** (
        2.0 * GAMMA / (GAMMA - 1.0))


def riemann(left, right, s):
    """Density, velocity, pressure at x / t = s."""
    p = bisect(lambda q: velocity_change(q, left[0], left[2]) + velocity_change(
        q, right[0], right[2]) + right[1] - left[1], 1e-14, 1e6)
    u = left[1] - velocity_change(p, left[0], left[2])
    if s <= u:
        return behind_left_wave(s, *left, p, u)
    rho, v, q = behind_left_wave(-s, right[0], -right[1], right[2], p, -u)
    return rho, -v, q


def write_riemann(name, left, right, time):
    lines = ["x,density,velocity,pressure,specific_energy"]
    for k in range(50):
        x = (k + 0.5) / 50
        rho, u, p = riemann(left, right, (x - 0.5) / time)
        energy = p / ((GAMMA - 1.0) * rho)
        lines.append(",".join(f"{value:.12g}" for value in (x, rho, u, p, energy)))
    (folder / name).write_text("\n".join(lines) + "\n")


def write_hugoniot():
    lines = ["piston_velocity,shock_speed,density"]
    for up in range(0, 1001, 100):
        def excess(us):
            r = up / us
            return us - 1480.0 - (2.56 - 1.986 * r + 0.2268 * r * r) * up
        us = bisect(excess, 1480.0, 1e4)
        lines.append(f"{up},{us:.10g},{1000.0 * us / (us - up):.10g}")
    (folder / "water_hugoniot_steinberg.csv").write_text("\n".join(lines) + "\n")


write_riemann("riemann_sod_t0.2.csv", (1.0, 0.0, 1.0), (0.125, 0.0, 0.1), 0.2)
write_riemann("riemann_toro2_t0.15.csv", (1.0, -2.0, 0.4), (1.0, 2.0, 0.4), 0.15)
write_riemann("riemann_toro3_t0.012.csv", (1.0, 0.0, 1000.0), (1.0, 0.0, 0.01), 0.012)
write_hugoniot()
