"""Revisions of designs, from outside: what is said of each, and the exit code.

    revision_gate.py LUXGATE FOLDER    FOLDER is made anew
"""
import json
import pathlib
import shutil
import subprocess
import sys

import small_designs
from small_designs import WAIVER

PROGRAM = sys.argv[1]
WORK = pathlib.Path(sys.argv[2])


def write(folder, **changes):
    return small_designs.write(WORK / folder / "project.xml", **changes)


def luxgate(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def check(project, *arguments):
    return luxgate("check", project, "--pictures", "off", "--baseline", BASELINE, *arguments)


problems = []


def expect(name, done, code, *words, without=()):
    text = done.stdout + done.stderr
    if done.returncode != code:
        problems.append(f"{name}: exit code {done.returncode}, expected {code}")
    problems.extend(f"{name}: '{word}' is missing" for word in words if word not in text)
    problems.extend(f"{name}: '{word}' is there" for word in without if word in text)
    if problems and problems[-1].startswith(name):
        print(f"--- {name}\n{text}")


shutil.rmtree(WORK, ignore_errors=True)
BASELINE = WORK / "main.json"
base = write("base")
first = luxgate("check", base, "--pictures", "off", "-q", "--format", f"json={BASELINE}")
assert first.returncode == 1, first.stderr  # the far plane is too dark

GATE = ("--gate", "regression")
OPEN = "nothing became worse"
# Name of the case: what changes, exit code with the gate, what is said.
CASES = {
    "unchanged": ({}, 0, [OPEN, "2 unchanged", "failures present before, not counted: 1"]),
    "another folder": ({}, 0, [OPEN]),
    "renamed": (dict(name="Other", room="Other"), 0, [OPEN]),
    "better": (dict(columns=4), 0, ["▲ better", OPEN]),
    "a limit lowered": (dict(limit="80"), 1, ["▼ requires less", "≥ 100 lx", "≥ 80 lx", "--accept-weaker"]),
    "a limit raised": (dict(limit="110"), 0, ["▲ requires more", OPEN]),
    "a limit raised too far": (dict(limit="5000"), 1, ["✗ broken"]),
    "a plane deleted": (dict(far=False), 1, ["▼ requires less", "plane", "– no longer required"]),
    "a plane by another id": (dict(plane="table"), 1, ["▼ requires less", "▲ requires more", 'add was="desk" to it']),
    "a plane that says what it was": (dict(plane="table", was_plane=' was="desk"'), 0, ["id of the plane", "table", OPEN]),
    "a room that says what it was": (dict(room_id="hall", was_room=' was="room"'), 0, ["id of the room", "hall", OPEN]),
    "renamed and easier": (dict(plane="table", was_plane=' was="desk"', limit="90"), 1, ["▼ requires less", "≥ 90 lx"]),
    "lumens stated by hand": (dict(flux=' flux-lm="3600"'), 1, ["luminous flux, entered by hand"]),
    "a maintenance factor raised": (dict(mf="0.9"), 1, ["maintenance factor", "0.8", "0.9"]),
    "fewer points": (dict(points=3), 1, ["6 x 4 points", "3 x 4 points"]),
    "a smaller area": (dict(width="2"), 1, ["▼ requires less", "area", "6 m2", "4 m2"]),
    "a wider margin": (dict(margin="0.3"), 1, ["▼ requires less", "margin"]),
    "a waiver": (dict(far_waiver=WAIVER), 1, ["▼ requires less", "waiver", "A. Meier until 2099-12-31"]),
    "one luminaire less": (dict(columns=2), 1, ["▼ worse", "4: 2 removed, 4 moved"]),
    "a little darker": (dict(candela="995 955.2 855.7 696.5 477.6 238.8 0"), 0, ["▼ worse", OPEN, "photometry"]),
    "darker under the same name": (dict(candela="900 864 774 630 432 216 0"), 1, ["▼ worse", "photometry", "spot.ies"]),
}
for name, (changes, code, words) in CASES.items():
    project = write(name.replace(" ", "-"), **changes)
    expect(name, check(project, *GATE), code, *words)

lowered = write("a-limit-lowered", limit="80")
expect("accepted", check(lowered, *GATE, "--accept-weaker", "the client agreed"), 0, "the client agreed", OPEN)
expect("all", check(lowered), 1, "▼ requires less", "FAIL", without=["Regression gate"])
darker = write("darker-under-the-same-name", candela="900 864 774 630 432 216 0")
expect("allowed", check(darker, *GATE, "--allow-worse", "15%"), 0, OPEN)
expect("allowed of this", check(darker, *GATE, "--allow-worse", "average=15%", "--allow-worse", "minimum=15%"), 0, OPEN)
expect("allowed of others", check(darker, *GATE, "--allow-worse", "Uo=15%"), 1, "stopped, 2 failing")
expect("not a share", check(darker, *GATE, "--allow-worse", "100%"), 2, "a share from 0 to below 1")
expect("not a quantity", check(darker, *GATE, "--allow-worse", "avrage=1%"), 2, "average")

unreadable = write("unreadable", limit="none")
expect("unreadable", check(unreadable, *GATE), 2, "Regression gate: not judged")

# Every format tells of it.
for kind, words in {
    "json": ['"weaker"', '"limit"', '"allowed_worse"'],
    "markdown": ["### luxgate: ✗ fail", "requires less", "≥ 80 lx", "fail, as before"],
    "github": ["::error", "weaker-question", "≥ 80 lx"],
    "gitlab": ["luxgate/weaker-question", "critical"],
    "junit": ['name="revision"', 'failures="1"', "failed before the revision"],
    "csv": ["weaker question", "≥ 80 lx"],
    "html": ['<section id="revision">', "requires less", "≥ 80 lx"],
    "sarif": ["weaker-question", '"baselineState": "unchanged"', '"baselineState": "new"'],
}.items():
    expect(kind, check(lowered, *GATE, "-q", "--format", kind), 1, *words)

# A result with a revision is shown again as it was.
result = WORK / "revised.json"
check(lowered, *GATE, "-q", "--format", f"json={result}")
again = luxgate("report", result, "--format", "json")
if again.stdout != result.read_text():
    problems.append("report: another result")

# What a project says of itself must be possible.
wrong = write("was-what-is-there", plane="far2", was_plane=' was="far"')
expect("was what is there", check(wrong, *GATE), 2, "former-id-in-use", "the plane 'far' still exists, in line")

# Two results side by side: what is asked and judged comes first, in another folder, too.
other = WORK / "lowered.json"
luxgate("check", lowered, "--pictures", "off", "-q", "--format", f"json={other}")
beside = luxgate("report", other, "--baseline", BASELINE, *GATE)
expect("report", beside, 1, "▼ requires less", "Regression gate: stopped")
if beside.stdout != check(lowered, *GATE).stdout:
    problems.append("report --baseline: another text than check --baseline")
expect("report without gate", luxgate("report", other, "--baseline", BASELINE), 0, "▼ requires less")
expect("report without baseline", luxgate("report", other, *GATE), 2, "--gate regression needs a --baseline")
expect("compare", luxgate("compare", other, BASELINE), 1, "▼ requires less", "REQUIREMENTS OR VERDICTS DIFFER: 0 of")
expect("compare itself", luxgate("compare", other, other), 0, "Alike: 0 of", without=["requires less"])
expect("compare values only", luxgate("compare", other, BASELINE, "--partial"), 0, "Alike: 0 of", without=["requires less"])
expect("compare markdown", luxgate("compare", other, BASELINE, "--format", "markdown"), 1,
       "### luxgate compare: REQUIREMENTS OR VERDICTS DIFFER", "| ▼ requires less |", "| desk |")
expect("compare json", luxgate("compare", other, BASELINE, "--format", "json"), 1, '"alike": false', '"weaker"')
expect("compare html", luxgate("compare", other, BASELINE, "--format", "html"), 1, '<section id="revision">')
gone = WORK / "gone.json"
luxgate("check", write("a-plane-deleted", far=False), "--pictures", "off", "-q", "--format", f"json={gone}")
expect("compare what is gone", luxgate("compare", gone, BASELINE), 1, "– no longer required", "some values are on one side only")

# Twelve designs, one of them changed: a few lines, whatever the others are.
designs = [write(f"design-{k}", name=f"Design {k}", columns=3 + k % 2) for k in range(12)]
luxgate("check", *designs, "--pictures", "off", "-q", "--format", f"json={BASELINE}")
write("design-7", name="Design 7", columns=3, limit="90")
done = check(designs[0], *designs[1:], *GATE)
expect("twelve", done, 1, "design-7/project.xml: Office / desk", "▼ worse", "▼ requires less")
if len(done.stdout.splitlines()) > 30:
    problems.append(f"twelve: {len(done.stdout.splitlines())} lines")
moved = [write(f"moved/design-{k}", name=f"Design {k}", columns=3 + k % 2) for k in range(12)]
expect("twelve moved", check(moved[0], *moved[1:], *GATE), 0, OPEN, without=["asks", "worse:"])
expect("one of twelve", check(moved[0], *GATE), 1, "▼ requires less", "project")

# What a workplace says of its task and its walls requires less of them, where the row asks for more than that.
CELL = """<luxgate version="1" name="Cell" maintenance-factor="0.8"><material id="light" reflectance="0.7"/>
<luminaire-type id="spot" photometry="spot.ies"/><room id="cell" size="5 4 2.8" ceiling="light" walls="light" floor="light">
<luminaire-grid id="L" type="spot" origin="0 0 2.79" size="5 4" columns="3" rows="2"/>
<workplace id="w" pack="en12464-1:2021" row="{row}" glare="observers"{says}>
<without role="observer" because="of no account here" by="A. Meier" until="2099-12-31"/></workplace></room></luxgate>"""
small_designs.write(WORK / "cell/project.xml")  # its photometry


def cell(row, says=""):
    file = WORK / "cell/project.xml"
    file.write_text(CELL.format(row=row, says=says))
    return file


def told(row, before, after):
    luxgate("check", cell(row, before), "--pictures", "off", "-q", "--format", f"json={BASELINE}")
    return check(cell(row, after), *GATE)


UNKNOWN, FRONT = ' task-place="unknown"', ' front-wall="2"'
expect("an unknown place", told("34.2", "", UNKNOWN), 1, "▼ requires less", "Uo", "0.60", "0.40")
expect("a known place", told("34.2", UNKNOWN, ""), 0, "▲ requires more", OPEN)
expect("an unknown place of a row that asks no more", told("34.7", "", UNKNOWN), 0, OPEN, without=["requires less"])
expect("a wall in front", told("34.2", "", FRONT), 1, "▼ requires less", "≥ 150 lx", "≥ 75 lx")
expect("another wall in front", told("34.2", ' front-wall="1"', FRONT), 1, "▼ requires less", "▲ requires more")
expect("walls alike", told("34.2", FRONT, ""), 0, "▲ requires more", OPEN)

# Bad input.
expect("no baseline", luxgate("check", base, *GATE), 2, "--baseline")
expect("reason without gate", check(base, "--accept-weaker", "why"), 2, "--gate regression")
(WORK / "cut.json").write_text(result.read_text()[:2000])
for name in ("missing.json", "cut.json", "base/spot.ies"):
    expect(name, luxgate("check", base, "--baseline", WORK / name, "--pictures", "off"), 2, name)
expect("overwritten", luxgate("check", base, "--baseline", result, "--format", f"json={result}"), 2, "revised.json")
changed = json.loads(result.read_text())
changed["projects"][0]["spaces"][0]["planes"][0]["findings"][0]["verdict"] = "fail"
(WORK / "changed.json").write_text(json.dumps(changed))
expect("changed by hand", luxgate("check", base, "--baseline", WORK / "changed.json"), 2, "changed.json")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
