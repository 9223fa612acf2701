"""Time to verdict on projects like users': furnished offices, many small planes, many rooms, a large hall, dark racks.

    users_projects.py LUXGATE [OLDER_LUXGATE] [--only NAME ...] [--keep FOLDER] [--quick]

Processor time of one thread from start to exit, best of three, without pictures. With two programs each project is run by
both in turn: the ratio of their times, verdicts that differ, intervals that do not meet, and the median ratio of interval
widths. --keep leaves the projects and the results there; --quick takes the two smallest, once, for ctest.
"""
import argparse
import json
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
PANEL, SPOT = "batwing_1200.ies", "spot_8deg.ies"


def head(name, flux_lm=5200, materials=()):
    usual = {"white": 0.7, "wall": 0.5, "floor": 0.2, "wood": 0.4, **dict(materials)}
    return f'<luxgate version="1" name="{name}" maintenance-factor="0.8">\n' + "".join(
        f'<material id="{key}" reflectance="{rho}"/>' for key, rho in usual.items()
    ) + f'\n<luminaire-type id="panel" photometry="{PANEL}" flux-lm="{flux_lm}"/>\n'


def room(key, size, inside, surfaces="white wall floor", origin="0 0 0"):
    ceiling, walls, floor = surfaces.split()
    return (f'<room id="{key}" size="{size}" origin="{origin}" ceiling="{ceiling}" walls="{walls}" floor="{floor}">\n'
            f"{inside}</room>\n")


def panels(key, origin, size, columns, rows):
    return (f'<luminaire-grid id="{key}" type="panel" origin="{origin}" size="{size}" columns="{columns}" '
            f'rows="{rows}"/>\n')


def plane(key, origin, u, v, count, *limits):
    asked = "".join(f'<require quantity="{quantity}" at-least="{least}"/>' for quantity, least in limits)
    return f'<plane id="{key}" origin="{origin}" u="{u}" v="{v}" count="{count}">{asked}</plane>\n'


def box(key, size, position, material="wood"):
    return f'<box id="{key}" size="{size}" position="{position}" material="{material}"/>\n'


def forty_planes():
    text = panels("L", "0 0 2.95", "24 15", 8, 6)
    for i in range(8):
        for j in range(5):
            x, y = 0.9 + 2.9 * i, 0.8 + 2.9 * j
            text += box(f"desk{i}{j}", "1.6 0.8 0.03", f"{x} {y} 0.7")
            text += box(f"screen{i}{j}", "1.6 0.03 0.5", f"{x} {y + 0.8:.2f} 0.7", "wall")
            text += plane(f"task{i}{j}", f"{x} {y} 0.75", "1.6 0 0", "0 0.8 0", "8 6", ("average", 300), ("Uo", 0.5))
    return head("Forty task areas") + room("office", "24 15 3", text) + "</luxgate>\n"


def offices(rooms, desks, planes):
    text = head(f"{rooms} rooms")
    for r in range(rooms):
        inside = panels(f"L{r}", "0 0 2.75", "5.4 4.2", 2, 2)
        for d in range(desks):
            inside += box(f"r{r}desk{d}", "1.6 0.8 0.72", f"{0.5 + 2.4 * (d % 2)} {0.5 + 2.2 * (d // 2)} 0")
        for p in range(planes):
            inside += plane(f"r{r}p{p}", f"{0.5 + 2.4 * (p % 2)} {0.5 + 2.2 * (p // 2)} 0.75", "1.6 0 0", "0 0.8 0", "8 6",
                            ("average", 300), ("Uo", 0.5))
        text += room(f"r{r}", "5.4 4.2 2.8", inside, origin=f"{7 * (r % 20)} {6 * (r // 20)} 0")
    return text + "</luxgate>\n"


def large_hall():
    return head("Hall of 1e5 points", 16000) + room(
        "hall", "68 48 9", panels("L", "0 0 8.5", "68 48", 17, 12) + box("press", "6 3 3", "20 20 0") +
        box("store", "10 4 4", "40 30 0") +
        plane("floor", "0.5 0.5 0.8", "67 0 0", "0 47 0", "400 250", ("average", 300), ("Uo", 0.4))) + "</luxgate>\n"


def dark_racks():
    racks = "".join(box(f"rack{k}", "50 1.2 9", f"5 {2 + 3.4 * k:.1f} 0", "floor") for k in range(8))
    aisles = "".join(plane(f"aisle{k}", f"6 {3.4 + 3.4 * k:.1f} 0.02", "48 0 0", "0 1.6 0", "60 5", ("average", 50), ("minimum", 3))
                     for k in range(7))
    return head("Racks", 16000) + room("store", "60 31 11", panels("L", "0 0 10.8", "60 31", 10, 6) + racks + aisles,
                                       "wall floor floor") + "</luxgate>\n"


def stiff_corridor():
    return head("Bright corridor", materials={"bright": 0.92}.items()) + room(
        "corridor", "40 2 2.6", panels("L", "0 0 2.55", "40 2", 8, 1) +
        plane("floor", "0.2 0.2 0.02", "39.6 0 0", "0 1.6 0", "80 6", ("average", 400), ("Uo", 0.5)),
        "bright bright bright") + "</luxgate>\n"


def open_scene():
    return (head("Wall in the open", materials={"plaster": 0.8}.items()) +
            f'<luminaire-type id="spot" photometry="{SPOT}"/>\n'
            '<quad id="wall" origin="0 0 0" u="8 0 0" v="0 0 5" material="plaster"/>\n'
            '<luminaire id="a" type="spot" position="4 -4 0.5" aim="4 0 2.5"/>\n' +
            plane("path", "0 -6 0.5", "8 0 0", "0 3 0", "15 15", ("average", 0.5)) + "</luxgate>\n")


def outdoor_area():
    grid = '<luminaire-grid id="mast" type="panel" origin="0 0 10" size="120 80" columns="5" rows="4"/>\n'
    sheds = "".join(box(f"shed{k}", "12 6 4", f"{10 + 26 * k} 30 0", "wall") for k in range(4))
    return (head("Yard", 30000) + '<quad id="ground" origin="-20 -20 0" u="160 0 0" v="0 120 0" material="floor"/>\n' + grid +
            sheds + plane("yard", "0 0 0.02", "120 0 0", "0 28 0", "120 28", ("average", 10), ("Uo", 0.2)) +
            plane("back", "0 40 0.02", "120 0 0", "0 40 0", "120 40", ("average", 10), ("Uo", 0.2)) + "</luxgate>\n")


def example(name):
    return EXAMPLES / name / "project.xml"


PROJECTS = {
    "office": example("04-office"),
    "office-by-row": example("09-office-by-row"),
    "open-office": example("10-open-office"),
    "classroom": example("11-classroom"),
    "warehouse": example("12-warehouse-aisle"),
    "escape-route": example("13-escape-route"),
    "sports-hall": example("15-sports-hall"),
    "road": example("16-road"),
    "forty-planes": forty_planes,
    "ten-rooms": lambda: offices(10, 4, 4),
    "two-hundred-rooms": lambda: offices(200, 2, 1),
    "large-hall": large_hall,
    "dark-racks": dark_racks,
    "stiff-corridor": stiff_corridor,
    "open-scene": open_scene,
    "outdoor-area": outdoor_area,
}


def check(program, project, result):
    """Seconds of processor time; the result file is written."""
    arguments = []
    if (project.parent / "arguments").exists():
        arguments = [word.replace("{dir}", str(project.parent)) for word in (project.parent / "arguments").read_text().split()]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "check", project, *arguments, "--jobs", "1", "--pictures", "off", "-q",
                           "--format", f"json={result}"], capture_output=True, text=True, cwd=project.parent)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if "error[" in done.stderr:
        sys.exit(f"{project}: exit code {done.returncode}\n{done.stderr}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def findings(result):
    """(space, plane, number) -> verdict, low, high."""
    found = {}
    for project in json.loads(pathlib.Path(result).read_text())["projects"]:
        for space in project["spaces"]:
            for one in space["planes"]:
                for k, finding in enumerate(one["findings"]):
                    measured = finding.get("measured") or {}
                    found[space["id"], one["id"], k] = (finding["verdict"], measured.get("low"), measured.get("high"))
    return found


def compared(older, newer):
    changed = [key for key in older if older[key][0] != newer.get(key, (None,))[0]]
    apart, ratios = 0, []
    for key, (_, low, high) in older.items():
        _, new_low, new_high = newer.get(key, (None, None, None))
        if None in (low, high, new_low, new_high):
            continue
        apart += low > new_high or new_low > high
        if high > low and new_high > new_low:
            ratios.append((new_high - new_low) / (high - low))
    width = f"{statistics.median(ratios):.2f}" if ratios else "-"
    names = "".join(f"; {'/'.join(map(str, key))}: {older[key][0]} -> {newer.get(key, ('none',))[0]}" for key in changed[:4])
    return f"| {len(changed)} of {len(older)}{names} | {apart} | {width} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="+", metavar="LUXGATE")
    parser.add_argument("--only", nargs="+", choices=PROJECTS, metavar="NAME", default=list(PROJECTS))
    parser.add_argument("--keep")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    programs = [os.path.abspath(program) for program in options.programs]
    if options.quick:
        options.only, options.repeats = ["stiff-corridor", "open-scene"], 1
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.keep or scratch)
        print("| project | s |" if len(programs) == 1 else
              "| project | new, s | old, s | old / new | verdicts changed | intervals apart | width, new / old |")
        print("|---" * (2 if len(programs) == 1 else 7) + "|")
        for name in options.only:
            project = PROJECTS[name]
            if callable(project):
                text, project = project(), folder / name / "project.xml"
                project.parent.mkdir(parents=True, exist_ok=True)
                project.write_text(text)
                for photometry in (PANEL, SPOT):
                    shutil.copy(EXAMPLES / "photometry" / photometry, project.parent)
            results = [folder / f"{name}.{k}.json" for k in range(len(programs))]
            best = [float("inf")] * len(programs)
            for _ in range(options.repeats):
                for k, program in enumerate(programs):
                    best[k] = min(best[k], check(program, project, results[k]))
            line = f"| {name} | {best[0]:.3f} |"
            if len(programs) > 1:
                line += f" {best[1]:.3f} | {best[1] / best[0]:.2f} {compared(findings(results[1]), findings(results[0]))}"
            print(line, flush=True)


main()
