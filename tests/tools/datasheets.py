"""--datasheets: the sheets of 'check' and of 'report' are the same, and where there is none, the page says why.

    datasheets.py LUXGATE FOLDER    FOLDER is made anew
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
MOST_S = 120
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def luxgate(*words, cwd=WORK):
    done = subprocess.run([PROGRAM, *words], cwd=cwd, capture_output=True, timeout=MOST_S, check=False, env={**os.environ, "LUXGATE_LANGUAGE": ""})
    return done.returncode, done.stderr.decode()


def sheets(name, cwd=WORK):
    """The part of a page that holds the sheets; "" = it has none."""
    found = re.search(r'<div class="data-sheets">.*?\n</div>\n(?=</section>)', (cwd / name).read_text(), re.S)
    return found.group() if found else ""


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
small_designs.write(WORK / "in/p.xml")
CHECK = ["check", "in/p.xml", "--pictures", "off", "--max-paths", "64"]
code, words = luxgate(*CHECK, "--datasheets", "--format", "html=with.html", "--format", "json=r.json")
expect(code == 1, f"check: {code}, {words}")
luxgate(*CHECK, "--format", "html=without.html")
luxgate(*CHECK, "--datasheets", "--redact", "--format", "html=redacted.html")
(WORK / "in/luxgate.toml").write_text("datasheets = true\n")
luxgate(*CHECK, "--format", "html=config.html")
expect(sheets("with.html").count("CIE flux code") == 1 and "luxgate tests" in sheets("with.html"), "no sheet")
expect("data-sheet" not in (WORK / "without.html").read_text(), "a sheet that nobody asked for")
for name in ("redacted.html", "config.html"):
    expect(sheets(name) == sheets("with.html"), f"{name}: other sheets")

code, words = luxgate("report", "r.json", "--datasheets", "--format", "html=again.html")
expect(code == 0 and sheets("again.html") == sheets("with.html"), f"report: {code}, {words}")
shutil.copytree(WORK / "in", WORK / "moved/in")  # result and project together
shutil.copy(WORK / "r.json", WORK / "moved")
code, words = luxgate("report", "../moved/r.json", "--datasheets", "--format", "html=m.html", cwd=WORK / "in")
expect(code == 0 and sheets("m.html", WORK / "in") == sheets("with.html"), f"moved: {code}, {words}")
with open(WORK / "in/spot.ies", "a") as file:
    file.write("\n")
luxgate("report", "r.json", "--datasheets", "--language", "fr", "--format", "html=other.html")
expect("le fichier photométrique n’est pas celui du calcul" in sheets("other.html") and "<table" not in sheets("other.html"), "a changed file is shown")
(WORK / "in/spot.ies").unlink()
luxgate("report", "r.json", "--datasheets", "--format", "html=none.html")
expect("the photometry file is not at the place that the result names" in sheets("none.html"), "a missing file is not said")

print("\n".join(problems) or "data sheets are as they should be")
sys.exit(bool(problems))
