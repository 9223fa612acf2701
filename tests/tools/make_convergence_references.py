#!/usr/bin/env python3
"""Writes the exact references of examples/08-error-against-time: integrals done here, without luxgate.

    make_convergence_references.py FOLDER

Lamp: I = 5000 lm / 4 pi in all directions, at (1, 2, 2).
Indirect: E(x) = integral over the floor of rho / pi E_dir(y) cos_x cos_y / |x - y|^2 V(lamp, y) V(y, x) dy. The screen's
shadow and the panel's view under the screen both end in lines of constant x, so that Gauss-Legendre rules between these
lines see smooth functions only.
"""
import math
import os
import sys

INTENSITY = 5000.0 / (4.0 * math.pi)
LAMP = (1.0, 2.0, 2.0)
RHO = 0.8
SCREEN_X, SCREEN_Z = 2.5, 0.9
LOW_SCREEN_Z = 0.3  # of shadow.xml


def gauss_legendre(n):
    nodes, weights = [], []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(100):
            p0, p1 = 1.0, x
            for k in range(2, n + 1):
                p0, p1 = p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k
            slope = n * (x * p1 - p0) / (x * x - 1)
            step = p1 / slope
            x -= step
            if abs(step) < 1e-15:
                break
        nodes.append(x)
        weights.append(2.0 / ((1 - x * x) * slope * slope))
    return nodes, weights


RULE = gauss_legendre(48)


def intervals(low, high, parts):
    return [(low + (high - low) * k / parts, low + (high - low) * (k + 1) / parts) for k in range(parts)]


def points_of(pieces):
    for low, high in pieces:
        for x, w in zip(*RULE):
            yield low + 0.5 * (high - low) * (1 + x), 0.5 * (high - low) * w


def direct_on_floor(x, y, z=0.0):
    d2 = (LAMP[0] - x) ** 2 + (LAMP[1] - y) ** 2 + (LAMP[2] - z) ** 2
    return INTENSITY * (LAMP[2] - z) / d2 ** 1.5


def panel(py, pz, px=3.999, screen_z=SCREEN_Z):
    # Lit: the ray from the lamp passes below the screen. 2 - 2 (1.5 / (x - 1)) < screen_z
    lit_until = LAMP[0] + (SCREEN_X - LAMP[0]) * LAMP[2] / (LAMP[2] - screen_z)
    seen_from = 0.0
    if pz > screen_z:  # the ray from the floor at x to the point passes below: pz (2.5 - x) / (px - x) < screen_z
        seen_from = max(0.0, (SCREEN_X * pz - px * screen_z) / (pz - screen_z))
    breaks = sorted({seen_from, min(SCREEN_X, lit_until), lit_until})
    pieces = [p for a, b in zip(breaks, breaks[1:]) for p in intervals(a, b, 3)]
    across = intervals(0.0, py, 2) + intervals(py, 4.0, 2)
    total = 0.0
    for fx, wx in points_of(pieces):
        for fy, wy in points_of(across):
            d2 = (px - fx) ** 2 + (py - fy) ** 2 + pz * pz
            total += wx * wy * direct_on_floor(fx, fy) * (px - fx) * pz / (d2 * d2)
    return RHO / math.pi * total


def lit_floor(x, y, z=0.001):
    if x > SCREEN_X:
        share = (SCREEN_X - LAMP[0]) / (x - LAMP[0])
        across, height = LAMP[1] + share * (y - LAMP[1]), LAMP[2] + share * (z - LAMP[2])
        if 1.0 <= across <= 3.0 and height >= SCREEN_Z:
            return 0.0
    return direct_on_floor(x, y, z)


def write(path, plane, columns, rows, value):
    with open(path, "w", newline="\n") as file:
        file.write("# made by make_convergence_references.py\nplane,column,row,lx\n")
        for row in range(rows):
            for column in range(columns):
                file.write(f"{plane},{column},{row},{value(column, row):.10g}\n")


folder = sys.argv[1]
for name, bottom in (("reference-indirect.csv", SCREEN_Z), ("reference-shadow.csv", LOW_SCREEN_Z)):
    half = [[panel(2.9 - 0.2 * c, 0.02 + 0.06 * (r + 0.5), screen_z=bottom) for c in range(5)] for r in range(23)]
    write(os.path.join(folder, name), "panel", 10, 23, lambda c, r, half=half: half[r][min(c, 9 - c)])
write(os.path.join(folder, "reference-direct.csv"), "floor", 60, 40,
      lambda c, r: lit_floor(0.1 * (c + 0.5), 0.1 * (r + 0.5)))
