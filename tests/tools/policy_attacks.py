"""A stranger's pull request, judged by the owner's policy: ways to a green tick without better light, each is named and ends with 2.

    policy_attacks.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import hashlib
import datetime
import json
import pathlib
import shutil
import subprocess
import sys

PROGRAM, WORK, EXAMPLES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
PACK = """<rule-pack id="own" edition="1" title="Own" version="1" kind="contract" status="published" licence="internal" role="task">
<parameter id="Em" unit="lx" meaning="maintained average"/><parameter id="Uo" unit="none" meaning="uniformity"/>
<scale id="steps" unit="lx" values="100 200 300 400 500 750" of="Em" down="2" up="2" trust="confirmed"/>
<grid id="formula" method="formula-power" factor="0.2" base="5" max-spacing="10" ratio="2" count="nearest" trust="confirmed"/>
<plane role="task" orientation="horizontal-up" heights="0 2" grid="formula"/>
<row ref="office" name="office" trust="confirmed"><value of="Em" required="500"/><value of="Uo" required="0.3"/></row>
<check id="Em" role="task" quantity="planar" statistic="average" at-least="row(Em)" trust="confirmed"/>
<check id="Uo" role="task" quantity="planar" statistic="Uo" at-least="row(Uo)" trust="confirmed"/>
</rule-pack>"""
ROW = '<require pack="own" row="office"/>'
PROJECT = f"""<luxgate version="1" name="Design" maintenance-factor="0.8">
<material id="light" reflectance="0.7"/><material id="dark" reflectance="0.3"/>
<luminaire-type id="panel" photometry="photometry/lambert_panel_600.ies" power-w="30"/>
<room id="office-1" name="Office" size="5 4 2.8" ceiling="light" walls="light" floor="dark">
<luminaire-grid id="L" type="panel" origin="0 0 2.79" size="5 4" columns="3" rows="2"/>
<plane id="desk" height="0.8">{ROW}<require id="own" quantity="minimum" at-least="300"/></plane>
</room></luxgate>"""
POLICY = """<luxgate-policy version="1" name="Owner's rules 2026">
<waivers by="A. Meier; Q. Board" most-days="200"/>
<asked pack="own:1" row="office" spaces="office-*" projects="design/*"/>
<bound of="maintenance-factor" at-least="0.4" at-most="0.85"/>
<bound of="reflectance" at-most="0.85"/>
<bound of="flux-ratio" at-most="1"/>
<bound of="power-ratio" at-least="0.99"/>
<accuracy confidence="0.95" tolerance="0.02" replicates="16"/>
<project path="design/project.xml"/>
<fatal-warnings ids="luminaire-outside-room values-set"/>
<format kind="json"/>
</luxgate-policy>"""
# A day long over, for reports alone: waivers are held against the clock.
DAY = {"SOURCE_DATE_EPOCH": "1767225600"}  # 2026-01-01
SOON = (datetime.date.today() + datetime.timedelta(days=120)).isoformat()
ENDED = (datetime.date.today() - datetime.timedelta(days=2)).isoformat()
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def change(text, *pairs):
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new)
    return text


def put(text):
    shutil.rmtree(WORK / "design", ignore_errors=True)
    shutil.copytree(EXAMPLES / "photometry", WORK / "design" / "photometry")
    (WORK / "design" / "project.xml").write_text(text)


def luxgate(*words):
    return subprocess.run([PROGRAM, *words], cwd=WORK, env=DAY, capture_output=True, text=True, check=False)


def check(*words, kind="json", projects=("design/project.xml",)):
    return luxgate("check", *projects, "--rules", "own.xml", "--policy", "policy.xml", "--pictures", "off", "--format", kind, *words)


WORK.mkdir(parents=True, exist_ok=True)
(WORK / "own.xml").write_text(PACK)
(WORK / "policy.xml").write_text(POLICY)

put(PROJECT)
run = check()
expect(run.returncode == 0, f"the honest design: {run.returncode}, {run.stderr}")
provenance = json.loads(run.stdout)["provenance"]
expect(provenance["policy"] == "Owner's rules 2026" and len(provenance["policy_sha256"]) == 64, f"provenance: {provenance}")
sha = provenance["policy_sha256"]
both = ("--format", f"json={WORK}/x.json")
for kind in ("text", "html", "markdown", "sarif", "junit", "github", "gitlab"):
    run = check(*both, kind=kind)
    shown = "Owner" in run.stdout and sha in run.stdout
    expect(shown or kind == "gitlab", f"{kind} does not say which policy: {run.stdout[-300:]}")

too_dark = change(PROJECT, ('columns="3" rows="2"', 'columns="1" rows="1"'))
put(too_dark)
expect(check().returncode == 1, "the dark design does not fail")
WAIVER = '<require pack="own" row="office"><waiver checks="Em Uo" because="soon" by="{}" until="{}"/></require>'
WAIVED = f' waived-because="soon" waived-by="{{}}" waived-until="{SOON}"/>'
dark_min = ('at-least="300"/>', 'at-least="300"' + WAIVED.format("A. Meier"))
ways = [
    ("a waiver by a stranger", change(too_dark, (ROW, WAIVER.format("Me", SOON)), dark_min), "is by 'Me'; allowed: A. Meier, Q. Board"),
    ("a waiver for ever", change(too_dark, (ROW, WAIVER.format("A. Meier", "2099-01-01")), dark_min), "allowed: 200 days"),
    ("an own requirement waived by a stranger", change(PROJECT, ('at-least="300"/>', 'at-least="5000"' + WAIVED.format("Me"))), "is by 'Me'"),
    ("nothing is asked", change(too_dark, (ROW, ""), ('<require id="own" quantity="minimum" at-least="300"/>', "")), "space 'office-1' has no requirement that counts"),
    ("another requirement instead of the row", change(too_dark, (ROW, ""), ('at-least="300"', 'at-least="5"')), "own:1 office of space 'office-1' is not required"),
    ("the row as advice of a lower level", change(too_dark, ('row="office"', 'row="office" level="-2" level-because="I say so"'),
                                                  ('at-least="300"', 'at-least="5"')), "is below what its row requires"),
    ("another name of the room", change(too_dark, ("office-1", "store-1"), (ROW, ""), ('at-least="300"', 'at-least="5"')), "0 spaces match 'office-*'"),
    ("new for ever", change(PROJECT, ('factor="0.8"', 'factor="1"')), "maintenance-factor of luminaire type 'panel' is 1; at most 0.85"),
    ("no factor at all", change(PROJECT, (' maintenance-factor="0.8"', "")), "maintenance-factor of luminaire type 'panel' is 1"),
    ("walls of snow", change(PROJECT, ('reflectance="0.7"', 'reflectance="0.95"')), "reflectance of material 'light' is 0.95"),
    ("a field of snow", change(PROJECT, (ROW, ROW + '<require quantity="GR" at-most="90" reflectance="0.95"/>')), "reflectance of the field of 'desk' is 0.95"),
    ("more lumens than the file has", change(too_dark, ('power-w="30"', 'power-w="30" flux-lm="99999"'), ('columns="1"', 'columns="2"')), "flux-ratio of luminaire type 'panel'"),
    ("less power than the file has", change(PROJECT, ('power-w="30"', 'power-w="18"')), "power-ratio of luminaire type 'panel' is 0.6"),
    ("a warning that the owner fears", change(PROJECT, ('size="5 4" columns', 'size="25 4" columns')), "luminaire-outside-room"),
]
for name, text, said in ways:
    put(text)
    run = check("--max-paths", "65536")
    expect(run.returncode == 2 and said in run.stderr, f"{name}: {run.returncode}, {run.stderr}")
    expect("policy-not-met" in run.stdout or "fears" in name, f"{name}: not in the result")
    for kind in ("text", "csv", "junit", "sarif", "html", "markdown"):
        shown = check(*both, kind=kind).stdout
        expect("olicy" in shown or "fears" in name, f"{name}: {kind} does not say it")
# A wall that fails does not go away within a margin of the project's own.
walls = change(PACK, ('grid="formula"/>\n<row', 'grid="formula" area="task" height="0.8"/><plane role="wall" orientation="surface" grid="formula" area="walls" '
                      'margin="0.5"/>\n<row'), ("</rule-pack>", '<check id="wall" role="wall" quantity="planar" statistic="average" at-least="150 lx" '
                                                'trust="confirmed"/></rule-pack>'))
room = change(PROJECT, ('size="5 4 2.8"', 'size="9 4 2.8"'), ('size="5 4" columns', 'size="4 4" columns'))
at, end = room.index("<plane"), room.index("</plane>") + len("</plane>")
for zone, code, said in [("", 1, ""), ('<zone role="wall.2" margin="9" because="x"/>', 2, "zone-vanishes"), ('<zone role="wall.2" margin="0.5"/>', 1, "")]:
    put(room[:at] + f'<workplace id="w" pack="own" row="office" origin="0.5 0.5" size="3 3">{zone}</workplace>' + room[end:])
    (WORK / "walls.xml").write_text(walls)
    run = luxgate("check", "design/project.xml", "--rules", "walls.xml", "--policy", "policy.xml", "--pictures", "off", "--format", "json")
    expect(run.returncode == code and said in run.stderr, f"a wall with {zone}: {run.returncode}, expected {code}: {run.stderr}")
permitted = change(too_dark, (ROW, WAIVER.format("A. Meier", SOON)), dark_min)
put(permitted)
run = check()
expect(run.returncode == 0, f"a waiver by who may: {run.returncode}, {run.stderr}")

put(PROJECT)
(WORK / "other").mkdir(exist_ok=True)
shutil.copytree(WORK / "design", WORK / "other", dirs_exist_ok=True)
for name, run, said in [
        ("the project is left out", check(projects=("other/project.xml",)), "'design/project.xml' is not among the projects"),
        ("a looser level", check("--confidence", "0.8"), "--confidence 0.8; at least 0.95"),
        ("wider intervals", check("--tolerance", "0.1"), "--tolerance 0.1; at most 0.02"),
        ("fewer repetitions", check("--replicates", "4"), "--replicates 4; at least 16"),
        ("no result for the record", check(kind="text"), "'--format json' is missing"),
        ("another value on the command line", check("--set", "own.at-least=1"), "values-set"),
        ("another project under its name", check(projects=("other/project.xml", "notdesign/project.xml")), "'design/project.xml' is not among the projects")]:
    expect(run.returncode == 2 and said in run.stderr, f"{name}: {run.returncode}, {run.stderr}")

# A row is asked of those projects that it is for, and of them alone.
small = change(PROJECT, ("office-1", "store-1"), (ROW, ""))
(WORK / "other" / "project.xml").write_text(small)
run = check(projects=("./design/project.xml", "other/project.xml"))
expect(run.returncode == 2 and "other/project.xml: warning[policy-not-met]: the policy is not met: space 'store-1' matches no <asked>" in run.stderr,
       f"a project that no row is about: {run.returncode}, {run.stderr}")
(WORK / "policy.xml").write_text(change(POLICY, ("rules 2026\"", "rules 2026\" every-space=\"anything\"")))
run = check(projects=("./design/project.xml", "other/project.xml"))
expect(run.returncode == 0, f"a row of another project: {run.returncode}, {run.stderr}")
put(change(PROJECT, (ROW, "")))
run = check(projects=("./design/project.xml", "other/project.xml"))
expect(run.returncode == 2 and "own:1 office of space 'office-1' is not required" in run.stderr, f"a row, by another path: {run.returncode}, {run.stderr}")
submit = luxgate("submit", "--engine", "local", "other/project.xml", "--rules", "own.xml", "--policy", "policy.xml", "--store", "s", "--format", "json=x.json")
expect(submit.returncode == 2 and "'design/project.xml' is not among" in submit.stderr and not (WORK / "s-job").exists(), f"submit: {submit.stderr}")
run = subprocess.run([PROGRAM, "check", "project.xml", "--rules", "../own.xml", "--policy", "../policy.xml", "--pictures", "off", "--format", "json"], cwd=WORK / "design", env=DAY,
                     capture_output=True, text=True, check=False)
expect("own:1 office of space 'office-1' is not required" in run.stderr, f"a row, from within the folder: {run.returncode}, {run.stderr}")
(WORK / "policy.xml").write_text(POLICY)
put(PROJECT)

# Where and how large the zones are, facts, levels that are lower, photometry, rooms that no row is about.
WORKPLACE = '<workplace id="w" pack="own" row="office"{}/>'
desk = PROJECT[PROJECT.index("<plane"):PROJECT.index("</room>")]
zone_pack = change(PACK, ('grid="formula"/>\n<row', 'grid="formula" area="task" height="0.8"/>\n<row'), ('<row ref="office"', '<fact id="need" unit="lx" meaning="what the task needs"/>'
                   '<row ref="office"'), ("</rule-pack>", '<check id="fact" role="task" quantity="planar" statistic="minimum" at-least="fact(need)" trust="confirmed"/></rule-pack>'))
zone_pack = zone_pack.replace('<value of="Em" required="500"/>', '<value of="Em" required="500" modified="750"/>')
zone_pack = change(zone_pack, ('at-least="row(Uo)" trust="confirmed"/>', 'at-least="row(Uo)" trust="confirmed"><special place="unknown-task" limit="0.2" trust="confirmed"/></check>'))
(WORK / "zones.xml").write_text(zone_pack)


def judged(project, policy, code, *said, name="", files=None):
    put(project)
    for file, text in (files or {}).items():
        (WORK / "design" / "photometry" / file).write_text(text)
    (WORK / "zone-policy.xml").write_text(policy)
    run = luxgate("check", "design/project.xml", "--rules", "zones.xml", "--policy", "zone-policy.xml", "--pictures", "off", "--format", "json", "--max-paths", "65536")
    for words in said:
        expect(words in run.stderr, f"{name}: '{words}' is not in {run.stderr}")
    expect(run.returncode == code, f"{name}: {run.returncode}, expected {code}: {run.stderr}")


wants = change(POLICY, ('spaces="office-*" projects="design/*"/>', 'spaces="office-*" zones="unchanged" floor-share="0.5"/><fact pack="own:1" id="need" at-least="200"/>'))
fact = ' facts="need=300 lx"'
whole = change(PROJECT, (desk, WORKPLACE.format(fact)))
judged(whole, wants, 0, name="a whole room")
judged(change(whole, (fact, ' facts="need=1 lx"')), wants, 2, "fact 'need' of requirement 'minimum' of plane 'w.task' is 1; at least 200 is allowed", name="a fact that is too low")
judged(whole, change(wants, ('<fact pack="own:1" id="need" at-least="200"/>', "")), 2, "is stated, but no <fact> allows it", name="a fact of which nothing is said")
judged(change(PROJECT, (desk, WORKPLACE.format(fact + ' origin="2.2 1.9" size="0.6 0.4"'))), wants, 2, "planes of role 'task' cover 0.0", "at least 0.5 is needed", name="a small task")
anywhere = change(whole, ('"office"', '"office" task-place="unknown"'))
judged(anywhere, wants, 2, "is below what its row requires, by what the project says of its place", name="a task that may be anywhere")
judged(anywhere, change(wants, ('<luxgate-policy version="1"', '<luxgate-policy version="1" lowered-levels="yes"')), 0, name="a task that may be anywhere, which the owner allows")
own_plane = change(desk, (ROW, ROW.replace("/>", fact + "/>")))
judged(change(PROJECT, (desk, own_plane)), wants, 2, "is required on plane 'desk', which no <workplace> has made", name="a plane of one's own")
judged(change(PROJECT, (desk, own_plane)), change(wants, ('zones="unchanged" ', "")), 0, name="a plane of one's own that may be")
hollow = own_plane.replace('height="0.8"', 'points="0 0 0.8  5 0 0.8  5 4 0.8  0 4 0.8"').replace("<require", '<hole points="0.05 0.05 0.8  4.95 0.05 0.8  4.95 3.95 0.8  0.05 3.95 0.8"/><require')
judged(change(PROJECT, (desk, hollow)), change(wants, ('zones="unchanged" ', "")), 2, "planes of role 'task' cover 0.", name="a plane of the whole floor with a hole")
moved = change(whole, (fact + "/>", fact + '><zone role="task" height="0.9" because="standing"/></workplace>'))
judged(moved, wants, 2, "which the project has changed", name="a zone that is changed")
judged(moved, change(wants, ('zones="unchanged"', 'zones="workplace"')), 0, name="a zone that may be changed")
twice = change(PROJECT, (desk, "".join(change(WORKPLACE.format(fact + f' origin="2 {1.8 + i / 10}" size="1 0.9"'), ('"w"', f'"w{i}"')) for i in range(6))))
judged(twice, wants, 2, "at least 0.5 is needed", name="the same small task six times")
speck = change(PROJECT, (desk, own_plane.replace('height="0.8"', 'points="2 2 0.8  2.2 2 0.8  2.2 2.2 0.8  2 2.2 0.8"')))
judged(speck, change(wants, ('zones="unchanged" floor-share="0.5"', "")), 0, "warning[task-is-speck]", "has only 0.04 m²", name="a speck")
judged(speck, change(wants, ('zones="unchanged" floor-share="0.5"', ""), ("luminaire-outside-room", "task-is-speck")), 2, "warning[task-is-speck]", name="a speck that the owner fears")
judged(speck, change(wants, ('zones="unchanged" floor-share="0.5"', ""), ("luminaire-outside-room values-set", "all")), 2, "warning[task-is-speck]", name="any warning counts")
# Beams that meet the calculation points and nothing else: 8 x 6 of them, of 500 lx each.
BEAM = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 4 1 1 2 0 0 0\n1 1 10\n0 2 2.1 90\n0\n4000 4000 0 0\n"
beams = change(whole, ("lambert_panel_600.ies", "beam.ies"), ('origin="0 0 2.79" size="5 4" columns="3" rows="2"', 'origin="0 0 2.79" size="5 4" columns="8" rows="6"'))
judged(beams, wants, 0, "warning[light-between-points]", name="beams at the points", files={"beam.ies": BEAM})
judged(beams, change(wants, ("luminaire-outside-room values-set", "all")), 2, "warning[light-between-points]", name="beams at the points that the owner fears", files={"beam.ies": BEAM})
# On other points of many only, on the darkest ones only, and between covers.
own = """<luxgate version="1" name="Design" maintenance-factor="0.8"><material id="dark" reflectance="0.3"/><luminaire-type id="panel" photometry="photometry/lambert_panel_600.ies" power-w="30"/>
<luminaire-type id="beam" photometry="photometry/beam.ies" power-w="1"/><room id="office-1" size="8 6 2.8" ceiling="dark" walls="dark" floor="dark">{}
<plane id="p" height="0.8" count="{}"><require quantity="{}" at-least="{}"/></plane></room></luxgate>"""
spot = '<luminaire id="b{0}.{1}" type="beam" position="{2} {3} 2.79"/>'


def beams_on(columns, rows, wanted):
    return "".join(spot.format(i, k, (i + 0.5) * 8 / columns, (k + 0.5) * 6 / rows) for k in range(rows) for i in range(columns) if wanted(i, k))


anything = change(POLICY, ('<asked pack="own:1" row="office" spaces="office-*" projects="design/*"/>\n', ""), ("luminaire-outside-room values-set", "all"))
one_panel = '<luminaire id="L" type="panel" position="1 1 2.79"/>'
covers = "".join(f'<box id="c{i}" size="0.92 6 0.002" position="{i - 0.46} 0 0.799" material="dark"/>' for i in range(1, 8)) + "".join(
    f'<box id="r{i}" size="8 0.92 0.002" position="0 {i - 0.46} 0.799" material="dark"/>' for i in range(1, 6))
for name, text in [("every second point of many", own.format(beams_on(24, 20, lambda i, k: (i + 24 * k) % 2 == 1), "24 20", "average", 300)),
                   ("the darkest points", own.format(one_panel + beams_on(8, 6, lambda i, k: i + k > 5), "8 6", "minimum", 6)),
                   ("the darkest points, for uniformity", own.format(one_panel + beams_on(8, 6, lambda i, k: i + k > 5), "8 6", "Uo", 0.15)),
                   ("points between covers", own.format(beams_on(8, 6, lambda i, k: True) + covers, "8 6", "average", 300))]:
    judged(text, anything, 2, "warning[light-between-points]", name=name, files={"beam.ies": BEAM.replace("4000", "100") if "darkest" in name else BEAM})
judged(change(whole, (fact, fact + ' level="modified"')), wants, 1, name="a higher level")
(WORK / "zones.xml").write_text(change(zone_pack, ('statistic="average" at-least="row(Em)"', 'statistic="average" at-most="row(Em)"'), ('required="500"', 'required="700"')).replace('of="Em" down="2" up="2"', 'of="Uo" down="1"').replace('values="100 200 300 400 500 750"', 'values="0.1 0.3 0.5"').replace('id="steps" unit="lx"', 'id="steps" unit="none"'))
judged(change(whole, (fact, fact + ' level="modified"')), wants, 2, "is below what its row requires, modified", name="a modified level that is easier")
(WORK / "zones.xml").write_text(zone_pack)
decoy = change(whole, ("</room></luxgate>", "</room>" + change(whole[whole.index("<room"):whole.index("</luxgate>")], ('id="office-1"', 'id="store-1"'), ('"w"', '"v"'),
                                                               ('id="L"', 'id="M"')) + "</luxgate>"))
judged(decoy, wants, 2, "space 'store-1' matches no <asked>", name="a room that no row is about")
judged(decoy, change(wants, ("rules 2026\"", "rules 2026\" every-space=\"anything\"")), 0, name="a room that may be asked anything")
ies = (WORK / "design" / "photometry" / "lambert_panel_600.ies").read_bytes()
hashed = hashlib.sha256(ies).hexdigest()
only = change(wants, ("<format", f'<photometry sha256="{hashed}" name="panel"/><format'))
judged(whole, only, 0, name="photometry of the library")
judged(whole, change(only, (hashed, "0" * 64)), 2, f"'photometry/lambert_panel_600.ies' of luminaire type 'panel' is not an allowed photometry file; its SHA-256 is {hashed}",
       name="photometry of one's own")
# What the listed file takes from another one: the factors of a tilt multiply its light.
tilted = ies.replace(b"TILT=NONE", b"TILT=own.tilt")
with_tilt = change(only, (hashed, hashlib.sha256(tilted).hexdigest()))
for ending, code, said in ((".tilt", 2, "'photometry/own.tilt' is not an allowed photometry file"), (".csv", 2, "whose name is that of a mesh, a table or an XML file")):
    put(whole)
    (WORK / "zone-policy.xml").write_text(change(with_tilt, (hashlib.sha256(tilted).hexdigest(), hashlib.sha256(tilted.replace(b".tilt", ending.encode())).hexdigest())))
    (WORK / "design" / "photometry" / "lambert_panel_600.ies").write_bytes(tilted.replace(b".tilt", ending.encode()))
    (WORK / "design" / "photometry" / f"own{ending}").write_text("1\n2\n0 180\n1.9 1.9\n")
    run = luxgate("check", "design/project.xml", "--rules", "zones.xml", "--policy", "zone-policy.xml", "--pictures", "off", "--format", "json", "--max-paths", "65536")
    expect(run.returncode == code and said in run.stderr, f"another tilt, {ending}: {run.returncode}, {run.stderr}")
judged(whole, change(wants, ('spaces="office-*"', 'spaces="office-*" projects="*/offices/*"')), 2, "space 'office-1' matches no <asked>", name="a row of no project of the batch")

# The policy itself.
explained = luxgate("policy", "explain", "policy.xml")
(WORK / "zone-policy.xml").write_text(change(only, (hashed, "0" * 64)))
zones_explained = luxgate("policy", "explain", "zone-policy.xml").stdout
for words in ("  on zones of workplaces, unchanged\n", "  role 'task' on at least 0.5 of the floor\n", "fact 'need' of own:1: at least 200\n", "photometry that may be used: 0000",
              "each space must have a requirement of these rows"):
    expect(words in zones_explained, f"explain: '{words}' is not in {zones_explained}")
for words in ("may waive what fails: A. Meier, Q. Board, for at most 200 days", "may state a deviation from a standard: nobody", sha,
              "must be required as a whole: own:1 office, in spaces like 'office-*' of projects like 'design/*', at least 1", "flux-ratio: at most 1", "must be written: json"):
    expect(explained.returncode == 0 and words in explained.stdout, f"explain: '{words}' is not in {explained.stdout}{explained.stderr}")
expect(luxgate("policy", "check", "policy.xml").returncode == 0, "a good policy is refused")
for name, text, said in [
        ("an edition is missing", change(POLICY, ("own:1", "own")), "has no edition"),
        ("no such warning", change(POLICY, ("values-set", "value-set")), "'value-set' is not the id of a warning"),
        ("an error as a warning", change(POLICY, ("values-set", "xml-syntax")), "'xml-syntax' is not the id of a warning"),
        ("twice", change(POLICY, ("<bound of=\"reflectance\"", "<waivers/><bound of=\"reflectance\"")), "<waivers> is given twice"),
        ("a bound of nothing", change(POLICY, (' at-most="0.85"/>\n<bound of="flux', '/>\n<bound of="flux')), "needs 'at-least' or 'at-most'"),
        ("no hash", change(POLICY, ("<format", '<photometry sha256="12"/><format')), "'12' is not a SHA-256"),
        ("a fact of no edition", change(POLICY, ("<format", '<fact pack="own" id="need"/><format')), "has no edition"),
        ("a role of no share", change(POLICY, ('row="office" spaces', 'row="office" role="task" spaces')), "'role' without 'floor-share'"),
        ("a share of two", change(POLICY, ('row="office" spaces', 'row="office" floor-share="2" spaces')), "a number above 0, up to 1"),
        ("no such zones", change(POLICY, ('row="office" spaces', 'row="office" zones="own" spaces')), "unknown value 'own'; allowed: any, workplace or unchanged"),
        ("no such format", change(POLICY, ('"json"', '"jsn"')), "unknown format 'jsn'"),
        ("an unknown element", change(POLICY, ("<format", "<formt")), "unknown element <formt>"),
        ("no name", change(POLICY, (' name="Owner\'s rules 2026"', "")), "needs the attribute 'name'"),
        ("nobody by name", change(POLICY, ('by="A. Meier; Q. Board"', 'by=" ; "')), "must not be empty"),
        ("a project", PROJECT, "it is a luxgate project")]:
    (WORK / "bad.xml").write_text(text)
    for run in (luxgate("policy", "check", "bad.xml"), luxgate("check", "design/project.xml", "--policy", "bad.xml")):
        expect(run.returncode == 2 and said in run.stderr, f"policy, {name}: {run.returncode}, {run.stderr}")
run = luxgate("check", "design/project.xml", "--policy", "nowhere.xml")
expect(run.returncode == 2 and "nowhere.xml" in run.stderr, f"no policy: {run.returncode}, {run.stderr}")
print("\n".join(problems))
sys.exit(1 if problems else 0)
