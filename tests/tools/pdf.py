"""--format pdf: what Chromium prints is the same twice, on the paper that was asked for, whole or not at all; and nothing stays behind.

    pdf.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import small_designs

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = pathlib.Path(sys.argv[3]).resolve()
MOST_S = 120
CHROMIUM = next((path for path in map(shutil.which, ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]) if path), None)
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


shutil.rmtree(WORK, ignore_errors=True)
TEMPORARY = WORK / ("temporary" + 100 * "y")  # longer than the path of a socket may be: Chromium makes one
TEMPORARY.mkdir(parents=True)
small_designs.write(WORK / "p.xml", name="Hall &quot;A&quot; \\ &lt;/style&gt;", far=False)


def luxgate(*words, **env):
    return subprocess.run([PROGRAM, *words, "--pictures", "off"] if words[0] == "check" else [PROGRAM, *words], cwd=WORK, env={**os.environ, "TMPDIR": str(TEMPORARY), **env},
                          capture_output=True, timeout=MOST_S, check=False)


def fake(name, lines):
    path = WORK / name
    path.write_text("#!/bin/sh\n" + lines)
    path.chmod(0o755)
    return str(path)


def until(is_so):
    end = time.monotonic() + MOST_S
    while time.monotonic() < end:
        if is_so():
            return True
        time.sleep(0.02)
    return False


def bytes_of(name):
    """b"" = there is no such file; what was expected of it tells so."""
    path = WORK / name
    return path.read_bytes() if path.exists() else b""


def is_clean(words):
    expect(until(lambda: not any(TEMPORARY.iterdir())), f"{words}: {[path.name for path in TEMPORARY.iterdir()]} stay in TMPDIR")
    expect(not list(WORK.glob(".*")), f"{words}: something stays beside the report")


def without_chromium():
    """It is told before anything is done, and what to do."""
    for env, said in [({"PATH": "/nowhere"}, b"apt install chromium"), ({"LUXGATE_CHROMIUM": "/nowhere/chromium"}, b"LUXGATE_CHROMIUM is '/nowhere/chromium'")]:
        done = luxgate("check", "none.xml", "--format", "pdf=none.pdf", "--format", "html=none.html", **env)
        expect(done.returncode == 2 and b"error[pdf-not-possible]" in done.stderr and said in done.stderr, f"no Chromium: {done.returncode}, {done.stderr}")
        expect(done.stderr.count(b"\n") == 1 and not (WORK / "none.html").exists(), f"no Chromium, but work: {done.stderr}")
    expect(luxgate("check", "p.xml", "--format", "html=a.html", PATH="/nowhere").returncode == 0, "HTML needs Chromium")


def failures():
    """A printer that fails leaves no PDF; the other reports are there."""
    for name, lines, said in [("ends", "echo 'no memory for \033[1mthat' >&2; exit 3", b"it ended with code 3: no memory for  [1mthat"),
                              ("dies", "kill -9 $$", b"it ended by signal 9"),
                              ("fatal", "printf 'no bus\\n[1:FATAL:x.cc] no room\\nno bus again\\n' >&2; kill -6 $$", b"it ended by signal 6: [1:FATAL:x.cc] no room"),
                              ("nothing", "exit 0", b"it made no PDF"),
                              ("other", "for word; do case $word in --print-to-pdf=*) echo hello > ${word#*=};; esac; done", b"it made no PDF")]:
        done = luxgate("check", "p.xml", "--format", f"pdf={name}.pdf", "--format", f"html={name}.html", LUXGATE_CHROMIUM=fake(name, lines))
        expect(done.returncode == 2 and b"cannot write '" + name.encode() + b".pdf': Chromium did not print it: " + said in done.stderr, f"{name}: {done.returncode}, {done.stderr}")
        expect(not (WORK / f"{name}.pdf").exists() and (WORK / f"{name}.html").exists(), f"{name}: files are wrong")
        is_clean(name)


def what_it_gets():
    """No network, nothing of the user's, a page that is there."""
    lines = f"""for word; do echo "$word"; case $word in --print-to-pdf=*) pdf=${{word#*=}};; file://*) page=${{word#file://}};; esac; done > {WORK}/words
env > {WORK}/env
cp "$page" {WORK}/page.html
printf '%%PDF-1.4 /CreationDate (D:20261125141516+00' > "$pdf"
"""
    done = luxgate("check", "p.xml", "--format", "pdf=fake.pdf", "--format", "html=fake.html", "--detail", "client", LUXGATE_CHROMIUM=fake("printer", lines), SECRET="12345")
    expect(done.returncode == 0, f"fake: {done.stderr}")
    expect(bytes_of("fake.pdf") == b"%PDF-1.4 /CreationDate (D:20000101000000+00", f"fake: {bytes_of('fake.pdf')}")
    expect(bytes_of("page.html") == bytes_of("fake.html"), "the page that is printed is another")
    words = (WORK / "words").read_text().splitlines()
    for word in ["--headless", "--host-resolver-rules=MAP * ~NOTFOUND", "--no-pdf-header-footer", "--generate-pdf-document-outline"]:
        expect(word in words, f"Chromium does not get {word}")
    expect(("--no-sandbox" in words) or os.geteuid() != 0, "root gets a sandbox that Chromium refuses")
    expect("12345" not in (WORK / "env").read_text() and f"HOME={TEMPORARY}/" in (WORK / "env").read_text(), "Chromium gets the user's surroundings")
    is_clean("fake")


def kills():
    """Who kills luxgate while it prints has nothing left running, and nothing left."""
    printer = fake("sleeper", f"echo $$ > {WORK}/pid; sleep 1000")
    for signal_name in ["KILL", "INT"]:
        (WORK / "pid").unlink(missing_ok=True)
        process = subprocess.Popen([PROGRAM, "check", "p.xml", "--pictures", "off", "--format", "pdf=k.pdf"], cwd=WORK, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True,
                                   env={**os.environ, "TMPDIR": str(TEMPORARY), "LUXGATE_CHROMIUM": printer})
        expect(until(lambda: (WORK / "pid").exists() and (WORK / "pid").read_text().strip()), f"{signal_name}: nothing is printed")
        pid = (WORK / "pid").read_text().strip()
        for _ in range(2):  # the second one ends it at once
            subprocess.run(["kill", f"-{signal_name}", "--", f"-{process.pid}"] if signal_name == "INT" else ["kill", "-KILL", str(process.pid)], check=False, stderr=subprocess.DEVNULL)
            time.sleep(0.2)
        process.communicate(timeout=MOST_S)  # readers of its streams are not kept waiting
        expect(until(lambda p=pid: not pathlib.Path(f"/proc/{p}").exists()), f"{signal_name}: Chromium goes on")
        expect(not (WORK / "k.pdf").exists(), f"{signal_name}: a PDF")
        for left in WORK.glob(".k.pdf.*"):  # the next run would do that
            left.unlink()
        is_clean(signal_name)


def pages(file):
    return bytes_of(file).count(b"/Type /Page\n")


def prints():
    """The real one."""
    done = luxgate("check", "p.xml", "--format", "pdf=a.pdf", "--format", "json=a.json", "--set", "about.revision=\"';}\\x</style>", "--sandbox", "auto")
    expect(done.returncode == 0 and b"error" not in done.stderr, f"check: {done.returncode}, {done.stderr}")
    is_clean("check")
    pdf = bytes_of("a.pdf")
    expect(pdf.startswith(b"%PDF-") and pdf.rstrip().endswith(b"%%EOF"), "a.pdf is no PDF")
    expect(b"/CreationDate (D:20000101000000" in pdf and b"/ModDate (D:20000101000000" in pdf, "a.pdf tells the time")
    for word in [b"/StructTreeRoot", b"/Outlines", b"/Lang (en)", b"/MediaBox [0 0 594"]:
        expect(word in pdf, f"a.pdf has no {word}")
    # The cover, the room with its drawing and plane, the chapters, how to read it and provenance.
    expect(0 < pages("a.pdf") <= 5, f"a.pdf: {pages('a.pdf')} pages")
    for words, name in [(["--sandbox", "off"], "sandbox off"), ([], "again")]:
        luxgate("check", "p.xml", "--format", "pdf=b.pdf", "--set", "about.revision=\"';}\\x</style>", *words)
        expect(bytes_of("b.pdf") == pdf, f"{name}: other bytes")
    done = luxgate("report", "a.json", "--format", "pdf=c.pdf")
    expect(done.returncode == 0 and bytes_of("c.pdf") == pdf, f"report: {done.returncode}, {done.stderr}, or other bytes")
    done = luxgate("report", "a.json", "--format", "pdf", "--language", "de", "--paper", "letter")
    expect(b"/MediaBox [0 0 612 792]" in done.stdout and b"/Lang (de)" in done.stdout, f"letter, German: {done.stderr}")
    if pdf and shutil.which("pdftotext"):
        text = subprocess.run(["pdftotext", WORK / "a.pdf", "-"], capture_output=True, check=True).stdout.decode()
        for words in ["Hall \"A\" \\ </style> · Revision \"';}\\x</style>", f"Page 2 / {pages('a.pdf')}", "How to read this report"]:
            expect(words in text, f"a.pdf does not say {words!r}")
        luxgate("check", "p.xml", "--format", "pdf=cover.pdf", "--cover", "always", "--set", "about.client=Anna")
        text = subprocess.run(["pdftotext", WORK / "cover.pdf", "-"], capture_output=True, check=True).stdout.decode()
        first, *others = text.split("\f")
        expect("Anna" in first and "Contents" not in first and "Page " not in first, f"cover.pdf begins with {first!r}")
        expect("Contents" in others[0] and f"Page 2 / {pages('cover.pdf')}" in others[0], f"cover.pdf goes on with {others[0]!r}")


def contents():
    """Contents name pages: what Chromium prints tells them, so it is asked twice for more than four pages."""
    calls = WORK / "calls"
    counting = fake("counting", f"echo >> '{calls}'\nexec '{CHROMIUM}' \"$@\"\n")
    for project, is_long in [("01-one-luminaire", False), ("04-office", True)]:
        calls.write_text("")
        done = luxgate("check", EXAMPLES / project / "project.xml", "--annex", "never", "--format", "pdf=n.pdf", LUXGATE_CHROMIUM=counting)
        prints = len(calls.read_text())
        expect(done.returncode in (0, 1) and (pages("n.pdf") > 4) == is_long, f"{project}: {done.returncode}, {pages('n.pdf')} pages, {done.stderr}")
        expect(prints == (2 if is_long else 1), f"{project} is printed {prints} times")


def many_planes():
    """40 planes in five rooms come in 15 pages, on letter, which is lower, in 20."""
    rooms = ""
    for r in range(5):
        planes = "".join(f'<plane id="r{r}p{k}" name="Task {k}" origin="{0.4 + 1.4 * (k % 4)} {0.5 + 1.8 * (k // 4)} 0.75" u="1.2 0 0" v="0 1.4 0" count="6 7">'
                         '<require id="mean" quantity="average" at-least="100"/><require id="even" quantity="Uo" at-least="0.1"/></plane>' for k in range(8))
        rooms += (f'<room id="r{r}" name="Office {r}" origin="{10 * r} 0 0" size="6 4 2.8" ceiling="light" walls="light" floor="dark">'
                  f'<luminaire-grid id="L{r}" type="spot" origin="0 0 2.79" size="6 4" columns="3" rows="2"/>{planes}</room>')
    (WORK / "many.xml").write_text('<luxgate version="1" name="Forty planes" maintenance-factor="0.8"><material id="light" reflectance="0.7"/>'
                                   f'<material id="dark" reflectance="0.3"/><luminaire-type id="spot" photometry="spot.ies"/>{rooms}</luxgate>')
    done = luxgate("check", "many.xml", "--format", "json=many.json")
    expect(done.returncode in (0, 1), f"many: {done.returncode}, {done.stderr}")
    for paper, most in [("a4", 15), ("letter", 20)]:
        luxgate("report", "many.json", "--paper", paper, "--format", "pdf=many.pdf")
        expect(0 < pages("many.pdf") <= most, f"40 planes take {pages('many.pdf')} pages on {paper}")


def used_shares(file):
    """How far down each page is printed on, 0 to 1, without its head and foot."""
    picture = subprocess.run(["pdftoppm", "-r", "20", "-gray", WORK / file], capture_output=True, check=True).stdout
    shares = []
    while picture:
        head = re.match(rb"P5\s+(\d+)\s+(\d+)\s+255\s", picture)
        width, height = int(head[1]), int(head[2])
        pixels, picture = picture[head.end():head.end() + width * height], picture[head.end() + width * height:]
        first, last = height * 13 // 297, height * 282 // 297
        printed = [y for y in range(first, last) if min(pixels[y * width:(y + 1) * width]) < 235]
        shares.append((max(printed, default=first) - first) / (last - first))
    return shares


def texts_and_chapters(file):
    """Characters by size of type in points, and the pages on which chapters begin."""
    zoom = 3  # the most there is; sizes are whole numbers
    xml = subprocess.run(["pdftohtml", "-xml", "-i", "-stdout", "-hidden", "-zoom", str(zoom), WORK / file], capture_output=True, check=True).stdout.decode()
    size_of = {font: float(size) / zoom for font, size in re.findall(r'<fontspec id="(\d+)" size="([-\d.]+)"', xml)}
    sizes = collections.Counter()
    for font, text in re.findall(r'<text [^>]*font="(\d+)">(.*?)</text>', xml, re.DOTALL):
        sizes[size_of[font]] += len(re.sub("<[^>]*>", "", text).strip())
    return sizes, {int(page) for page in re.findall(r'<item page="(\d+)">', xml)}


def client_document():
    """What people send has no small type, few pages, and no page that ends early but at the end of a chapter."""
    if not all(map(shutil.which, ["pdftoppm", "pdftohtml"])):
        print("skipped: pages and type of the client's document, since there is no pdftoppm or pdftohtml")
        return
    for project, most in [("11-classroom", 12), ("17-storey", 20), ("19-school-tender", 18)]:
        done = luxgate("check", EXAMPLES / project / "project.xml", "--format", f"json={project}.json")
        expect(done.returncode in (0, 1), f"{project}: {done.returncode}, {done.stderr}")
        for language in ["en", "de"]:
            file = f"{project}-{language}.pdf"
            luxgate("report", f"{project}.json", "--language", language, "--format", f"pdf={file}")
            expect(0 < pages(file) <= most, f"{file}: {pages(file)} pages")
            sizes, chapters = texts_and_chapters(file)
            everything = sum(sizes.values())
            expect(everything > 2000 and min(sizes) >= 6, f"{file}: type of {min(sizes, default=0)} points")
            small = sum(count for size, count in sizes.items() if size < 7.3)
            expect(small < 0.15 * everything, f"{file}: {small} of {everything} characters are smaller than 7.3 points")
            shares = used_shares(file)
            early = [page for page, share in enumerate(shares, 1) if share < 0.66 and page < len(shares) and page + 1 not in chapters]
            expect(not early, f"{file}: pages {early} end early")


def data_sheet():
    """Of photometry: one page, the same bytes twice, and without Chromium an error that leaves nothing."""
    done = luxgate("photometry", "spot.ies", "--sheet", "none.pdf", PATH="/nowhere")
    expect(done.returncode == 2 and b"error[pdf-not-possible]" in done.stderr and not (WORK / "none.pdf").exists(), f"sheet without Chromium: {done.returncode}, {done.stderr}")
    done = luxgate("photometry", "spot.ies", "--sheet", "spot.pdf", LUXGATE_CHROMIUM=fake("ends", "exit 3"))
    expect(done.returncode == 2 and b"cannot write 'spot.pdf'" in done.stderr and not (WORK / "spot.pdf").exists(), f"a printer that fails: {done.returncode}, {done.stderr}")
    is_clean("sheet")
    if CHROMIUM is None:
        return
    sheets = []
    for paper in ["a4", "letter", "a4"]:
        done = luxgate("photometry", EXAMPLES / "photometry/batwing_1200.ies", "--sheet", "sheet.pdf", "--paper", paper)
        expect(done.returncode == 0 and pages("sheet.pdf") == 1, f"sheet on {paper}: {done.returncode}, {pages('sheet.pdf')} pages, {done.stderr}")
        sheets.append(bytes_of("sheet.pdf"))
    expect(sheets[0] == sheets[2] and sheets[0] != sheets[1] and b"/CreationDate (D:20000101000000" in sheets[0], "the sheet hangs on the time")


without_chromium()
failures()
what_it_gets()
data_sheet()
kills()
if CHROMIUM is None:
    print("\n".join(problems) if problems else "skipped: the printing itself, since there is no Chromium")
else:
    prints()
    contents()
    many_planes()
    client_document()
    print("\n".join(problems))
sys.exit(1 if problems else 0)
