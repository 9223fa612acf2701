"""Revisions that would turn a gate for regressions green without better light: each is named, and stops it.

    revision_attacks.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import pathlib
import shutil
import subprocess
import sys

PROGRAM, WORK, EXAMPLES = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
GATE = ("--gate", "regression")
HEAD = """<luxgate version="1" name="Design" maintenance-factor="0.8">
<material id="light" reflectance="0.7"/><material id="dark" reflectance="0.3"/>
<luminaire-type id="panel" photometry="photometry/lambert_panel_600.ies" power-w="30"/>
"""
GRID = '<luminaire-grid id="L" type="panel" origin="0 0 2.79" size="5 4" columns="3" rows="2" group="g"/>'
DESK = '<plane id="desk" origin="1 1 0.8" u="3 0 0" v="0 2 0" count="6 4">'
MEAN = '<require id="mean" quantity="average" at-least="100"/>'
ROOM = f"""<scene id="half"><dim group="g" level="0.5"/></scene>
<room id="room" name="Office" size="5 4 2.8" ceiling="light" walls="light" floor="dark">
{GRID}
{DESK}
{MEAN}
<require id="min" quantity="minimum" at-least="50"/>
</plane>
</room></luxgate>"""
USUAL = HEAD + ROOM
PACK = """<rule-pack id="own" edition="1" title="Own" version="1" kind="contract" status="published" licence="internal" role="task">
<grid id="formula" method="formula-power" factor="0.2" base="5" max-spacing="10" ratio="2" count="nearest" trust="confirmed"/>
<mask id="core"><inset metres="0.2"/></mask>
<plane role="task" orientation="horizontal-up" heights="0 2" grid="formula" mask="core"/>
<check id="t.min" role="task" quantity="planar" statistic="minimum" mask="core" at-least="30 lx" trust="confirmed"/>
</rule-pack>"""
problems = []


def change(text, *pairs):
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    return text


def put(folder, text, files):
    folder = WORK / folder
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(EXAMPLES / "photometry", folder / "photometry")
    for name, content in {**files, "project.xml": text}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(content)
    return str(folder / "project.xml")


def check(project, *options):
    rules = pathlib.Path(project).parent / "own.xml"
    if rules.exists():
        options = (*options, "--rules", rules)
    return subprocess.run([PROGRAM, "check", project, "--pictures", "off", *map(str, options)], capture_output=True, text=True)


def expect(name, done, code, words):
    text = done.stdout + done.stderr
    wrong = [f"{name}: '{word}' is missing" for word in words if word not in text]
    if done.returncode != code:
        wrong.append(f"{name}: exit code {done.returncode}, expected {code}")
    if wrong:
        print(f"--- {name}\n{text}")
    problems.extend(wrong)


def case(name, before, after, code, *words, files=None, files_after=None, options=(), options_before=()):
    """Of `before`, then of `after` against it."""
    files = files or {}
    baseline = WORK / "baseline.json"
    done = check(put("before", before, files), *options_before, "-q", "--format", f"json={baseline}")
    assert done.returncode in (0, 1), f"{name}: {done.stderr}"
    done = check(put("after", after, {**files, **(files_after or {})}), "--baseline", baseline, *GATE, *options)
    expect(name, done, code, words)
    return done


shutil.rmtree(WORK, ignore_errors=True)
OPEN = "nothing became worse by more than allowed"
PANEL = (EXAMPLES / "photometry/lambert_panel_600.ies").read_text()
TOUCHED = {"photometry/lambert_panel_600.ies": PANEL.replace("\n", "  \n", 2)}  # another hash, the same light

# What counts, and where it is measured.
route = HEAD + """<room id="c" size="10 3 2.8" floor="dark" ceiling="light" walls="light"><luminaire-line id="L" type="panel" from="0 1.5 2.79" to="10 1.5 2.79" count="3"/>
<route id="out" points="0.5 1.5 0 9.5 1.5 0" width="1.2"><require id="a" quantity="minimum" at-least="20"/></route></room></luxgate>"""
case("a route's points raised", route, change(route, ('width="1.2"', 'width="1.2" height="0.3"')), 1, "requires other things", "up to 0.3 m elsewhere")
ruled = HEAD + """<room id="room" name="Office" size="8 6 2.8" ceiling="light" walls="light" floor="dark">
<luminaire-grid id="L" type="panel" origin="0 0 2.79" size="8 6" columns="1" rows="1"/>
<plane id="desk" origin="1 1 0.8" u="6 0 0" v="0 4 0" count="24 16"><require pack="own"/></plane></room></luxgate>"""
case("a mask of one name that leaves more out", ruled, ruled, 1, "requires other things", "0.2 m along the outline", "0.7 m along the outline",
     files={"own.xml": PACK}, files_after={"own.xml": PACK.replace('metres="0.2"', 'metres="0.7"')})
case("a mask of another name that leaves out the same", ruled, ruled, 0, OPEN,
     files={"own.xml": PACK}, files_after={"own.xml": PACK.replace('"core"', '"inner"')})
facing = change(USUAL, ('count="6 4"', 'count="3 2" quantity="semicylindrical" direction="1 0 0"'), ('at-least="50"', 'at-least="5"'))
boxed = change(facing, ("</room>", '<box id="b" size="0.2 0.2 1.5" position="1.4 1.4 0" material="dark"/></room>'))
case("turned where a point more is there", boxed, change(facing, ('direction="1 0 0"', 'direction="-1 0 0"')), 1, "facing (1 0 0)", "facing (-1 0 0)")
case("a point more", boxed, facing, 0, "requires more", "omitted points")
box = change(USUAL, ("</room>", '<box id="b" size="0.6 0.6 1.5" position="2.2 1.8 0" material="dark"/></room>'), ('count="6 4"', 'count="30 20"'),
             ('at-least="50"', 'at-least="1"'))
case("as many points left out, and others", box, change(box, ("2.2 1.8 0", "1.0 1.0 0")), 1, "omitted points", "36, 36 of them others")
points = {"p.csv": "x,y,z,nx,ny,nz\n1.246,1,1,0,0,1\n1.254,1,1,0,0,1\n"}
listed = change(USUAL, ('origin="1 1 0.8" u="3 0 0" v="0 2 0" count="6 4"', 'file="p.csv"'),
                (MEAN, MEAN + '<require id="v" quantity="value" at="1.246 1 1" at-least="10"/>'))
case("a point 8 mm off", listed, change(listed, ('at="1.246', 'at="1.254')), 1, "exactly (1.246, 1, 1)", files=points)
case("a point less in a list", listed, listed, 1, "requires less", "2 points", "1 points", files=points,
     files_after={"p.csv": "x,y,z,nx,ny,nz\n1.246,1,1,0,0,1\n"})
case("a list in another order", listed, listed, 0, OPEN, files=points, files_after={"p.csv": "x,y,z,nx,ny,nz\n1.254,1,1,0,0,1\n1.246,1,1,0,0,1\n"})
case("a rectangle that begins at another corner", USUAL,
     change(USUAL, ('origin="1 1 0.8" u="3 0 0" v="0 2 0" count="6 4"', 'points="4 1 0.8 4 3 0.8 1 3 0.8 1 1 0.8" count="4 6"')), 0, OPEN, "not the files of the baseline")

# What is asked.
failing = change(USUAL, ('at-least="100"/>', 'at-least="5000" waived-because="x" waived-by="A" waived-until="2026-03-01"/>'))
case("a waiver that has ended", failing, failing, 1, "✗ broken", "fail, waived", options_before=("--timestamp", "1767225600"), options=("--timestamp", "1780000000"))
lasting = change(failing, ("2026-03", "2099-03"))
case("a waiver taken back", lasting, change(USUAL, ('"100"', '"5000"')), 1, "✗ broken", "requires more")
case("a waiver that lasts", lasting, lasting, 0, OPEN)
energy = change(USUAL, (MEAN, '<require id="leni" quantity="LENI" at-most="30"/>' + MEAN),
                (GRID, '<energy day-hours="2250" night-hours="250" parasitic-kwh-m2="0"/>' + GRID))
case("hours of energy", energy, change(energy, ("2250", "100")), 1, "hours and energy factors", "2250 h by day")
case("occupancy", energy, change(energy, ("night-hours", 'occupancy="0.1" night-hours')), 1, "hours and energy factors")
unnamed = change(USUAL, (MEAN, '<require quantity="average" at-least="100"/><require quantity="average" at-least="300" state="initial"/>'))
swapped = change(USUAL, (MEAN, '<require quantity="average" at-least="300" state="initial"/><require quantity="average" at-least="100"/>'))
case("two requirements without ids change places", unnamed, swapped, 0, OPEN)
case("of two requirements without ids one is easier", unnamed, change(swapped, ('"300"', '"200"')), 1, "≥ 300 lx", "≥ 200 lx")

# How it is calculated.
most = change(USUAL, ('at-least="100"', 'at-most="2000"'))
case("a method that loses light", most, most, 1, "method", "--method instant-radiosity --clamp 0.001",
     options=("--method", "instant-radiosity", "--clamp", "0.001"))
darker = change(USUAL, ("power-w", 'flux-lm="3240" power-w'))
case("fewer replicates and paths", USUAL, darker, 1, "16 replicates", "4 replicates", "at most 4 paths", "does not exclude a loss",
     options=("--replicates", "4", "--max-paths", "4"))
case("a level of confidence that hides a loss", USUAL, darker, 1, "▼ worse", options=("--confidence", "99.999%"))

# What is stated of luminaires, around the question by another id or another hash.
second = change(USUAL, ("<scene", '<luminaire-type id="s2" photometry="photometry/lambert_panel_600.ies" power-w="30" maintenance-factor="1"/><scene'),
                ('id="L" type="panel"', 'id="L" type="s2"'))
case("a maintenance factor by a second type", USUAL, change(second, ("<plane", '<luminaire id="keep" type="panel" position="0.4 0.4 0.35"/><plane')), 1,
     "maintenance factor", "panel: 0.8", "s2: 1")
case("a maintenance factor by a new type of a touched file", USUAL, change(USUAL, ('"panel"', '"panel2"'), ('maintenance-factor="0.8"', 'maintenance-factor="1"')), 1,
     "maintenance factor", "panel2: 1", files_after=TOUCHED)
case("lumens of a touched file", USUAL, change(USUAL, ("power-w", 'flux-lm="7200" power-w')), 1, "luminous flux, entered by hand", "the file says 3600 lm",
     files_after=TOUCHED)
watts = change(USUAL, (MEAN, '<require id="pd" quantity="power-density" at-most="20"/>' + MEAN))
case("watts of a touched file", watts, change(watts, ('power-w="30"', 'power-w="15"')), 1, "power, entered by hand", files_after=TOUCHED)
case("a touched file alone", USUAL, USUAL, 0, OPEN, "photometry", files_after=TOUCHED)
case("another interpolation", USUAL, change(USUAL, ("power-w", 'interpolation="cubic" power-w')), 0, OPEN, "photometry")
case("another opening", USUAL, change(USUAL, ("power-w", 'opening="point" power-w')), 0, "6 with another opening")

# What changed in the input.
case("another floor", USUAL, change(USUAL, ('floor="dark"', 'floor="light"')), 0, "Office / floor", "material", "light")
case("another box", box, change(box, ('0" material="dark"', '0" material="light"')), 0, "Office / b", "material")
aimed = change(USUAL, (GRID, '<luminaire id="A" type="panel" position="1.5 2 2.7" axis="0 0 -1" group="g"/>'), ('at-least="50"', 'at-least="1"'), ('"100"', '"1"'))
case("another aim", aimed, change(aimed, ('axis="0 0 -1"', 'axis="0.3 0 -1"')), 0, "1: 1 turned")
lit = change(USUAL, (MEAN, '<require id="mean" scene="half" quantity="average" at-least="100"/>'))
case("another level", lit, change(lit, ('level="0.5"', 'level="1"')), 0, "scene", "g 0.5")

# Names.
school = (EXAMPLES / "11-classroom/project.xml").read_text()
brief = {"own.xml": (EXAMPLES / "11-classroom/rules/brief.xml").read_text()}
renamed = change(school, ('workplace id="desks"', 'workplace id="desks2" was="desks"'))
case("a workplace that says what it was", school, renamed, 0, OPEN, "desks2.task", files=brief)
silent = case("a workplace that does not", school, change(renamed, (' was="desks"', "")), 1, "add was= with the old id to its workplace", files=brief)
if silent.stdout.count("add was= with the old id to its workplace") != 1:
    problems.append("a workplace that does not: told more than once")
roads = '<room id="{}"{} size="40 6 6" floor="dark" ceiling="dark" walls="dark"><luminaire-line id="L" type="panel" from="0 3 5.9" to="40 3 5.9" count="2"/><plane id="{}" origin="0 1 0.02" u="40 0 0" v="0 4 0"><require pack="en13201-2" row="P6" role="footway"/></plane></room>'
case("a room's old id that is a plane's", HEAD + roads.format("a", "", "p") + roads.format("b", "", "a") + "</luxgate>",
     HEAD + roads.format("c", ' was="a"', "p") + roads.format("b", "", "a") + "</luxgate>", 0, OPEN)

# What is said of it.
done = case("a failure that became worse", change(USUAL, ('"100"', '"5000"')), change(darker, ('"100"', '"5000"')), 1, "▼ worse",
            options=("--format", f"github={WORK / 'github.txt'}"))
errors = [line for line in (WORK / "github.txt").read_text().splitlines() if line.startswith("::error")]
if len(errors) != 2 or any("became worse" not in line for line in errors):
    problems.append(f"a failure that became worse: {errors}")
done = case("a blank reason", USUAL, change(USUAL, ('"100"', '"80"')), 2, "a reason is needed", options=("--accept-weaker", " "))
done = case("unreadable", USUAL, change(USUAL, ("</plane>", "")), 2, "could not be judged")
if "nothing became better" in done.stdout:
    problems.append("unreadable: nothing is known of it")
german = case("German", USUAL, change(USUAL, ("power-w", 'flux-lm="3000" power-w')), 1, "Mittelwert", options=("--language", "de"))

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
