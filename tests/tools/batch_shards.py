"""A batch that several machines share through a store: the same bytes as one machine's, whoever calculates what, in which order, how
often; what is missing is named.

    batch_shards.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = pathlib.Path(sys.argv[3]).resolve()
FORMATS = ["json", "html", "csv", "text", "sarif-all"]
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def luxgate(*words, **options):
    return subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True, check=False, cwd=WORK, **options)


def projects():
    """Small designs, some with several rooms, one that cannot be read, and an office of five planes."""
    shutil.copytree(EXAMPLES / "04-office", WORK / "office")
    shutil.copytree(EXAMPLES / "photometry", WORK / "photometry")
    paths = [small_designs.write(WORK / "designs" / f"{k:02}.xml", name=f"Design {k}", points=3 + k, columns=2 + k % 3) for k in range(9)]
    broken = WORK / "designs" / "broken.xml"
    broken.write_text("<luxgate version='1'><room id='a'/></luxgate>")
    for path in paths[:3]:  # a second room
        text = pathlib.Path(path).read_text()
        first = room = text[text.index("<room"):text.index("</room>") + len("</room>")]
        for name in ("room", "desk", "far", "L"):
            room = room.replace(f'id="{name}"', f'id="{name}-2"')
        other = room.replace('size="5 4 2.8"', 'origin="20 0 0" size="5 4 3"', 1)
        pathlib.Path(path).write_text(text.replace(first, first + "\n" + other))
    return [os.path.relpath(path, WORK) for path in [*paths, broken]] + ["office/project.xml"]


def report(name, *options):
    """All formats into a folder of that name."""
    out = WORK / name
    out.mkdir()
    run = luxgate("check", *PROJECTS, "--pictures", "off", *options, *[f"--format={kind}={name}/x.{kind}" for kind in FORMATS])
    return run, {kind: (out / f"x.{kind}").read_bytes() for kind in FORMATS}


def is_same(name, *options):
    run, written = report(name, *options)
    expect(run.returncode == CODE, f"{name}: exit code {run.returncode}, expected {CODE}: {run.stderr}")
    for kind in FORMATS:
        expect(written[kind] == ONE[kind], f"{name}: another {kind} than one machine's")


def shard(store, i, n, *options):
    run = luxgate("check", *PROJECTS, "--store", store, "--shard", f"{i}/{n}", *options)
    expect(run.returncode == 0 and run.stdout == "", f"shard {i}/{n} {options}: {run.returncode}, {run.stderr}, {run.stdout}")
    return run


def any_split():
    """Other counts, in any order, some twice, with units that somebody else has cut otherwise."""
    order = random.Random(7)
    for n in (1, 2, 4, 30):
        store = f"store-{n}"
        numbers = list(range(1, n + 1))
        order.shuffle(numbers)
        for i in [*numbers, numbers[0]]:
            shard(store, i, n, "--units", "units.json", "--jobs", 1 + i % 2)
        is_same(f"shards-{n}", "--store", store, "--stored-only")
    # Each plane of its own, and planned by every shard anew.
    listed = json.loads((WORK / "units.json").read_text())
    listed["units"] = [{**unit, "planes": [plane], "whole_space": False} for unit in listed["units"] for plane in unit["planes"]]
    (WORK / "planes.json").write_text(json.dumps(listed))
    for i in (2, 1, 3):
        shard("store-planes", i, 3, "--units", "planes.json")
    is_same("shards-planes", "--store", "store-planes", "--stored-only", "--jobs", "1")
    for i in (1, 2):
        shard("store-planned", i, 2)
    is_same("shards-planned", "--store", "store-planned", "--stored-only")


def what_is_missing():
    shard("store-half", 1, 2, "--units", "units.json")
    mine = luxgate("check", *PROJECTS, "--store", "store-half", "--stored-only")
    expect(mine.returncode == 2, f"half a store: exit code {mine.returncode}, expected 2")
    line = next((line for line in mine.stderr.splitlines() if "error[store-lacks-units]" in line), "")
    named = line.count(".xml: ") - line.count(".xml: error")
    expect(0 < named < len(UNITS) and f"{named} of the {len(UNITS)} jobs" in line, f"half a store: {line}")
    expect("pass" in mine.stdout and "not judged" in mine.stdout, "half a store: what is there is not judged")
    is_same("half-goes-on", "--store", "store-half")  # without --stored-only the rest is calculated
    is_same("half-is-whole", "--store", "store-half", "--stored-only")
    empty = luxgate("check", *PROJECTS, "--store", "store-empty", "--stored-only")
    expect(empty.returncode == 2 and f"{len(UNITS)} of the {len(UNITS)} jobs" in empty.stderr, f"an empty store: {empty.stderr}")
    expect(not list(WORK.glob("store-empty/*/*")), "an empty store: something was calculated")


def killed():
    """At any moment, again and again; then two at once: nothing is wrong, and what was done is there."""
    order = random.Random(11)
    for _ in range(12):
        process = subprocess.Popen([PROGRAM, "check", *PROJECTS, "--store", "store-killed", "--shard", f"{order.randint(1, 2)}/2"], cwd=WORK,
                                   stderr=subprocess.DEVNULL)
        time.sleep(order.random() * 0.15)
        process.send_signal(order.choice([signal.SIGKILL, signal.SIGTERM]))
        process.wait()
    both = [subprocess.Popen([PROGRAM, "check", *PROJECTS, "--store", "store-killed", "--shard", f"{i}/2"], cwd=WORK, stderr=subprocess.DEVNULL)
            for i in (1, 2, 2)]
    for process in both:
        process.wait()
    is_same("killed", "--store", "store-killed", "--stored-only")


def bad_words():
    good = ["check", *PROJECTS]
    for words, code, said in [
            ([*good, "--shard", "1/2"], 2, "--shard needs --store"),
            ([*good, "--stored-only"], 2, "--stored-only needs --store"),
            ([*good, "--resume"], 2, "--resume needs --output"),
            ([*good, "--resume", "--output", "o", "--stored-only"], 2, "exclude each other"),
            ([*good, "--units", "units.json"], 2, "--units needs --shard"),
            ([*good, "--store", "s", "--shard", "0/2"], 2, "is not a share of a batch"),
            ([*good, "--store", "s", "--shard", "3/2"], 2, "is not a share of a batch"),
            ([*good, "--store", "s", "--shard", "1"], 2, "is not a share of a batch"),
            ([*good, "--store", "s", "--shard", "1/2", "--stored-only"], 2, "exclude each other"),
            ([*good, "--store", "s", "--shard", "1/2", "--format", "json"], 2, "writes no report"),
            ([*good, "--store", "s", "--shard", "1/2", "--time-limit", "5"], 2, "exclude each other"),
            ([*good, "--store", "s", "--shard", "1/2", "--units", "nowhere.json"], 2, "units-not-readable"),
            ([*good, "--store", "s", "--shard", "1/2", "--units", "designs/00.xml"], 2, "units-not-readable"),
            (["check", PROJECTS[1], "--store", "s", "--shard", "1/2", "--units", "units.json"], 2, "is not among the projects")]:
        run = luxgate(*words)
        expect(run.returncode == code and said in run.stderr, f"{words[-4:]}: {run.returncode}, {run.stderr}")
    other = json.loads((WORK / "units.json").read_text())
    for change, said in [({"space": "elsewhere"}, "has no such space"), ({"planes": ["elsewhere"]}, "has other planes")]:
        (WORK / "other.json").write_text(json.dumps({**other, "units": [{**UNITS[0], **change}]}))
        run = luxgate(*good, "--store", "s", "--shard", "1/1", "--units", "other.json")
        expect(run.returncode == 2 and said in run.stderr, f"{change}: {run.returncode}, {run.stderr}")


def listed():
    """Projects of a list are those of the line, behind these, whatever made it."""
    (WORK / "list.txt").write_text("\r\n".join(PROJECTS[2:]))
    for name, words, given in [("list", [*PROJECTS[:2], "--files-from", "list.txt"], ""),
                               ("standard-input", ["--files-from", "-"], "".join(f"{project}\0" for project in PROJECTS))]:
        run = subprocess.run([PROGRAM, "check", *words, "--pictures", "off", "--store", "store-1", "--stored-only", "--format", "json"], cwd=WORK,
                             input=given, capture_output=True, text=True, check=False)
        expect(run.returncode == CODE and run.stdout == ONE["json"].decode(), f"{name}: {run.returncode}, another result: {run.stderr}")
    for text, said in [("", "it names no project"), (f"{PROJECTS[0]}\n./{PROJECTS[0]}\n", "is given twice")]:
        run = subprocess.run([PROGRAM, "validate", "--files-from", "-"], cwd=WORK, input=text, capture_output=True, text=True, check=False)
        expect(run.returncode == 2 and said in run.stderr, f"{said}: {run.returncode}, {run.stderr}")


def unwritable():
    """The light of a shard that cannot be kept is no success."""
    run = luxgate("check", PROJECTS[0], "--store", "/dev/full/store", "--shard", "1/1")
    expect("error[output-not-possible]" in run.stderr and " of 1 jobs" not in run.stderr, f"a store that cannot be: {run.stderr}")
    expect(run.returncode == 2, f"a store that cannot be: {run.returncode}, {run.stderr}")


def resumed():
    """A run that is ended goes on, with the same bytes, and leaves nothing but its reports."""
    words = ["check", *PROJECTS, "--pictures", "off", "--output", "resumed", "--resume"]
    whole = luxgate(*[word if word != "resumed" else "not-resumed" for word in words[:-1]])
    ended = 0
    for wait in (0.02, 0.03, 0.05, 0.08, 0.12):
        process = subprocess.Popen([PROGRAM, *words], cwd=WORK, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(wait)
        process.send_signal(signal.SIGKILL)
        ended += process.wait() < 0
        expect(ended == 0 or not (WORK / "resumed" / "results.json").exists(), "resume: a report of a run that was killed")
    expect(ended > 0, "resume: no run was killed in time")
    # One that has all the light but what an interrupt kept it from.
    luxgate("check", *PROJECTS, "--store", "resumed/.luxgate-resume", "--shard", "1/2")
    run = luxgate(*words, "--explain-cost")
    taken = next((line for line in run.stderr.splitlines() if line.startswith("store: ")), "")
    expect(run.returncode == whole.returncode and taken and not taken.startswith("store: 0 "), f"resume: {run.returncode}, {run.stderr}")
    names = [sorted(path.relative_to(WORK / out).as_posix() for path in (WORK / out).rglob("*")) for out in ("resumed", "not-resumed")]
    expect(names[0] == names[1] and names[0], f"resume: {names[0]} instead of {names[1]}")
    for name in names[0]:
        expect((WORK / "resumed" / name).read_bytes() == (WORK / "not-resumed" / name).read_bytes(), f"resume: another {name}")
    (WORK / "resumed" / ".luxgate-resume").mkdir()
    (WORK / "resumed" / ".luxgate-resume" / "mine.txt").write_text("not luxgate's")
    run = luxgate(*words)
    expect(run.returncode == 2 and "is not a store" in run.stderr, f"resume in somebody's folder: {run.returncode}, {run.stderr}")
    expect((WORK / "resumed" / ".luxgate-resume" / "mine.txt").exists(), "resume: somebody's file is gone")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
PROJECTS = projects()
PLAN = luxgate("plan", *PROJECTS, "--units", "--format", "json", "--quiet")
(WORK / "units.json").write_text(PLAN.stdout)
UNITS = json.loads(PLAN.stdout)["units"]
expect(len(UNITS) == 13, f"{len(UNITS)} units, expected 13")
FIRST, ONE = report("one")
CODE = FIRST.returncode
expect(CODE == 2, f"one machine: exit code {CODE}, expected 2 for the broken project: {FIRST.stderr}")
any_split()
what_is_missing()
killed()
bad_words()
listed()
unwritable()
resumed()
print("\n".join(problems))
sys.exit(1 if problems else 0)
