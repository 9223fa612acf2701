"""A batch of many designs: its memory must not grow with it, and whatever ends it, no half report may stay behind.

    streamed_reports.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
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
FORMATS = ["text", "csv", "points-csv", "json", "html", "junit", "sarif", "sarif-all", "github", "gitlab", "markdown", "xlsx"]
FAST = ["--quiet", "--pictures", "off", "--max-paths", "64", "--jobs", "1"]
problems = []


def designs(count, **changes):
    """Of different names, in one folder: files that they share are read once and listed once."""
    folder = WORK / f"designs-{count}"
    return [small_designs.write(folder / f"{k:04}.xml", name=f"Design {k}", **changes) for k in range(count)]


def formats(out, which=FORMATS):
    return [word for name in which for word in ("--format", f"{name}={out}/x.{name}")]


def names(folder):
    return sorted(path.name for path in folder.rglob("*")) if folder.exists() else []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def peak_kib(projects):
    """Of the program alone; also how much it wrote."""
    out = WORK / "memory"
    shutil.rmtree(out, ignore_errors=True)
    process = subprocess.Popen([PROGRAM, "check", *FAST, *formats(out), *projects], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    expect(process.returncode == 1, f"{len(projects)} designs: exit code {process.returncode}, expected 1")
    return usage.ru_maxrss, sum((out / f"x.{name}").stat().st_size for name in FORMATS) // 1024


def memory_is_flat():
    """What is left of a design are its path, its counts and the fingerprints of its findings: 3 KiB in 4000 designs, with all
    formats at once. Up to 1 MiB of each part of each format waits in memory, and not all of them are full after 300 designs: that
    is 6 KiB for each of the next 600. The results themselves, kept until the end, are beyond 100 KiB."""
    few, _ = peak_kib(designs(300, points=30))
    many, written = peak_kib(designs(900, points=30))
    grown = (many - few) / 600
    print(f"300 designs: {few} KiB, 900: {many} KiB; {grown:.1f} KiB for each more, which writes {written / 900:.0f} KiB")
    expect(written / 900 > 100, f"{written / 900:.0f} KiB written for a design are too little to tell anything")
    expect(grown < 16, f"the memory grows by {grown:.1f} KiB for each design")


def full_disk():
    """A file may have 2 MiB: some formats fail, and say so; others are whole; nothing else is there."""
    limit = 2 << 20
    projects = designs(60, points=30)
    whole, out = WORK / "whole", WORK / "full"
    subprocess.run([PROGRAM, "check", *FAST, *formats(whole), *projects], stdout=subprocess.DEVNULL, check=False)
    out.mkdir()
    (out / "x.json").write_text("an older result")
    # Python ignores SIGXFSZ, and so does then the program: a write fails as on a full disk.
    run = subprocess.run([PROGRAM, "check", *FAST, *formats(out), *projects], capture_output=True, text=True, restore_signals=False,
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)), check=False)
    expect(run.returncode == 2, f"full disk: exit code {run.returncode}, expected 2")
    failed = []
    for name in FORMATS:
        wanted = (whole / f"x.{name}").read_bytes().replace(b"/whole/", b"/full/")
        written = out / f"x.{name}"
        if len(wanted) > limit:
            failed.append(name)
            expect(f"cannot write '{written}': File too large" in run.stderr, f"full disk: nothing is said of {name}: {run.stderr}")
            expect(not written.exists() or written.read_text() == "an older result", f"full disk: there is half of {name}")
        else:
            expect(written.exists() and written.read_bytes() == wanted, f"full disk: {name} had room and is not there")
    expect("json" in failed and "csv" not in failed, f"full disk: {failed} are not some of the formats")
    expect((out / "x.json").read_text() == "an older result", "full disk: an older result is gone")
    expect(names(out) == sorted(f"x.{name}" for name in FORMATS if name not in failed or name == "json"),
           f"full disk: {names(out)} stay behind")
    with open("/dev/full", "w", encoding="utf-8") as full:
        run = subprocess.run([PROGRAM, "check", *FAST, "--format", "json", *projects], stdout=full, stderr=subprocess.PIPE, text=True,
                             check=False)
    expect(run.returncode == 2 and "cannot write to standard output" in run.stderr, f"/dev/full: {run.returncode}, {run.stderr}")


def ended(signal_number):
    """In the middle of a batch, when some of it waits in files."""
    out = WORK / f"ended-{signal_number}"
    temporary = WORK / f"tmp-{signal_number}"
    out.mkdir()
    temporary.mkdir()
    process = subprocess.Popen([PROGRAM, "check", *FAST, *formats(out), "--format", "json", *designs(900, points=30)],
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env={**os.environ, "TMPDIR": str(temporary)})

    def open_files():
        """Of the program, as far as they are still open when they are looked at."""
        folder, found = f"/proc/{process.pid}/fd", []
        try:
            for name in os.listdir(folder):
                try:
                    found.append(os.readlink(f"{folder}/{name}"))
                except OSError:  # closed since the list was made: that one alone, the program goes on
                    pass
        except OSError:  # the program has ended
            pass
        return found

    end = time.monotonic() + 60
    is_waiting = False
    while not is_waiting and time.monotonic() < end and process.poll() is None:
        links = open_files()
        is_waiting = all(any(link.startswith(str(folder)) for link in links) for folder in (out, temporary))
        time.sleep(0 if is_waiting else 0.01)
    expect(is_waiting, f"signal {signal_number}: nothing ever waits in files of {out} and {temporary}")
    process.send_signal(signal_number)
    printed = process.communicate()[0]
    expect(process.returncode != 1, f"signal {signal_number} came too late")
    expect(not names(out) and not names(temporary), f"signal {signal_number}: {names(out) + names(temporary)} stay behind")
    expect(not printed, f"signal {signal_number}: {len(printed)} bytes on standard output")


def input_among_images():
    """A later design has the picture of an earlier one for its photometry: whether or not it is overwritten, it is told."""
    folder = WORK / "among"
    first = small_designs.write(folder / "a.xml", name="A")
    small_designs.write(folder / "b.xml", name="B")
    photometry = folder / "a-room.desk.svg"
    shutil.copy(folder / "spot.ies", photometry)
    (folder / "b.xml").write_text((folder / "b.xml").read_text().replace("spot.ies", photometry.name))
    plane = [path for path in images(folder, first) if path.endswith(".svg")]
    expect(plane, "no image is written at all")
    photometry.rename(folder / pathlib.Path(plane[0]).name)
    (folder / "b.xml").write_text((folder / "b.xml").read_text().replace(photometry.name, pathlib.Path(plane[0]).name))
    run = subprocess.run([PROGRAM, "check", *FAST, "--output", folder, "--images", first, folder / "b.xml"], capture_output=True,
                         text=True, check=False)
    expect(run.returncode == 2 and "was read as an input after it had been overwritten" in run.stderr,
           f"an input among the images: {run.returncode}, {run.stderr}")


def images(folder, project):
    out = folder / "first"
    subprocess.run([PROGRAM, "check", *FAST, "--output", out, "--images", project], capture_output=True, check=False)
    return names(out)


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
memory_is_flat()
full_disk()
ended(signal.SIGKILL)
ended(signal.SIGTERM)
input_among_images()
print("\n".join(problems))
sys.exit(1 if problems else 0)
