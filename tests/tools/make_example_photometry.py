#!/usr/bin/env python3
"""Writes the photometry files of examples/photometry by formula.

usage: make_example_photometry.py FOLDER

Every table is scaled so that the exact integral of its bilinear interpolation (linear in gamma and C) is
the stated flux; values are then rounded to 6 significant digits.
"""

import math
import pathlib
import sys

MANUFACTURER = "luxgate examples"
NEWLINE = "\r\n"


def sine_deg(angle):
    return math.sin(math.radians(angle))


def cosine_deg(angle):
    return math.cos(math.radians(angle))


def steps(first, last, step):
    count = round((last - first) / step)
    return [first + step * i for i in range(count + 1)]


def plane_integral(gamma_deg, plane):
    """Integral of I sin(gamma) d gamma with I linear between the angles, in cd rad."""
    total = 0.0
    for i in range(len(gamma_deg) - 1):
        a, b = math.radians(gamma_deg[i]), math.radians(gamma_deg[i + 1])
        slope = (plane[i + 1] - plane[i]) / (b - a)

        def antiderivative(x):
            return -(plane[i] + slope * (x - a)) * math.cos(x) + slope * math.sin(x)

        total += antiderivative(b) - antiderivative(a)
    return total


def flux_lm(c_deg, gamma_deg, planes):
    """Flux of the stored planes; c_deg spans 0, 0..90, 0..180 or 0..360, mirrored to the full circle."""
    totals = [plane_integral(gamma_deg, plane) for plane in planes]
    if len(c_deg) == 1:
        return 2.0 * math.pi * totals[0]
    half = sum(math.radians(c_deg[i + 1] - c_deg[i]) * (totals[i] + totals[i + 1]) / 2.0
               for i in range(len(c_deg) - 1))
    return half * 360.0 / c_deg[-1]


def table(c_deg, gamma_deg, light, target_lm):
    planes = [[max(0.0, light(c, gamma)) for gamma in gamma_deg] for c in c_deg]
    scale = 1.0 if target_lm is None else target_lm / flux_lm(c_deg, gamma_deg, planes)
    planes = [[float(f"{scale * cd:.6g}") for cd in plane] for plane in planes]
    if target_lm is not None:
        assert abs(flux_lm(c_deg, gamma_deg, planes) / target_lm - 1.0) < 1e-4
    return planes


def wrapped(numbers):
    lines, line = [], ""
    for number in (f"{value:.6g}" for value in numbers):
        if len(line) + 1 + len(number) > 100:
            lines.append(line)
            line = ""
        line += (" " if line else "") + number
    return lines + [line]


def ies(name, description, c_deg, gamma_deg, light, target_lm, opening, watts):
    planes = table(c_deg, gamma_deg, light, target_lm)
    lines = [
        "IESNA:LM-63-2002",
        "[TEST] made by formula, not measured",
        "[TESTLAB] none",
        "[ISSUEDATE] 01-JAN-2026",
        f"[MANUFAC] {MANUFACTURER}",
        f"[LUMCAT] {name}",
        f"[LUMINAIRE] {description}",
        "TILT=NONE",
        f"1 -1 1 {len(gamma_deg)} {len(c_deg)} 1 2 {opening}",
        f"1 1 {watts}",
    ]
    lines += wrapped(gamma_deg) + wrapped(c_deg)
    for plane in planes:
        lines += wrapped(plane)
    return NEWLINE.join(lines) + NEWLINE


def ldt_quadrant(name, description, all_c_deg, gamma_deg, light, total_lm, length_mm, width_mm, watts):
    """Isym 4, absolute photometry: one lamp set of -1 lamps with the luminaire's flux."""
    stored = [c for c in all_c_deg if c <= 90]
    planes = table(stored, gamma_deg, light, 1000.0)  # cd/klm
    down = [[cd if gamma <= 90 else 0.0 for gamma, cd in zip(gamma_deg, plane)] for plane in planes]
    share = 100.0 * flux_lm(stored, gamma_deg, down) / flux_lm(stored, gamma_deg, planes)
    step_c, step_gamma = all_c_deg[1] - all_c_deg[0], gamma_deg[1] - gamma_deg[0]
    lines = [MANUFACTURER, "2", "4", str(len(all_c_deg)), f"{step_c:g}", str(len(gamma_deg)), f"{step_gamma:g}",
             "made by formula", description, name, f"{name}.ldt", "2026-01-01"]
    lines += [str(length_mm), str(width_mm), "60", str(length_mm), str(width_mm), "0", "0", "0", "0"]
    lines += [f"{share:.1f}", "100", "1", "0", "1"]
    lines += ["-1", "LED", f"{total_lm:g}", "4000 K", "80", f"{watts:g}"]
    lines += ["0"] * 10
    lines += [f"{angle:g}" for angle in all_c_deg + gamma_deg]
    lines += [f"{cd:.6g}" for plane in planes for cd in plane]
    return NEWLINE.join(lines) + NEWLINE


def lambert(_, gamma):
    return cosine_deg(gamma) if gamma < 90 else 0.0


def batwing(c, gamma):
    """Wings across the length (C 90), plain below; dark from 80 degrees on, for little glare."""
    if gamma >= 80:
        return 0.0
    across = 0.25 + 0.75 * sine_deg(c) ** 2
    edge = 1.0 - (gamma / 80.0) ** 8
    return edge * cosine_deg(gamma) * (1.0 + 5.0 * across * sine_deg(gamma) ** 2)


def spot(_, gamma):
    """Gaussian beam of 8 degrees full angle at half the maximum, cut off at 20 degrees (0.5 ** 25)."""
    return 0.5 ** ((gamma / 4.0) ** 2) if gamma < 20 else 0.0


def wallwasher(c, gamma):
    """A broad lobe towards C 90, 35 degrees above nadir, and a weak one straight down."""
    if gamma >= 90:
        return 0.0
    towards = sine_deg(gamma) * sine_deg(c) * sine_deg(35) + cosine_deg(gamma) * cosine_deg(35)
    return cosine_deg(gamma) * (max(0.0, towards) ** 8 + 0.08)


def road_lens(c, gamma):
    """Even along the road (C 90, C 270) and out to the street (C 0), dark above 80 degrees."""
    if gamma >= 90:
        return 0.0
    along, across = (math.tan(math.radians(gamma)) * turn for turn in (sine_deg(c), cosine_deg(c)))
    spread = math.exp(-(along / 2.8) ** 4 - ((across - 0.45) / 0.85) ** 4)
    return spread / cosine_deg(gamma) ** 1.8 / (1.0 + math.exp((gamma - 75.0) / 2.0))


def pendant(c, gamma):
    """Downwards a lobe, upwards wide wings across the length (C 0 in EULUMDAT)."""
    if gamma < 90:
        return cosine_deg(gamma) ** 2
    up = -cosine_deg(gamma)
    return 0.9 * up * (1.0 + 2.5 * (0.3 + 0.7 * cosine_deg(c) ** 2) * sine_deg(gamma) ** 2) if gamma > 90 else 0.0


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    spot_angles = steps(0, 20, 0.25) + [25, 30, 45, 60, 90]
    files = {
        "lambert_panel_600.ies": ies("lambert_panel_600", "Panel 600 x 600, Lambertian, 3600 lm", [0],
                                     steps(0, 90, 2.5), lambert, 3600, "0.6 0.6 0", 30),
        "batwing_1200.ies": ies("batwing_1200", "Linear recessed 1200 x 300, batwing, 4000 lm", steps(0, 90, 15),
                                steps(0, 90, 2.5), batwing, 4000, "0.3 1.2 0", 32),
        "spot_8deg.ies": ies("spot_8deg", "Spot of 8 degrees beam angle, 900 lm", [0], spot_angles, spot, 900,
                             "-0.08 -0.08 0", 9),
        "wallwasher.ies": ies("wallwasher", "Wall washer towards C 90, 2000 lm", steps(0, 360, 15), steps(0, 90, 5),
                              wallwasher, 2000, "0 0 0", 18),
        "pendant_direct_indirect.ldt": ldt_quadrant(
            "pendant_direct_indirect", "Pendant 1500 x 100, direct and indirect, 5400 lm", steps(0, 345, 15),
            steps(0, 180, 5), pendant, 5400, 1500, 100, 42),
        "road_lens.ies": ies("road_lens", "Road luminaire 400 x 250, 10000 lm", steps(0, 180, 15),
                             steps(0, 60, 5) + steps(62.5, 80, 2.5) + [85, 90], road_lens, 10000, "0.25 0.4 0", 75),
        "isotropic_point.ies": ies("isotropic_point", "Point source of 100 cd in all directions", [0],
                                   steps(0, 180, 10), lambda c, gamma: 100.0, None, "0 0 0", 12),
    }
    for name, text in files.items():
        (folder / name).write_bytes(text.encode("ascii"))


if __name__ == "__main__":
    main()
