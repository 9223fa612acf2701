"""A stranger's pull request, judged by the owner's policy: ways to a green tick without better light, each is named and ends with 2.

    policy_attacks.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
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
DAY = {"SOURCE_DATE_EPOCH": "1767225600"}  # 2026-01-01
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
WAIVED = ' waived-because="soon" waived-by="{}" waived-until="2026-05-01"/>'
dark_min = ('at-least="300"/>', 'at-least="300"' + WAIVED.format("A. Meier"))
ways = [
    ("a waiver by a stranger", change(too_dark, (ROW, WAIVER.format("Me", "2026-05-01")), dark_min), "is by 'Me'; allowed: A. Meier, Q. Board"),
    ("a waiver for ever", change(too_dark, (ROW, WAIVER.format("A. Meier", "2099-01-01")), dark_min), "allowed: 200 days"),
    ("an own requirement waived by a stranger", change(PROJECT, ('at-least="300"/>', 'at-least="5000"' + WAIVED.format("Me"))), "is by 'Me'"),
    ("nothing is asked", change(too_dark, (ROW, ""), ('<require id="own" quantity="minimum" at-least="300"/>', "")), "nothing is asked of space 'office-1'"),
    ("another requirement instead of the row", change(too_dark, (ROW, ""), ('at-least="300"', 'at-least="5"')), "own:1 office of space 'office-1' is not asked"),
    ("the row as advice of a lower level", change(too_dark, ('row="office"', 'row="office" level="-2" level-because="I say so"'),
                                                  ('at-least="300"', 'at-least="5"')), "asks its row below what it requires"),
    ("another name of the room", change(too_dark, ("office-1", "store-1"), (ROW, ""), ('at-least="300"', 'at-least="5"')), "0 spaces are like 'office-*'"),
    ("new for ever", change(PROJECT, ('factor="0.8"', 'factor="1"')), "maintenance-factor of luminaire type 'panel' is 1; at most 0.85"),
    ("no factor at all", change(PROJECT, (' maintenance-factor="0.8"', "")), "maintenance-factor of luminaire type 'panel' is 1"),
    ("walls of snow", change(PROJECT, ('reflectance="0.7"', 'reflectance="0.95"')), "reflectance of material 'light' is 0.95"),
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
permitted = change(too_dark, (ROW, WAIVER.format("A. Meier", "2026-05-01")), dark_min)
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
expect(run.returncode == 0, f"a row of another project: {run.returncode}, {run.stderr}")
put(change(PROJECT, (ROW, "")))
run = check(projects=("./design/project.xml", "other/project.xml"))
expect(run.returncode == 2 and "own:1 office of space 'office-1' is not asked" in run.stderr, f"a row, by another path: {run.returncode}, {run.stderr}")
submit = luxgate("submit", "--engine", "local", "other/project.xml", "--rules", "own.xml", "--policy", "policy.xml", "--store", "s", "--format", "json=x.json")
expect(submit.returncode == 2 and "'design/project.xml' is not among" in submit.stderr and not (WORK / "s-job").exists(), f"submit: {submit.stderr}")
put(PROJECT)

# The policy itself.
explained = luxgate("policy", "explain", "policy.xml")
for words in ("may waive what fails: A. Meier, Q. Board, for at most 200 days", "may state a deviation from a standard: nobody", sha,
              "must be asked as a whole: own:1 office, in spaces like 'office-*' of projects like 'design/*', at least 1", "flux-ratio: at most 1", "must be written: json"):
    expect(explained.returncode == 0 and words in explained.stdout, f"explain: '{words}' is not in {explained.stdout}{explained.stderr}")
expect(luxgate("policy", "check", "policy.xml").returncode == 0, "a good policy is refused")
for name, text, said in [
        ("an edition is missing", change(POLICY, ("own:1", "own")), "names no edition"),
        ("no such warning", change(POLICY, ("values-set", "value-set")), "'value-set' is not the id of a warning"),
        ("an error as a warning", change(POLICY, ("values-set", "xml-syntax")), "'xml-syntax' is not the id of a warning"),
        ("twice", change(POLICY, ("<bound of=\"reflectance\"", "<waivers/><bound of=\"reflectance\"")), "<waivers> stands there twice"),
        ("a bound of nothing", change(POLICY, (' at-most="0.85"/>\n<bound of="flux', '/>\n<bound of="flux')), "needs 'at-least' or 'at-most'"),
        ("no such format", change(POLICY, ('"json"', '"jsn"')), "there is no format 'jsn'"),
        ("an unknown element", change(POLICY, ("<format", "<formt")), "unknown element <formt>"),
        ("no name", change(POLICY, (' name="Owner\'s rules 2026"', "")), "needs the attribute 'name'"),
        ("nobody by name", change(POLICY, ('by="A. Meier; Q. Board"', 'by=" ; "')), "must not be empty"),
        ("a project", PROJECT, "root element is <luxgate>")]:
    (WORK / "bad.xml").write_text(text)
    for run in (luxgate("policy", "check", "bad.xml"), luxgate("check", "design/project.xml", "--policy", "bad.xml")):
        expect(run.returncode == 2 and said in run.stderr, f"policy, {name}: {run.returncode}, {run.stderr}")
run = luxgate("check", "design/project.xml", "--policy", "nowhere.xml")
expect(run.returncode == 2 and "nowhere.xml" in run.stderr, f"no policy: {run.returncode}, {run.stderr}")
print("\n".join(problems))
sys.exit(1 if problems else 0)
