"""What the program takes from standard input, and what it says on standard error of files that it reads and writes.

    streams.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
FAST = ["--max-paths", "256", "--pictures", "off"]
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code, says="", given=None):
    done = subprocess.run([PROGRAM, *words], cwd=WORK, input=given, capture_output=True, text=True, check=False)
    expect(done.returncode == code, f"{words}: exit code {done.returncode}, expected {code}\n{done.stderr}")
    expect(says in done.stderr, f"{words}: '{says}' is not said:\n{done.stderr}")
    return done


def without_places(value):
    """Without where it stands in which file."""
    if isinstance(value, list):
        return [without_places(one) for one in value]
    if isinstance(value, dict):
        return {key: without_places(one) for key, one in value.items() if key != "where"}
    return value


def result(*words, **others):
    return json.loads(run("check", *words, *FAST, "--format", "json", code=1, **others).stdout)


shutil.rmtree(WORK, ignore_errors=True)
small_designs.write(WORK / "a.xml")
text = (WORK / "a.xml").read_text()

# A project from standard input is judged as the file is: photometry is looked for from the current folder.
of_file, of_input = result("a.xml"), result("-", given=text)
expect(of_input["projects"][0]["path"] == "-", f"path: {of_input['projects'][0]['path']}")
spaces = without_places(of_file["projects"][0]["spaces"])
expect(without_places(of_input["projects"][0]["spaces"]) == spaces, "standard input gives other numbers")
both = result("a.xml", "-", given=text)
expect([project["path"] for project in both["projects"]] == ["a.xml", "-"], "a file and standard input")
run("validate", "-", given=text, code=0)
run("plan", "-", given=text, code=0)
run("check", "-", given="<luxgate", code=2, says="-:1:")
run("check", "-", given="", code=2, says="-:")
(WORK / "deep").mkdir()
(WORK / "deep" / "a.xml").write_text(text)
run("check", "-", given=text.replace('"spot.ies"', '"../spot.ies"'), code=2, says="..")
with open(WORK / "a.xml") as project:
    done = subprocess.run([PROGRAM, "check", "-", *FAST, "--format", "json=a.xml"], cwd=WORK, stdin=project, capture_output=True, text=True, check=False)
expect(done.returncode == 2 and "is an input and would be overwritten" in done.stderr and (WORK / "a.xml").read_text() == text, f"< a.xml: {done.stderr}")
# A file of that name is another thing.
(WORK / "-").write_text(text.replace('at-least="100"', 'at-least="99999"'))
expect(without_places(result("-", given=text)["projects"][0]["spaces"]) == spaces, "the file '-' was read")
expect(result("./-")["projects"][0]["path"] == "./-", "./- is not the file")
(WORK / "-").unlink()
(WORK / "-").mkdir()
expect(result("-", given=text)["projects"][0]["path"] == "-", "the folder '-' was read")
(WORK / "-").rmdir()
run("check", "-", "-", given=text, code=2, says="given twice")
run("check", "-", "--files-from", "-", given=text, code=2, says="standard input cannot be a project and the list")
run("check", "-", "--against", "HEAD", given=text, code=2, says="'-' (standard input) and --against exclude each other")
run("check", "-", "--shard", "1/2", "--store", "looks", given=text, code=2, says="'-' (standard input) and --shard exclude each other")
run("watch", "-", given=text, code=2, says="can be checked, planned and validated, nothing else")
run("submit", "-", "--engine", "local", "--store", "looks", given=text, code=2, says="can be checked, planned and validated, nothing else")

# What was written is named, unless that is not wanted.
formats = ["--format", "json=r.json", "--format", "html=out/r.html", "--format", "csv=r.csv"]
run("check", "a.xml", *FAST, *formats, code=1, says="luxgate: wrote r.json, out/r.html, r.csv\n")
run("report", "r.json", "--format", "markdown=r.md", code=0, says="luxgate: wrote r.md\n")
run("compare", "r.json", "r.json", "--format", "json=c.json", code=0, says="luxgate: wrote c.json\n")
done = run("check", "a.xml", *FAST, "--output", "all", "--images", code=1)
names = re.search(r"^luxgate: wrote (.*) and (\d+) more$", done.stderr, re.M)
written = {file for file in (WORK / "all").iterdir() if file.is_file()}
expect(names and len(names[1].split(", ")) + int(names[2]) == len(written), f"--images: {len(written)} files; {done.stderr}")
for code, words in ((1, ["check", "a.xml", *FAST, *formats]), (0, ["report", "r.json", "--format", "markdown=r.md"])):
    expect("wrote" not in run(*words, "--quiet", code=code).stderr, f"{words}: --quiet")
expect("wrote" not in run("compare", "r.json", "r.json", "--format", "json=c.json", "-q", code=0).stderr, "compare -q")
# Only what is there.
# An output that the caller has closed is a full disk, and no file that is opened takes its number.
closed = subprocess.run(["sh", "-c", 'exec "$0" "$@" >&-', PROGRAM, "check", "a.xml", *FAST, "--format", "json"], cwd=WORK, stderr=subprocess.PIPE, text=True, check=False)
expect(closed.returncode == 2 and "cannot write to standard output" in closed.stderr, f"a closed output: {closed.returncode} {closed.stderr}")
done = run("check", "a.xml", *FAST, "--format", "json=/dev/full", "--format", "csv=s.csv", code=2, says="/dev/full")
expect("luxgate: wrote s.csv\n" in done.stderr, f"/dev/full: {done.stderr}")

# What is read.
(WORK / "luxgate.toml").write_text("seed = 3\n")
for command in ("check", "validate", "plan"):
    more = FAST[:2] if command == "check" else []
    done = run(command, "a.xml", "-v", *more, code=1 if command == "check" else 0, says="luxgate: settings: luxgate.toml\n")
    for file in ("a.xml", "spot.ies"):
        size = (WORK / file).stat().st_size
        expect(done.stderr.count(f"luxgate: read {file}: {size} bytes\n") == 1, f"{command} -v: {done.stderr}")
run("validate", "a.xml", "-v", "--no-config", code=0, says="luxgate: settings: none\n")
(WORK / "b.xml").write_text(text.replace("spot.ies", "gone.ies"))
run("validate", "b.xml", "-v", code=2, says="luxgate: cannot read gone.ies\n")

print("\n".join(problems))
sys.exit(1 if problems else 0)
