"""Inputs by somebody who means harm: no secret is told, nothing hangs, no log or memory is filled, no runner or spreadsheet takes orders.

    attacks.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import csv
import io
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
SECRET = "ghp_0123456789abcdefSECRET"
MOST_S, MOST_BYTES, MOST_TEXT = 20, 1 << 30, 2_000_000
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def fresh(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def limit_memory():
    if "ASAN_OPTIONS" in os.environ:  # a sanitizer's own memory is terabytes
        return
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_BYTES, MOST_BYTES))


def luxgate(*words, cwd=WORK, code=None, name="", **options):
    """With limits of time, memory and what it may say."""
    begin = time.monotonic()
    try:
        run = subprocess.run([PROGRAM, *words], cwd=cwd, capture_output=True, timeout=MOST_S, preexec_fn=limit_memory, check=False, **options)
    except subprocess.TimeoutExpired:
        problems.append(f"{name}: more than {MOST_S} s")
        return subprocess.CompletedProcess(words, None, b"", b"")
    expect(run.returncode is not None and run.returncode >= 0, f"{name}: ended by signal {-run.returncode}")
    expect(code is None or run.returncode in code, f"{name}: exit code {run.returncode}, expected {code}: {run.stderr[-600:]}")
    expect(len(run.stdout) + len(run.stderr) < MOST_TEXT, f"{name}: {len(run.stdout)} + {len(run.stderr)} bytes in {time.monotonic() - begin:.1f} s")
    return run


HEAD = """<luxgate version="1"><material id="m" reflectance="0.5"/>
<luminaire-type id="t" photometry="{ies}"/>
<room id="r" size="5 4 2.8" ceiling="m" walls="m" floor="m">
{inside}
<plane id="p" height="0.8" count="2 2"><require quantity="average" at-least="1"/></plane>{more}</room></luxgate>"""
LAMP = '<luminaire id="L" type="t" position="2 2 2.7"/>'


def links():
    folder, outside, library = fresh("links"), fresh("outside"), fresh("library")
    small_designs.write(library / "x.xml")
    for name in ("token", "token.ies", "token.csv", "token.obj", "token.ldt"):
        (outside / name).write_text(SECRET + "\n")
    (folder / "own").mkdir()
    shutil.copy(library / "spot.ies", folder / "own" / "spot.ies")
    for ending in ("ies", "ldt", "csv", "obj"):
        (folder / f"stolen.{ending}").symlink_to(outside / "token")
    (folder / "folder").symlink_to(outside)
    (folder / "far.ies").symlink_to("../../../../../../../../../etc/passwd")
    (folder / "zero.ies").symlink_to("/dev/zero")
    (folder / "inside.ies").symlink_to("own/spot.ies")
    (folder / "library.ies").symlink_to(library / "spot.ies")
    (folder / "gone.ies").symlink_to("nowhere.ies")
    (folder / "loop.ies").symlink_to("loop.ies")
    (folder / "absent.ies").symlink_to(outside / "absent.ies")
    (folder / "absent").symlink_to(outside / "absent")
    os.mkfifo(folder / "pipe.ies")
    cases = [("a link to photometry", dict(ies="stolen.ies"), "file-link-outside"), ("to LDT", dict(ies="stolen.ldt"), "file-link-outside"),
             ("a linked folder", dict(ies="folder/token.ies"), "file-link-outside"), ("far away", dict(ies="far.ies"), "file-link-outside"),
             ("a device", dict(ies="zero.ies"), "file-link-outside"), ("a pipe", dict(ies="pipe.ies"), "not a regular file"),
             ("what is not there", dict(ies="absent.ies"), "file-link-outside"), ("a folder that is not there", dict(ies="absent/x.ies"), "file-link-outside"),
             ("what is not there in a linked folder", dict(ies="folder/absent.ies"), "file-link-outside"),
             ("no end", dict(ies="gone.ies"), "No such file"), ("a circle", dict(ies="loop.ies"), "Too many levels"),
             ("dots", dict(ies="../outside/token.ies"), "file-outside-project"), ("absolute", dict(ies=f"{outside}/token.ies"), "file-outside-project"),
             ("luminaires", dict(ies="own/spot.ies", inside='<luminaires file="stolen.csv"/>'), "file-link-outside"),
             ("points", dict(ies="own/spot.ies", more='<plane id="q" file="stolen.csv"/>'), "file-link-outside"),
             ("a mesh", dict(ies="own/spot.ies", inside='<mesh id="o" file="stolen.obj" material="m"/>'), "file-link-outside")]
    for name, parts, said in cases:
        (folder / "p.xml").write_text(HEAD.format(**{"inside": LAMP, "more": "", **parts}))
        for words in (["check", "p.xml", "--pictures", "off", "--format", "html"], ["check", "p.xml", "--format", "json"], ["validate", "p.xml"], ["plan", "p.xml"]):
            run = luxgate(*words, cwd=folder, code=[2], name=f"links, {name}, {words[0]}")
            text = (run.stdout + run.stderr).decode(errors="replace")
            expect(said in text, f"links, {name}, {words[0]}: '{said}' is not said: {text[-400:]}")
            expect("SECRET" not in text and "root:" not in text, f"links, {name}, {words[0]}: tells what it must not")
    for name, ies, options in [("inside", "inside.ies", []), ("allowed", "library.ies", ["--allow", str(library)]), ("plain", "own/spot.ies", [])]:
        (folder / "p.xml").write_text(HEAD.format(ies=ies, inside=LAMP, more=""))
        luxgate("check", "p.xml", *options, cwd=folder, code=[0], name=f"links, {name}")
    (folder / "p.xml").write_text(HEAD.format(ies="stolen.ies", inside=LAMP, more=""))
    luxgate("check", "p.xml", "--allow", str(library), cwd=folder, code=[2], name="links, another is allowed")
    # A project that is a link out of its folder: who names "designs/*.xml" has not meant it.
    (outside / "project.xml").write_text(HEAD.format(ies="spot.ies", inside=LAMP, more="").replace('"0.5"', f'"{SECRET}"'))
    for name, target in (("a project elsewhere", outside / "project.xml"), ("another file", outside / "token"), ("what is not there", outside / "absent.xml")):
        (folder / "q.xml").unlink(missing_ok=True)
        (folder / "q.xml").symlink_to(target)
        for words in (["check", "q.xml", "--format", "json"], ["validate", "q.xml"], ["plan", "q.xml"], ["check", "q.xml", "--sandbox", "off"]):
            run = luxgate(*words, cwd=folder, code=[2], name=f"links, {name}, {words[0]}")
            text = (run.stdout + run.stderr).decode(errors="replace")
            expect("file-link-outside" in text and "SECRET" not in text, f"links, {name}, {words}: {text[-400:]}")
    # Its folder may be a link: that is what was named on the command line.
    (folder / "p.xml").write_text(HEAD.format(ies="own/spot.ies", inside=LAMP, more=""))
    (WORK / "as-link").unlink(missing_ok=True)
    (WORK / "as-link").symlink_to(folder)
    luxgate("check", "as-link/p.xml", code=[0], name="links, the folder is one")


def floods():
    folder = fresh("floods")
    small_designs.write(folder / "x.xml")
    room = HEAD.format(ies="spot.ies", inside=LAMP, more="")
    end = room.index("</room>")
    texts = {"unknown elements": room[:end] + "<a/>" * 500_000 + room[end:],
             "unknown attributes": room[:end] + '<box id="b" q="1"/>' * 100_000 + room[end:],
             "a long name": f"<luxgate><{'a' * 60_000_000}/></luxgate>",
             "a long value": room.replace('"spot.ies"', f'"{"a" * 20_000_000}"'),
             "a long attribute": room.replace("<luxgate", f'<luxgate {"a" * 20_000_000}="1"'),
             "deep": "<a>" * 1_000_000,
             "unknown materials": room[:end] + "".join(f'<box id="b{k}" size="1 1 1" position="0 0 0" material="x{k}"/>' for k in range(50_000)) + room[end:],
             "text": room[:end] + "x" * 5_000_000 + room[end:],
             "lines": room.replace("<room", "<rooom") + "\n" * 100_000_000}
    for name, text in texts.items():
        (folder / "p.xml").write_text(text)
        for words in (["check", "p.xml", "--pictures", "off", "--format", "json"], ["validate", "p.xml"])[name == "lines":]:
            run = luxgate(*words, cwd=folder, code=[2], name=f"floods, {name}, {words[0]}")
            longest = max((len(line) for line in run.stderr.splitlines()), default=0)
            expect(longest < 5000, f"floods, {name}, {words[0]}: a line of {longest} bytes")
    # All warnings of one id do not hide another one that counts.
    (folder / "p.xml").write_text(room[:end] + "".join(f'<luminaire id="M{k}" type="t" position="{2 + k * 1e-3} 2 9"/>' for k in range(1500))
                                  + '<luminaire id="Z" type="t" position="2 2 2.7"/>' + room[end:])
    run = luxgate("validate", "p.xml", "--strict=luminaires-coincide", cwd=folder, code=[2], name="floods, strict")
    expect(b"messages-left-out" in run.stderr and b"luminaires-coincide" in run.stderr, f"floods, strict: {run.stderr[-500:]}")


def ended():
    """A signal is answered within a second or so, whatever is done; with 130."""
    folder = fresh("ended")
    small_designs.write(folder / "x.xml")
    room = HEAD.format(ies="spot.ies", inside="{inside}", more="")
    slow = {"many luminaires": '<luminaire-grid id="G" type="t" origin="0 0 2.7" size="5 4" columns="999" rows="900"/>',
            "many boxes": '<box id="B" size="0.001 0.001 0.001" position="0 0 0" repeat="90 90 90" step="0.01 0.01 0.01" material="m"/>'}
    for name, inside in slow.items():
        (folder / "p.xml").write_text(room.format(inside=inside))
        for sent in (signal.SIGTERM, signal.SIGINT):
            process = subprocess.Popen([PROGRAM, "check", "p.xml", "--limit", "objects=1M", "--format", "json=x.json"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            time.sleep(1.0)
            process.send_signal(sent)
            begin = time.monotonic()
            try:
                process.communicate(timeout=10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
            took = time.monotonic() - begin
            expect(took < 3 and process.returncode in (130, 2, 0), f"ended, {name}: {took:.1f} s, {process.returncode}")
            expect(process.returncode != 130 or not (folder / "x.json").exists(), f"ended, {name}: a result was written")
            (folder / "x.json").unlink(missing_ok=True)


NAMES = ["a\n::error::b.xml", "::error::c.xml", "##[set-output name=x]d.xml", "##vso[task.complete result=Succeeded;]i.xml", "e\r::warning::f.xml", "\x1b[31mg.xml", "\x9b31mj.xml", "%0A::error::h.xml"]


def orders():
    """What CI runners and spreadsheets would obey."""
    folder = fresh("orders")
    for k, name in enumerate(NAMES):
        small_designs.write(folder / name, room="##[set-output name=y]z", name="\u2028::error::name", limit="100" if k % 2 else "90000")
        (folder / f"broken {name}").write_text("<luxgate")
    every = [name for name in NAMES] + [f"broken {name}" for name in NAMES]
    for words in (["check", "--timing", "--explain-cost", "--pictures", "off"], ["check", "--pictures", "off", "--format", "markdown"], ["check", "-q", "--pictures", "off", "--format", "csv"],
                  ["check", "-q", "--pictures", "off", "--format", "json"], ["validate"], ["plan"], ["plan", "--units"]):
        run = luxgate(*words, "--", *every, cwd=folder, code=[2], name=f"orders, {words}")
        for line in (run.stdout + b"\n" + run.stderr).replace(b"\r", b"\n").split(b"\n"):
            expect(not line.lstrip().startswith(b"::") and b"##[" not in line and b"##vso[" not in line and b"\x1b" not in line and b"\xc2\x9b" not in line, f"orders, {words}: {line}")
    (folder / "sheet.xml").write_text(HEAD.format(ies="spot.ies", inside=LAMP, more="").replace('id="r"', 'id="r" name="=HYPERLINK(1)"')
                                      .replace('id="p"', 'id="p" name="@SUM(1)"').replace('at-least="1"', 'at-least="1" clause="-1+cmd|calc!A0;=cmd|x;y"'))
    run = luxgate("check", "sheet.xml", "--pictures", "off", "--format", "csv", cwd=folder, code=[0], name="orders, sheet")
    cells = [cell for row in csv.reader(io.StringIO(run.stdout.decode())) for cell in row]
    bad = [cell for whole in cells for cell in whole.split(";") if cell.startswith(("=", "@", "-1+"))]
    expect(not bad and any("cmd|" in cell for cell in cells), f"orders, sheet: {bad}")
    (folder / "sheet.xml").write_text(HEAD.format(ies="spot.ies", inside=LAMP, more="").replace('id="r"', 'id="r" name="-1 UG"'))
    run = luxgate("check", "sheet.xml", "--pictures", "off", "--format", "csv", cwd=folder, code=[0], name="orders, floor")
    expect("'-1 UG" not in run.stdout.decode(), "orders: the name of a floor is changed")


def streams():
    """Where nothing can be said, results are the same."""
    folder = fresh("streams")
    small_designs.write(folder / "a.xml", far=False)
    small_designs.write(folder / "b.xml", limit="90000")
    (folder / "c.xml").write_text("<luxgate")
    words = [str(PROGRAM), "check", "a.xml", "b.xml", "c.xml", "--pictures", "off", "--format", "csv"]
    usual = subprocess.run(words, cwd=folder, capture_output=True, check=False)
    for name, where in [("closed", "2>&-"), ("full", "2>/dev/full")]:
        run = subprocess.run(["bash", "-c", f'"$@" {where}', "-", *words], cwd=folder, stdout=subprocess.PIPE, timeout=MOST_S, check=False)
        expect(run.returncode == usual.returncode == 2 and run.stdout == usual.stdout, f"streams, {name}: {run.returncode}, another result")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
for attack in (links, floods, ended, orders, streams):
    begin = time.monotonic()
    attack()
    print(f"{time.monotonic() - begin:5.1f} s  {attack.__name__}", flush=True)
print("\n".join(problems))
sys.exit(1 if problems else 0)
