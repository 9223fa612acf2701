"""A run that is killed at any moment leaves files that are whole and of one run, and nothing that the next run does not clear away.

    kills.py LUXGATE FOLDER [EXAMPLES] [--moments N]    FOLDER is made anew; N random moments, default 18
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
MOMENTS = int(sys.argv[sys.argv.index("--moments") + 1]) if "--moments" in sys.argv else 18
KINDS = {"json": "x.json", "csv": "x.csv", "html": "x.html", "sarif": "x.sarif", "junit": "x.xml", "markdown": "x.md"}
GENERATIONS = ("desk-alpha", "desk-beta")  # the plane that all formats name
DESIGN = """<luxgate version="1" maintenance-factor="0.8"><material id="m" reflectance="0.5"/><luminaire-type id="t" photometry="spot.ies"/>
<room id="r" size="5 4 2.8" ceiling="m" walls="m" floor="m"><luminaire id="L" type="t" position="2 2 2.7"/>
<plane id="{}" height="0.8" count="90 90"><require quantity="average" at-least="1e6"/></plane></room></luxgate>"""
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def start(generation):
    (WORK / "design.xml").write_text(DESIGN.format(GENERATIONS[generation]))
    words = [PROGRAM, "check", "design.xml", "--pictures", "off", "--max-paths", "64", "-q"]
    for kind, name in KINDS.items():
        words += ["--format", f"{kind}=out/{name}"]
    return subprocess.Popen(words, cwd=WORK, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)


def generation_of(kind):
    """0 or 1 of a whole file, else what is wrong with it."""
    text = (WORK / "out" / KINDS[kind]).read_text()
    ends = {"json": "}\n", "csv": "\n", "html": "</html>\n", "sarif": "}\n", "junit": "</testsuites>\n", "markdown": "\n"}
    if not text.endswith(ends[kind]):
        return f"{kind} ends with {text[-30:]!r}"
    if kind in ("json", "sarif"):
        json.loads(text)
    found = [g for g in (0, 1) if GENERATIONS[g] in text]
    return found[0] if len(found) == 1 else f"{kind} is of the runs {found}"


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
small_designs.write(WORK / "x.xml")
begin = time.monotonic()
run = start(0)
expect(run.wait() == 1, f"the design: {run.stderr.read()}")
whole_s = time.monotonic() - begin
draw = random.Random(23)


def allowed_mixed(moments):
    """Between two renames a kill is possible, but of that there are some microseconds; more where a busy machine stops the program just there."""
    return moments // 60 + (moments >= 60)


mixed = late = moment = 0
moments = MOMENTS
# One in a few moments tells little: then more are drawn.
while moment < moments or (mixed > allowed_mixed(moments) and moments < 60):
    moments = moments if moment < moments else 60
    moment += 1
    how = (signal.SIGKILL, signal.SIGTERM, signal.SIGINT)[moment % 3]
    # Every second one while the files are written, which is the last half.
    at_s = draw.uniform(0.4 if moment % 2 else 0.0, 1.05) * whole_s
    run = start(1)
    time.sleep(at_s)
    run.send_signal(how)
    begin = time.monotonic()
    try:
        code = run.wait(timeout=3)
    except subprocess.TimeoutExpired:
        run.kill()
        run.wait()
        code = "no end"
    late = max(late, time.monotonic() - begin)
    # Before it listens to signals they end it as they end everything.
    allowed = (1, 130, -how) if how != signal.SIGKILL else (1, -how)
    expect(code in allowed, f"{how.name} after {at_s:.3f} s: {code}, {run.stderr.read()}")
    generations = {kind: generation_of(kind) for kind in KINDS}
    wrong = [word for word in generations.values() if isinstance(word, str)]
    expect(not wrong, f"{how.name} after {at_s:.3f} s: {wrong}")
    seen = set(generations.values())
    mixed += len(seen) > 1
    if how != signal.SIGKILL:
        expect(len(seen) == 1, f"{how.name} after {at_s:.3f} s: files of two runs: {generations}")
        expect(seen == {1} if code == 1 else seen == {0}, f"{how.name}: code {code} with files of run {seen}")
    if seen != {0}:
        expect(start(0).wait() == 1, "the first run again")
expect(mixed <= allowed_mixed(moments), f"files of two runs after {mixed} of {moments} kills")
print(f"{moments} moments of {whole_s:.2f} s: {mixed} times files of two runs, the latest end after {late:.2f} s")

# What a killed run has left is cleared away by the next one, but nothing that somebody may be writing.
old = time.time() - 3600
left = [path for path in (WORK / "out").iterdir() if path.name.startswith(".")]
for path in left:
    os.utime(path, (old, old))
stale, fresh, other = (WORK / "out" / name for name in (".x.json.999999-0.tmp", ".x.json.999998-0.tmp", ".x.json.notes.tmp"))
for path in (stale, fresh, other):
    path.write_text("half")
for path in (stale, other):
    os.utime(path, (old, old))
expect(start(0).wait() == 1, "the run after the kills")
kept = sorted(path.name for path in (WORK / "out").iterdir() if path.name.startswith("."))
expect(kept == [fresh.name, other.name], f"left behind: {kept}")

# A second writer is noticed; whole files win.
(WORK / "out" / "x.csv").unlink()
run = subprocess.Popen([PROGRAM, "check", "design.xml", "--pictures", "off", "--goal", "accuracy", "--tolerance", "0.001", "--format", "csv=out/x.csv"], cwd=WORK, stderr=subprocess.PIPE,
                       stdout=subprocess.DEVNULL, text=True, env={})
time.sleep(0.3)
(WORK / "out" / "x.csv").write_text("of somebody else\n")
run.send_signal(signal.SIGINT)
said = run.communicate()[1]
expect(run.returncode in (130, 1), f"a second writer: {run.returncode}")
again = subprocess.Popen([PROGRAM, "check", "design.xml", "--pictures", "off", "--max-paths", "64", "--format", "csv=out/x.csv"], cwd=WORK, stderr=subprocess.PIPE,
                         stdout=subprocess.DEVNULL, text=True, env={})
while not (list((WORK / "out").glob(".x.csv.*.tmp"))) and again.poll() is None:
    (WORK / "out" / "x.csv").write_text("of somebody else\n")
said = again.communicate()[1]
expect(again.returncode == 1 and "output-written-meanwhile" in said, f"a second writer: {again.returncode}, {said}")

# Pipes, and two names of one file.
os.mkfifo(WORK / "pipe")
run = subprocess.Popen([PROGRAM, "check", "design.xml", "--pictures", "off", "--max-paths", "64", "-q", "--format", "csv=pipe"], cwd=WORK, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
with open(WORK / "pipe", encoding="utf-8") as pipe:
    text = pipe.read()
whole = subprocess.run([PROGRAM, "check", "design.xml", "--pictures", "off", "--max-paths", "64", "--format", "csv"], cwd=WORK, capture_output=True, text=True, check=False).stdout
expect(run.wait() == 1 and text == whole, f"a pipe with a reader: {text[:200]}")
(WORK / "link").symlink_to("not-yet")
run = subprocess.run([PROGRAM, "check", "design.xml", "--pictures", "off", "-q", "--format", "csv=link", "--format", "json=not-yet"], cwd=WORK, capture_output=True, text=True, check=False)
expect(run.returncode == 2 and "would be written twice" in run.stderr, f"a link to a file that is not there yet: {run.returncode}, {run.stderr}")
begin = time.monotonic()
run = subprocess.run([PROGRAM, "check", "design.xml", "--pictures", "off", "--max-paths", "64", "-q", "--format", "csv=pipe"], cwd=WORK, capture_output=True, text=True, timeout=30, check=False)
expect(run.returncode == 2 and "nobody reads from this pipe" in run.stderr, f"a pipe without a reader: {run.returncode}, {run.stderr}")
print("\n".join(problems))
sys.exit(1 if problems else 0)
