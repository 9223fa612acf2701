"""--space, --plane, --tag, --require: what is chosen has the numbers that it has in the whole; what is not is said in every format.

    selection.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import pathlib
import shutil
import subprocess
import sys

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
TEXTS = ["text", "csv", "html", "junit", "sarif", "sarif-all", "github", "gitlab", "markdown"]
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code, says=""):
    done = subprocess.run([PROGRAM, "check", *words, "--pictures", "off", "--max-paths", "256"], cwd=WORK, capture_output=True, text=True,
                          check=False)
    expect(done.returncode == code, f"{words}: exit code {done.returncode}, expected {code}\n{done.stderr}")
    expect(says in done.stderr, f"{words}: '{says}' is not said:\n{done.stderr}")
    return done


def result(*words, code):
    return json.loads(run(*words, "--format", "json", code=code).stdout)


def findings(document):
    return {(space["id"], plane["id"], finding["requirement"]): finding for project in document["projects"] for space in project["spaces"]
            for plane in space["planes"] for finding in plane["findings"]}


shutil.rmtree(WORK, ignore_errors=True)
design = small_designs.write(WORK / "a.xml")
other = small_designs.write(WORK / "b.xml", plane="bench", far=False)

# The design fails, and only its far plane does.
whole = result("a.xml", code=1)
desk = result("a.xml", "--plane", "desk", code=0)
expect(list(findings(desk)) == [("room", "desk", "mean")], f"--plane desk: {list(findings(desk))}")
expect(findings(desk)[("room", "desk", "mean")] == findings(whole)[("room", "desk", "mean")], "a plane by itself has other numbers")
expect(list(findings(result("a.xml", "--require", "minimum", code=1))) == [("room", "far", "least")], "--require by quantity")
expect(list(findings(result("a.xml", "--space", "Off*", "--require", "mean", code=0))) == [("room", "desk", "mean")], "--space by name")
expect(desk["provenance"]["selection"] == "--plane desk", f"provenance: {desk['provenance'].get('selection')}")
expect("--plane desk" in desk["provenance"]["command_line"], f"provenance: {desk['provenance']['command_line']}")
expect("selection" not in whole["provenance"], "a whole check has a selection")

# Every format says it.
for kind in TEXTS:
    text = run("a.xml", "--plane", "desk", "--format", kind, code=0).stdout
    words = "Only part of the requirements was judged, chosen by --plane desk." if kind == "text" else "only 1 of 2 requirements were chosen, by --plane desk"
    expect(words in text, f"{kind} does not say that a part was judged")
run("a.xml", "--plane", "desk", "--strict=part-selected", code=2)
for language, met in (("en", "All requirements are met"), ("de", "Alle Anforderungen sind erfüllt"), ("fr", "Toutes les exigences")):
    page = run("a.xml", "--plane", "desk", "--format", "html", "--language", language, code=0).stdout
    expect(met not in page and 'class="banner pass"' not in page, f"the page in {language} is green for a part")

# What fits nothing is never green.
run("a.xml", "--plane", "dsk", code=2, says="there are the planes desk, far")
run("a.xml", "--plane", "desk", "--require", "Uo", code=2, says="there are the requirements mean")
run("a.xml", "--space", "attic", code=2, says="--space attic chooses nothing in any of the projects")
for kind, words in (("junit", 'errors="1"'), ("text", "error[selection-empty]"), ("sarif", '"executionSuccessful": false')):
    text = run("a.xml", "b.xml", "--plane", "dsk", "--format", kind, code=2).stdout
    expect(words in text, f"{kind} does not say that nothing was chosen: {text}")
run("a.xml", "b.xml", "--plane", "bench", code=0, says="a.xml: warning[nothing-selected]: --plane bench chooses nothing here")
run("a.xml", "--plane", "", code=2, says="a name is needed")

# Tags: of planes and of spaces; they change nothing else, and commands that plan or watch choose by them, too.
tagged = (WORK / "a.xml").read_text()
tagged = tagged.replace('<plane id="desk"', '<plane id="desk" tags="lease-A quiet"').replace('<room id="room"', '<room id="room" tags="north"')
(WORK / "tagged.xml").write_text(tagged)
measured = [[finding["measured"] for finding in findings(of).values()] for of in (result("tagged.xml", code=1), whole)]
expect(measured[0] == measured[1], f"tags change numbers: {measured}")
expect(list(findings(result("tagged.xml", "--tag", "lease-*", code=0))) == [("room", "desk", "mean")], "--tag of a plane")
expect(len(findings(result("tagged.xml", "--tag", "north", code=1))) == 2, "--tag of a room")
run("tagged.xml", "--tag", "south", code=2, says="there are the tags north, lease-A, quiet")
run("a.xml", "--tag", "north", code=2, says="there are no tags")
run("tagged.xml", "--tag", "quiet", "--against", "HEAD", code=2, says="--against needs all")
for more, code, says in ((["--tag", "quiet"], 0, "only 1 of 2 requirements were chosen"), (["--tag", "loud"], 2, "--tag loud chooses nothing in any of the projects"),
                         (["--tag", "quiet", "--units"], 2, "--units")):
    done = subprocess.run([PROGRAM, "plan", "tagged.xml", *more], cwd=WORK, capture_output=True, text=True, check=False)
    expect(done.returncode == code and says in done.stderr, f"plan {more}: {done.returncode}, {done.stderr}")
    expect(code != 0 or "plane desk" in done.stdout and "plane far" not in done.stdout, f"plan {more}: {done.stdout}")

# What a row asks of the room stands on a plane of the first workplace that asks, and goes with each of them.
ROOM = """<luxgate version="1" name="Leases" maintenance-factor="0.8">
<material id="light" reflectance="0.7"/><material id="dark" reflectance="0.2"/>
<luminaire-type id="spot" photometry="spot.ies" flux-lm="20000"/>
<room id="room" size="4 3 2.7" ceiling="light" walls="light" floor="dark">
<luminaire-grid id="L" type="spot" origin="0 0 2.69" size="4 3" columns="2" rows="2"/>
<workplace id="A" tags="leaseA" pack="en12464-1:2021" row="34.2" glare="table" footprint="0.4 0.6  1.6 0.6  1.6 1.3  0.4 1.3" height="0.75"/>
<workplace id="B" tags="leaseB" pack="en12464-1:2021" row="34.2" glare="table" footprint="2.2 0.6  3.4 0.6  3.4 1.3  2.2 1.3" height="0.75">{more}</workplace>
</room></luxgate>"""
(WORK / "leases.xml").write_text(ROOM.format(more=""))


def asked(*words):
    done = subprocess.run([PROGRAM, "check", "leases.xml", *words, "--pictures", "off", "--max-paths", "64", "--format", "json"], cwd=WORK, capture_output=True, text=True,
                          check=False)
    return {(plane, requirement) for _, plane, requirement in findings(json.loads(done.stdout))}, done


everything, _ = asked()
glare = {key for key in everything if key[1].startswith("UGR-table")}
walls = {key for key in everything if ".wall." in key[0] or ".ceiling" in key[0]}
expect(len(glare) == 1 and walls, f"leases: {sorted(everything)}")
for lease, other in (("A", "B"), ("B", "A")):
    chosen, _ = asked("--tag", f"lease{lease}")
    expect(glare | walls <= chosen, f"--tag lease{lease} leaves out {sorted((glare | walls) - chosen)}")
    expect(not any(plane == f"{other}.task" for plane, requirement in chosen - glare), f"--tag lease{lease}: {sorted(chosen)}")
expect(asked("--tag", "lease?")[0] == everything, "--tag of all")
# A zone that was left out, and is not any more, counts as not judged in a part, too.
(WORK / "leases.xml").write_text(ROOM.format(more='<without role="surround" because="x" by="me" until="2020-01-01"/>'))
for words in (["--plane", "B.surround"], ["--plane", "B.*", "--require", "average"], ["--tag", "leaseB"]):
    _, done = asked(*words)
    expect(done.returncode == 2 and "B.surround" in done.stderr, f"{words}: {done.returncode}, {done.stderr}")
expect("B.surround" not in asked("--tag", "leaseA")[1].stderr, "--tag leaseA has B's zone")
expect(asked("--plane", "B.*", "--require", "no-such")[1].returncode == 2, "a wrong --require beside a zone that is left out")

# Nor is a part what a gate wants.
(WORK / "whole.json").write_text(json.dumps(whole))
(WORK / "desk.json").write_text(json.dumps(desk))
run("a.xml", "--plane", "desk", "--baseline", "whole.json", code=2, says="--baseline needs all")
run("a.xml", "--baseline", "desk.json", code=2, says="only a part of what is required was judged")
run("a.xml", "--plane", "desk", "--policy", "p.xml", code=2, says="--policy needs all")
for files in (["desk.json", "--baseline", "whole.json"], ["whole.json", "--baseline", "desk.json"]):
    done = subprocess.run([PROGRAM, "report", *files, "--format", "text"], cwd=WORK, capture_output=True, text=True, check=False)
    expect(done.returncode == 2 and "only a part" in done.stderr, f"report {files}: {done.returncode}, {done.stderr}")
# Nor can somebody take the word out of a result.
for edit in (lambda result: result["provenance"].pop("selection"), lambda result: result["projects"][0].update(diagnostics=[])):
    edited = json.loads(json.dumps(desk))
    edit(edited)
    (WORK / "edited.json").write_text(json.dumps(edited))
    done = subprocess.run([PROGRAM, "report", "edited.json", "--format", "text"], cwd=WORK, capture_output=True, text=True, check=False)
    expect(done.returncode == 2 and "provenance/selection" in done.stderr, f"report of an edited part: {done.returncode}, {done.stderr}")
for more, code, says in (([], 2, "A is a result of the part of --plane desk, B of all"), (["--partial"], 0, "")):
    done = subprocess.run([PROGRAM, "compare", "desk.json", "whole.json", *more], cwd=WORK, capture_output=True, text=True, check=False)
    expect(done.returncode == code and says in done.stderr, f"compare {more}: {done.returncode}, {done.stderr}{done.stdout}")
again = subprocess.run([PROGRAM, "report", "desk.json", "--format", "text"], cwd=WORK, capture_output=True, text=True, check=False)
expect(again.returncode == 0 and "Only part of the requirements was judged" in again.stdout, f"report: {again.stdout}{again.stderr}")

print("\n".join(problems))
sys.exit(1 if problems else 0)
