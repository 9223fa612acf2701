"""What a project may take: beyond it the project is refused before it takes it, with exit code 2, and the others go on.

    budgets.py LUXGATE FOLDER    FOLDER is made anew
"""
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import time

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MOST_S = 60
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def luxgate(*words, mebibytes=1152):
    """With so much memory at the most; also the seconds that it took."""
    def limit():
        if "ASAN_OPTIONS" not in os.environ:  # a sanitizer's own memory is terabytes
            resource.setrlimit(resource.RLIMIT_DATA, (mebibytes << 20, mebibytes << 20))

    begin = time.monotonic()
    run = subprocess.run([PROGRAM, *words], cwd=WORK, capture_output=True, text=True, timeout=MOST_S * 4, check=False,
                         preexec_fn=limit)
    return run, time.monotonic() - begin


HEAD = '<luxgate version="1" maintenance-factor="0.8"><material id="m" reflectance="0.5"/><luminaire-type id="t" photometry="spot.ies"/>'
ROOM = '<room id="r" size="40 40 3" ceiling="m" walls="m" floor="m">{}</room></luxgate>'
LAMP = '<luminaire id="L" type="t" position="2 2 2.7"/>'
ASKED = '<require quantity="average" at-least="0.01"/>'
PLANE = '<plane id="p" height="0.8" count="2 2">' + ASKED + "</plane>"


def planes(count, side):
    return "".join(f'<plane id="p{i}" height="0.8" count="{side} {side}">{ASKED}</plane>' for i in range(count))


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
small_designs.write(WORK / "x.xml")
ies = (WORK / "spot.ies").read_text()
for i in range(3):
    (WORK / f"link{i}.ies").symlink_to("spot.ies")
    (WORK / f"own{i}.ies").write_text(ies.replace("TILT=NONE", f"[OTHER] file {i}\nTILT=NONE"))


def write(name, inside, head=HEAD):
    (WORK / name).write_text(head + ROOM.format(inside))


write("good.xml", LAMP + PLANE)
write("points.xml", LAMP + planes(40, 1000))
write("two-planes.xml", LAMP + planes(2, 100))
write("boxes.xml", LAMP + PLANE + '<box id="b" position="1 1 0.1" size="0.01 0.01 0.01" material="m" repeat="900 888 1" step="0.02 0.02 1"/>')
write("luminaires.xml", '<luminaire-grid id="g" type="t" origin="0 0 2.9" size="40 40" columns="1000" rows="999"/>' + PLANE)
write("elements.xml", LAMP + PLANE + "".join(f'<luminaire id="a{i}" type="t" position="2 2 2.7"/>' for i in range(300_000)))
write("cubic.xml", LAMP + PLANE, HEAD + "".join(f'<luminaire-type id="c{i}" photometry="{kind}{i}.ies" interpolation="cubic"/>' for kind in ("link", ) for i in range(3)))

refused = [("points.xml", (), "takes 40000000 calculation points; at most 10000000 are allowed, see --limit points"),
           ("two-planes.xml", ("--limit", "points=19999"), "takes 20000 calculation points; at most 19999 are allowed"),
           ("two-planes.xml", ("--limit", "memory=70M"), "MiB of memory; at most 70 MiB are allowed, see --limit memory"),
           ("boxes.xml", ("--limit", "objects=1M"), "at most 8 GiB are allowed, see --limit memory"),
           ("luminaires.xml", (), "objects and luminaires; at most 250000 are allowed, see --limit objects"),
           ("boxes.xml", ("--limit", "objects=1000"), "'b' brings the model to 799201 objects and luminaires; at most 1000 are allowed, see --limit objects"),
           ("boxes.xml", ("--limit", "objects=1M", "--limit", "triangles=1M"), "triangles; at most 1000000 are allowed, see --limit triangles"),
           ("boxes.xml", ("--limit", "objects=1M", "--limit", "memory=200M"), "GiB of memory; at most 200 MiB are allowed"),
           ("luminaires.xml", ("--limit", "objects=1M", "--limit", "memory=512M"), "of memory; at most 512 MiB are allowed"),
           ("elements.xml", ("--limit", "objects=1M", "--limit", "memory=128M"), "the elements of the project take"),
           ("good.xml", ("--limit", "points=3"), "takes 4 calculation points; at most 3 are allowed")]
for name, words, said in refused:
    others = () if name == "good.xml" else ("good.xml",)
    for command in ("check", "validate", "plan"):
        more = ("--format", "json", "--pictures", "off", "--max-paths", "64") if command == "check" else ()
        run, took_s = luxgate(command, *others, name, *words, *more)
        label = f"{command} {name} {words}"
        expect(run.returncode == 2 and said in run.stderr and "beyond-limit" in run.stderr, f"{label}: {run.returncode}, {run.stderr[-400:]}")
        expect(took_s < MOST_S, f"{label}: {took_s:.1f} s")
        if command == "check" and others:
            judged = [project["is_judged"] for project in json.loads(run.stdout)["projects"]]
            expect(judged == [True, False], f"{label}: the other project: {judged}, {run.stderr[-300:]}")

# What is just allowed is calculated, and a limit changes no number.
plain, _ = luxgate("check", "two-planes.xml", "--format", "csv", "--pictures", "off", "--max-paths", "64")
for words in (("points=20k",), ("points=1e9", "--limit", "memory=4G"), ("output=1M",)):
    limited, _ = luxgate("check", "two-planes.xml", "--format", "csv", "--pictures", "off", "--max-paths", "64", "--limit", *words)
    expect(limited.returncode == plain.returncode == 0 and limited.stdout == plain.stdout, f"{words}: {limited.returncode}, {limited.stderr}")

# Links to one file and copies of it are one table: a thousand types take no more than one.
many = HEAD + "".join(f'<luminaire-type id="c{i}" photometry="link{i % 3}.ies" interpolation="cubic"/>' for i in range(300))
for i in range(300):
    (WORK / f"copy{i}.ies").write_text(ies)
many += "".join(f'<luminaire-type id="d{i}" photometry="copy{i}.ies" interpolation="cubic"/>' for i in range(300))
write("copies.xml", LAMP + PLANE, many)
run, _ = luxgate("validate", "copies.xml", mebibytes=300)
expect(run.returncode == 0, f"six hundred copies of one file: {run.returncode}, {run.stderr[-300:]}")

# Words that copies keep.
write("long.xml", LAMP + PLANE + f'<box id="{"n" * 201}" size="0.1 0.1 0.1" material="m"/>')
run, _ = luxgate("validate", "long.xml")
expect(run.returncode == 2 and "a text of 201 bytes is not allowed; expected at most 200 bytes" in run.stderr, f"a long id: {run.returncode}, {run.stderr}")
write("groups.xml", f'<luminaire-grid id="g" type="t" origin="0 0 2.9" size="40 40" columns="300" rows="300" group="{"g" * 4000}"/>' + PLANE)
run, _ = luxgate("check", "groups.xml", "--limit", "memory=500M")
expect(run.returncode == 2 and "beyond-limit" in run.stderr, f"a long group: {run.returncode}, {run.stderr}")

# Images.
(WORK / "images").mkdir()
run, _ = luxgate("check", "two-planes.xml", "--output", "images", "--images", "--limit", "output=20k", "--max-paths", "64", mebibytes=2048)
large = [path.name for path in (WORK / "images").iterdir() if path.stat().st_size > 20480]
expect(run.returncode == 2 and "see --limit output" in run.stderr and not large, f"images: {run.returncode}, {large}, {run.stderr[-400:]}")

# Files that are written.
for kind in ("csv", "json", "html", "sarif"):
    target = WORK / f"large.{kind}"
    target.write_text("old")
    run, _ = luxgate("check", "two-planes.xml", "--format", f"{kind}={target}", "--pictures", "off", "--limit", "output=100")
    expect(run.returncode == 2 and "it would have more than 100 bytes, see --limit output" in run.stderr and target.read_text() == "old",
           f"{kind} beyond its limit: {run.returncode}, {run.stderr}")
    expect(not list(WORK.glob(".*.tmp")), f"{kind}: left behind: {list(WORK.glob('.*.tmp'))}")
run, _ = luxgate("check", "two-planes.xml", "--format", "json", "--pictures", "off", "--limit", "output=1k")
expect(run.returncode == 2 and "see --limit output" in run.stderr and len(run.stdout) <= 1024, f"standard output: {run.returncode}, {len(run.stdout)}, {run.stderr}")

for value, said in [("points", "NAME=N is needed; names: objects, triangles, points, memory or output"), ("pints=3", "NAME=N is needed"), ("points=0", "a number above 0 is needed"),
                    ("points=-1", "a number above 0"), ("memory=4GiB", "may end with k, M, G or T"), ("points=", "a number above 0"), ("memory=nan", "a number above 0"), ("=3", "NAME=N")]:
    run, _ = luxgate("check", "good.xml", "--limit", value)
    expect(run.returncode == 2 and said in run.stderr, f"--limit {value}: {run.returncode}, {run.stderr}")
print("\n".join(problems))
sys.exit(1 if problems else 0)
