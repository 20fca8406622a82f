# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Axisymmetric vesicles by their shape equations, without spontaneous curvature (Seifert, Berndl, Lipowsky 1991):
an ordinary differential equation for the profile, solved by shooting from the poles. Needs scipy.

Along the arc length s from a pole, r is the distance from the axis, psi the angle of the tangent, u = psi',
p the pressure, t the tension, and g the multiplier of r' = cos psi, for an energy of a quarter of the integral
of (u + sin psi / r)^2 over the area."""

import math

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

NEAR = 1e-3  # of the length, from a pole: closer, the equations are series
# curvatures at the poles, p, t, and the share of the first pole in the length; for a length of 1, at a volume.
# A shape with a mirror has one pole and half of its length, which is 1.
STARTS = {"prolate": (.98, [2.2, 52, -15.4]), "oblate": (.98, [.91, 43.7, -14.2]),
          "stomatocyte": (.6, [4.4, -9.57, 66, -4.82, .435])}


def rates(_, y, p, t):
    """of psi, u, r, g, area, volume, energy"""
    psi, u, r, g = y[:4]
    q = math.sin(psi) / r
    return [u, math.cos(psi) / r * (q - u) + g * q + p * r * math.cos(psi) / 2, math.cos(psi),
            (u * u - q * q) / 2 + p * r * math.sin(psi) + t,
            2 * math.pi * r, math.pi * r * r * math.sin(psi), math.pi / 2 * r * (u + q) ** 2]


def from_pole(u, p, t, length):
    """what `rates()` are of, at a distance from a pole of curvature u"""
    s = NEAR * length
    a = .75 * (t * u + p / 2)
    start = [u * s + a * s ** 3 / 6, u + a * s * s / 2, s - u * u * s ** 3 / 6, t * s,
             math.pi * s * s, math.pi / 4 * u * s ** 4, 2 * math.pi * u * u * s * s / 2]
    return solve_ivp(rates, (s, length), start, args=(p, t), rtol=1e-10, atol=1e-12, method="DOP853").y[:, -1]


def reduced(area, volume):
    return 6 * math.sqrt(math.pi) * volume / abs(area) ** 1.5


def halves(unknowns):
    """the two parts of a shape, up to where they meet"""
    if len(unknowns) == 3:
        return [from_pole(*unknowns, 1)] * 2
    first, second, p, t, share = unknowns
    return from_pole(first, p, t, share), from_pole(second, p, t, 1 - share)


def misfit(unknowns, volume):
    a, b = halves(unknowns)
    left = reduced(a[4] + b[4], a[5] + b[5]) - volume
    if len(unknowns) == 3:
        return [a[0] - math.pi / 2, rates(1, a, *unknowns[1:])[1], left]
    return [a[0] + b[0] - math.pi, (a[1] - b[1]) / 10, 5 * (a[2] - b[2]), a[3] + b[3], left]


def energies(name, volumes):
    """volume -> energy / 4 pi on a branch, which is followed in steps of at most .02"""
    now, unknowns = STARTS[name]
    found = {}
    for volume in sorted(volumes, key=lambda v: abs(v - now)):
        for v in numpy.linspace(now, volume, 2 + int(abs(volume - now) / .02))[1:]:
            unknowns = solved(unknowns, v)
        now = volume
        a, b = halves(unknowns)
        found[volume] = (a[6] + b[6]) / (4 * math.pi)
    return found


def solved(unknowns, volume):
    sizes = numpy.maximum(numpy.abs(unknowns), .1)
    result = least_squares(misfit, unknowns, args=(volume,), x_scale=sizes, xtol=1e-14, ftol=1e-14, gtol=1e-14)
    if result.cost > 1e-14:
        raise ArithmeticError(f"no shape of volume {volume}: {result.cost}")
    return list(result.x)


def crossing(one, other, low, high):
    """the volume where two branches have the same energy"""
    volumes = numpy.linspace(low, high, 9)
    a, b = energies(one, volumes), energies(other, volumes)
    return float(numpy.interp(0, *zip(*sorted((a[v] - b[v], v) for v in volumes))))
