"""What reports cost: time to write those of 400 planes against the time to calculate them, and bytes per plane.

    report_cost.py LUXGATE PHOTOMETRY_FILE [PLANES]

Processor time, one thread; ratios only. Rooms of eight planes of 60 points, six luminaires each. A format's time is what
'luxgate report' takes longer with it than without any, best of three; the calculation's that of 'luxgate check'.
"""
import os
import resource
import shutil
import subprocess
import sys
import tempfile

PLANES_PER_ROOM = 8


def room(number):
    luminaires = "".join(
        f'<luminaire id="r{number}x{x}y{y}" type="panel" position="{x} {y} 2.7"/>' for x in (1, 3, 5) for y in (1, 3)
    )
    planes = "".join(
        f'<plane id="r{number}p{k}" name="Plane {k}" height="{0.3 + 0.1 * k:.1f}" count="10 6">'
        f'<require quantity="average" at-least="{200 + 50 * k}"/><require quantity="Uo" at-least="0.4"/></plane>'
        for k in range(1, PLANES_PER_ROOM + 1)
    )
    return (
        f'<room id="r{number}" name="Room {number}" size="6 4 2.8" floor="f" ceiling="c" walls="w" '
        f'origin="{8 * number} 0 0">{luminaires}{planes}</room>\n'
    )


def project(rooms, photometry):
    return (
        '<luxgate version="1" name="Many planes"><material id="c" reflectance="0.7"/><material id="w" reflectance="0.5"/>'
        '<material id="f" reflectance="0.2"/>'
        f'<luminaire-type id="panel" photometry="{photometry}" flux-lm="4000" maintenance-factor="0.8"/>\n'
        + "".join(room(i + 1) for i in range(rooms)) + "</luxgate>\n"
    )


def seconds(command, runs):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    times = []
    for _ in range(runs):
        before = used()
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if done.returncode not in (0, 1, 3):
            sys.exit(done.stderr.decode())
        times.append(used() - before)
    return min(times)


def size(folder):
    return sum(os.path.getsize(os.path.join(path, name)) for path, _, names in os.walk(folder) for name in names)


def main():
    luxgate, photometry = sys.argv[1:3]
    planes = int(sys.argv[3]) if len(sys.argv) > 3 else 400
    with tempfile.TemporaryDirectory() as work:
        shutil.copy(photometry, work)
        file = os.path.join(work, "project.xml")
        with open(file, "w", encoding="utf-8") as out:
            out.write(project(planes // PLANES_PER_ROOM, os.path.basename(photometry)))
        result = os.path.join(work, "result.json")
        calculated = seconds(
            [luxgate, "check", "--quiet", "--jobs", "1", "--pictures", "off", "--format", f"json={result}", file], 1
        )
        report = [luxgate, "report", "--quiet", result]
        read = seconds(report, 3)
        for name, options in (
            ("html, split", ["--html-split", "--format", "html={}/report.html"]),
            ("html, one file", ["--format", "html={}/report.html"]),
            ("json", ["--format", "json={}/result.json"]),
            ("csv", ["--format", "csv={}/results.csv"]),
            ("sarif-all", ["--format", "sarif-all={}/all.sarif"]),
        ):
            folder = os.path.join(work, name.replace(", ", "-").replace(" ", "-"))
            written = seconds(report + [option.format(folder) for option in options], 3)
            share = max(0.0, written - read) / calculated
            print(f"report     {name + f': share of the time to calculate {planes} planes':<58} {share:.2g}")
            print(f"report     {name + ': kB a plane':<58} {size(folder) / planes / 1000:.3g}")


main()
