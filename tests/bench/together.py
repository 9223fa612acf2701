#!/usr/bin/env python3
"""How often intervals hold the truth where several quantities of a plane are judged together, at the look where it stopped.

    together.py LUXGATE [SEEDS]

Eight small projects; on one plane of each the average, the minimum, Uo and the median are required, the last three 3 %
below the truth with even seeds and 3 % above it with odd ones, so that points are left out while others go on. The truth
comes from one long run with another seed.
Printed are, of 400 seeds unless told otherwise, the share of intervals that hold it, the mean error of the value, the mean
half width over the root mean square error (2.0 would be a normal interval of just 95 %), and wrong verdicts.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

LM63 = """IESNA:LM-63-2002
[TEST] by formula
[TESTLAB] none
[ISSUEDATE] 2026
[MANUFAC] none
TILT=NONE
1 -1 1 {count} 1 1 2 {size}
1 1 20
{gammas}
0
{candelas}
"""


def table(size, *pairs):
    return LM63.format(count=len(pairs), size=size, gammas=" ".join(f"{g:g}" for g, _ in pairs),
                       candelas=" ".join(f"{c:.6g}" for _, c in pairs))


COSINE = [(g, 1000 * math.cos(math.radians(g))) for g in range(0, 91, 10)]
FILES = {
    "panel.ies": table("0.6 0.6 0", *COSINE),
    "point.ies": table("0 0 0", *COSINE),
    "spot.ies": table("0.1 0.1 0", (0, 6000), (5, 5000), (10, 2000), (15, 400), (20, 0), (90, 0)),
    "beam.ies": table("1 1 0", (0, 1e5), (0.5, 1e5), (1, 1e5), (1.1, 0), (90, 0)),
}
TYPES = "".join(f'<luminaire-type id="{name[:-4]}" photometry="{name}"/>' for name in FILES)


def room(size, reflectances, inside, extra=""):
    floor, walls, ceiling = reflectances
    return (f'<material id="f" reflectance="{floor}"/><material id="w" reflectance="{walls}"/><material id="c" reflectance="{ceiling}"/>'
            f'{TYPES}<room id="r" size="{size}" floor="f" walls="w" ceiling="c" {extra}>{inside}</room>')


DESK = '<box id="desk" size="1.6 0.8 0.7" position="1 1 0" material="w"/><box id="shelf" size="0.4 2 2" position="0 2 0" material="f"/>'
GRID = '<luminaire-grid id="L" type="{}" origin="0 0 {}" size="{}" columns="{}" rows="{}"/>'
PLANE = '<plane id="p" origin="{}" u="{}" v="{}" count="{}">{}</plane>'
FAMILIES = {
    "office": lambda ask: room("6 4 2.8", (0.3, 0.5, 0.7), DESK + GRID.format("panel", 2.79, "6 4", 3, 2)
                               + PLANE.format("0.5 0.5 0.75", "5 0 0", "0 3 0", "6 4", ask)),
    "dark hall": lambda ask: room("20 12 8", (0.1, 0.1, 0.1), GRID.format("point", 7.9, "20 12", 2, 1)
                                  + '<box id="rack" size="1 8 6" position="9.5 2 0" material="f"/>'
                                  + PLANE.format("1 1 0.8", "18 0 0", "0 10 0", "6 4", ask)),
    "narrow beam": lambda ask: room("4 4 3", (0.5, 0.5, 0.5), '<luminaire id="l" type="beam" position="2 2 1.5"/>'
                                    + PLANE.format("1.55 1.55 0.001", "0.9 0 0", "0 0.9 0", "5 5", ask)),
    "bright corridor": lambda ask: room("12 1.6 2.6", (0.6, 0.8, 0.8), GRID.format("panel", 2.59, "12 1.6", 4, 1)
                                        + PLANE.format("0.3 0.3 0.01", "11.4 0 0", "0 1 0", "12 3", ask)),
    "behind a screen": lambda ask: room("6 4 3", (0.3, 0.6, 0.7),
                                        '<luminaire id="l" type="point" position="1 2 2.8"/>'
                                        '<box id="screen" size="0.05 4 2.4" position="3 0 0" material="w"/>'
                                        + PLANE.format("3.5 0.5 0.75", "2 0 0", "0 3 0", "4 6", ask)),
    "washed wall": lambda ask: room("5 4 3", (0.2, 0.7, 0.7), GRID.format("spot", 2.99, "5 0.4", 5, 1)
                                    + PLANE.format("0.5 1 0.8", "4 0 0", "0 2.5 0", "6 4", ask)),
    "far off": lambda ask: room("6 4 2.8", (0.3, 0.5, 0.7), DESK + GRID.format("panel", 2.79, "6 4", 2, 2)
                                        + '<box id="stray" size="1 1 1" position="5000 0 0" material="f"/>'
                                        + PLANE.format("0.5 0.5 0.75", "5 0 0", "0 3 0", "6 4", ask),
                                        'origin="81234.5 -45678.9 120"'),
    "yard": lambda ask: (f'<material id="f" reflectance="0.4"/>{TYPES}<luminaire id="a" type="point" position="0 0 5"/>'
                         '<luminaire id="b" type="panel" position="9 3 5"/><quad id="ground" origin="-20 -20 0" u="50 0 0" v="0 50 0" material="f"/>'
                         '<box id="house" size="8 6 6" position="-12 4 0" material="f"/><box id="far" size="9 9 9" position="900 0 0" material="f"/>'
                         + PLANE.format("-3 -3 0.5", "12 0 0", "0 8 0", "6 4", ask)),
}
QUANTITIES = {"average": 'quantity="average"', "minimum": 'quantity="minimum"', "Uo": 'quantity="Uo"', "median": 'quantity="percentile" percent="50"'}


def project(family, limits):
    ask = "".join(f'<require id="{name}" {words} at-least="{limits[name]:.9g}"/>' for name, words in QUANTITIES.items())
    return f'<luxgate version="1" maintenance-factor="1">{FAMILIES[family](ask)}</luxgate>'


def run(program, folder, xml, *arguments):
    (folder / "p.xml").write_text(xml)
    done = subprocess.run([program, "check", "p.xml", "--quiet", "--pictures", "off", "--format", "json=r.json", *arguments],
                          cwd=folder, capture_output=True, text=True)
    if done.returncode not in (0, 1, 3):
        sys.exit(done.stderr)
    plane = json.loads((folder / "r.json").read_text())["projects"][0]["spaces"][-1]["planes"][0]
    return {finding["requirement"]: finding for finding in plane["findings"]}


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    print("| family | quantity | held | error of the mean | half width / RMS | wrong verdicts | undecided |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file, text in FILES.items():
            (folder / file).write_text(text)
        for family in FAMILIES:
            long_run = run(program, folder, project(family, dict.fromkeys(QUANTITIES, 1e-3)), "--seed", "987654", "--goal", "accuracy",
                           "--tolerance", "0.0015", "--replicates", "64", "--max-paths", "262144")
            truth = {name: finding["measured"]["value"] for name, finding in long_run.items()}
            close = [{name: value * (0.7 if name == "average" else off) for name, value in truth.items()} for off in (0.97, 1.03)]
            found = [run(program, folder, project(family, close[seed % 2]), "--seed", str(seed), "--max-paths", "16384")
                     for seed in range(1, seeds + 1)]
            for quantity in QUANTITIES:
                measured = [one[quantity]["measured"] for one in found]
                errors = [m["value"] / truth[quantity] - 1.0 for m in measured]
                held = sum(m["low"] <= truth[quantity] <= (math.inf if m["high"] is None else m["high"]) for m in measured)
                rms = math.sqrt(sum(e * e for e in errors) / len(errors))
                half = sum((m["high"] or m["value"]) - m["low"] for m in measured) / 2.0 / len(measured) / truth[quantity]
                is_met = [quantity == "average" or seed % 2 == 0 for seed in range(1, seeds + 1)]
                wrong = sum(one[quantity]["verdict"] == ("fail" if met else "pass") for one, met in zip(found, is_met))
                undecided = sum(one[quantity]["verdict"] == "undecided" for one in found)
                print(f"| {family} | {quantity} | {100.0 * held / seeds:.1f} % | {100.0 * sum(errors) / len(errors):+.2f} % | "
                      f"{half / rms if rms > 0 else math.inf:.1f} | {wrong} | {undecided} |", flush=True)


if __name__ == "__main__":
    main()
