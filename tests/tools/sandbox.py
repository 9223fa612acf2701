"""The program confines itself: to files, to calls of the kernel, on all threads; and nothing else changes by it.

    sandbox.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import ctypes
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import time

import git_repository
import small_designs

PROGRAM, WORK, EXAMPLES = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
MOST_S = 60
PACK = """<rule-pack id="own" edition="1" title="Own" version="1" kind="contract" status="published" licence="internal" role="task">
<parameter id="Em" unit="lx" meaning="maintained average"/>
<grid id="formula" method="formula-power" factor="0.2" base="5" max-spacing="10" ratio="2" count="nearest" trust="confirmed"/>
<plane role="task" orientation="horizontal-up" heights="0 2" grid="formula"/>
<row ref="office" name="office" trust="confirmed"><value of="Em" required="50"/></row>
<check id="Em" role="task" quantity="planar" statistic="average" at-least="row(Em)" trust="confirmed"/>
</rule-pack>"""
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def fresh(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def luxgate(*words, cwd, env=None, **options):
    return subprocess.run([PROGRAM, *words], cwd=cwd, env={**os.environ, **(env or {})}, capture_output=True, timeout=MOST_S, check=False, **options)


def start(*words, cwd, **options):
    return subprocess.Popen([PROGRAM, *words], cwd=cwd, **{"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, **options})


def until(is_so):
    end = time.monotonic() + MOST_S
    while time.monotonic() < end:
        if is_so():
            return True
        time.sleep(0.01)
    return False


def threads(process):
    """Of each thread what the kernel says of it."""
    found = []
    for status in pathlib.Path(f"/proc/{process.pid}/task").glob("*/status"):
        try:
            found.append(dict(line.split(":\t", 1) for line in status.read_text().splitlines() if ":\t" in line))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


def is_stuck_in(process, *calls):
    """Whether its first thread waits in one of these calls."""
    try:
        return pathlib.Path(f"/proc/{process.pid}/syscall").read_text().split()[0] in [str(call) for call in calls]
    except (FileNotFoundError, PermissionError, IndexError):
        return False


def files_of(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def old_kernel():
    """From here on neither Landlock nor seccomp is there, as in a container that forbids both."""
    libc = ctypes.CDLL(None, use_errno=True)
    lines = [(0x20, 0, 0, 0), (0x15, 4, 0, 317), (0x15, 3, 0, 444), (0x15, 2, 0, 445), (0x15, 1, 0, 446), (0x06, 0, 0, 0x7fff0000), (0x06, 0, 0, 0x00050000 | 38)]
    code = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *line) for line in lines))
    program = ctypes.create_string_buffer(struct.pack("HxxxxxxQ", len(lines), ctypes.addressof(code)))
    libc.prctl(38, 1, 0, 0, 0)
    if libc.prctl(22, 2, program, 0, 0) != 0:
        raise OSError("no seccomp")


small = fresh("small")
small_designs.write(small / "p.xml", far=False)
probe = luxgate("validate", "--sandbox", "on", "p.xml", cwd=small)
if b"sandbox-not-possible" in probe.stderr:
    print("skipped: " + probe.stderr.decode())
    sys.exit(0)
expect(probe.returncode == 0, f"validate: {probe.returncode}, {probe.stderr}")


def kernel():
    """All threads are bound while it works, and none without the option."""
    own = {line.split(":")[0]: line.split(":")[1].strip() for line in pathlib.Path("/proc/self/status").read_text().splitlines()}
    outer = int(own.get("Seccomp_filters", "0"))
    office = EXAMPLES / "04-office" / "project.xml"
    for mode, added in [(["--sandbox", "on"], 1), ([], 1), (["--sandbox", "off"], 0)]:
        process = start("check", office, "--pictures", "off", "--goal", "accuracy", "--tolerance", "0.00001", "--max-paths", "1073741824", *mode, cwd=small)
        expect(until(lambda p=process: len(threads(p)) >= 3), f"{mode}: no threads")
        time.sleep(0.5)
        seen = threads(process)
        for thread in seen:
            expect(int(thread["Seccomp_filters"]) == outer + added, f"{mode}: {thread['Name']} has {thread['Seccomp_filters']} filters")
            expect(added == 0 or (thread["Seccomp"] == "2" and thread["NoNewPrivs"] == "1"), f"{mode}: {thread['Name']} is not bound")
        expect(len(seen) >= 3, f"{mode}: {len(seen)} threads")
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=MOST_S)
        expect(process.returncode == 130, f"{mode}: ended with {process.returncode}")


def files_read():
    """A project's folder becomes a link to elsewhere while the one before it is told of: the command line names it, so that no check of ours minds."""
    for mode, code, said in [("off", 0, "b/p.xml: no error"), ("auto", 2, "cannot read 'b/p.xml': Permission denied"), ("on", 2, "Permission denied")]:
        folder = fresh("read")
        small_designs.write(folder / "a" / "p.xml", far=False)
        small_designs.write(folder / "b" / "p.xml", far=False)
        small_designs.write(folder / "elsewhere" / "p.xml", far=False)
        reader, writer = os.pipe()
        os.set_blocking(writer, False)
        filling = 0
        for piece in (4096, 1):
            while True:
                try:
                    filling += os.write(writer, b"x" * piece)
                except BlockingIOError:
                    break
        os.set_blocking(writer, True)
        process = start("validate", "--sandbox", mode, "a/p.xml", "b/p.xml", cwd=folder, stdout=writer)
        os.close(writer)
        expect(until(lambda p=process: is_stuck_in(p, 1)), f"reading, {mode}: it does not wait")
        (folder / "b").rename(folder / "was-b")
        (folder / "b").symlink_to("elsewhere")
        with os.fdopen(reader, "rb") as output:
            text = output.read()[filling:].decode()
        text += process.communicate(timeout=MOST_S)[1].decode()
        expect(process.returncode == code and said in text, f"reading, {mode}: {process.returncode}, {text}")


def files_written():
    """The same with the folder of an output, while another output sleeps until somebody reads."""
    for mode, code, said in [("off", 0, ""), ("auto", 2, "cannot write 'out/x.csv': Permission denied"), ("on", 2, "Permission denied")]:
        folder = fresh("written")
        small_designs.write(folder / "design" / "p.xml", far=False)
        (folder / "out").mkdir()
        (folder / "victim").mkdir()
        os.mkfifo(folder / "pipe")
        process = start("check", "design/p.xml", "--sandbox", mode, "--pictures", "off", "--quiet", "--format", "json=pipe", "--format", "csv=out/x.csv", cwd=folder)
        expect(until(lambda p=process: is_stuck_in(p, 35, 230)), f"writing, {mode}: it does not wait")
        (folder / "out").rename(folder / "was-out")
        (folder / "out").symlink_to("victim")
        expect((folder / "pipe").read_text().startswith("{"), f"writing, {mode}: nothing in the pipe")
        text = process.communicate(timeout=MOST_S)[1].decode()
        expect(process.returncode == code and said in text, f"writing, {mode}: {process.returncode}, {text}")
        expect(bool(files_of(folder / "victim")) == (mode == "off"), f"writing, {mode}: the victim has {list(files_of(folder / 'victim'))}")


def same_bytes():
    """Whatever a run reads and writes, with the sandbox and without."""
    cases = {
        "folder": ["check", "p.xml", "--output", "new/folder", "--images", "--html-split"],
        "formats": ["check", "p.xml", "--pictures", "off", "--format", "html=a/b/x.html", "--format", "markdown=m.md", "--format", "sarif", "--format", "csv=../beside/x.csv"],
        "link": ["check", "p.xml", "--quiet", "--format", "json=link.json"],
        "devices": ["check", "p.xml", "--quiet", "--format", "json=/dev/stdout", "--format", "csv=/dev/null"],
        "store": ["check", "p.xml", "--store", "new/store", "--format", "json"],
        "store again": ["check", "p.xml", "--store", "new/store", "--stored-only", "--format", "json"],
        "resume": ["check", "p.xml", "--output", "resumed", "--resume", "--pictures", "off"],
        "result": ["report", "resumed/result.json", "--format", "html=again/x.html", "--baseline", "link.json"],
        "baseline": ["check", "p.xml", "--pictures", "off", "--baseline", "link.json", "--format", "markdown"],
        "rules": ["check", "rules.xml", "--rules", "packs", "--format", "json"],
        "links": ["check", "linked.xml", "linked/p.xml", "--format", "json"],
        "allowed": ["check", "far.xml", "--allow", "../beside/library", "--format", "json"],
        "not allowed": ["check", "far.xml", "--format", "json"],
        "not there": ["check", "no.xml", "nowhere/no.xml", "--format", "json"],
        "large, to a pipe": ["check", "large.xml", "--pictures", "off", "--max-paths", "256", "--format", "json"],
        "pictures": ["check", "p.xml", "--format", "html"],
        "plan": ["plan", "p.xml", "linked.xml"],
        "validate": ["validate", "p.xml", "rules.xml", "--rules", "packs", "far.xml"],
        "units": ["check", "p.xml", "--store", "shards", "--shard", "1/1"]}
    results = {}
    for mode in ("off", "auto", "on"):
        whole = fresh("bytes")
        caches = {"XDG_CACHE_HOME": str(fresh("caches"))}  # as on a new machine
        folder, beside = whole / "here", whole / "beside"
        beside.mkdir()
        small_designs.write(folder / "p.xml")
        small_designs.write(folder / "large.xml", points=6000)  # more than is kept in memory
        small_designs.write(beside / "library" / "far.xml", far=False)
        small_designs.write(beside / "linked" / "p.xml", far=False)
        (folder / "linked").symlink_to(beside / "linked")
        (folder / "linked.xml").symlink_to(beside / "linked" / "p.xml")
        (folder / "far.ies").symlink_to(beside / "library" / "spot.ies")
        (folder / "far.xml").write_text((folder / "p.xml").read_text().replace("spot.ies", "far.ies"))
        (beside / "target.json").write_text("{}")
        (folder / "link.json").symlink_to(beside / "target.json")
        (folder / "packs").mkdir()
        (beside / "pack.xml").write_text(PACK)
        (folder / "packs" / "own.xml").symlink_to(beside / "pack.xml")
        (folder / "rules.xml").write_text((folder / "p.xml").read_text().replace('<require id="mean"', '<require pack="own" row="office"/><require id="mean"'))
        for name, words in cases.items():
            run = luxgate(*words, "--sandbox", mode, cwd=folder, env=caches)
            results.setdefault(name, []).append((run.returncode, run.stdout, run.stderr))
        results.setdefault("files", []).append(files_of(whole))
        kept = files_of(WORK / "caches" / "luxgate" / "programs") if (WORK / "caches" / "luxgate").exists() else {}
        results.setdefault("compiled shaders", []).append((len([name for name in kept if "/" not in name]), b"", b""))
    for name, runs in results.items():
        for mode, run in zip(("auto", "on"), runs[1:]):
            if name == "files":
                differing = [file for file in {**runs[0], **run} if runs[0].get(file) != run.get(file)]
                expect(not differing, f"{mode}: other bytes in {differing}")
            else:
                expect(run == runs[0], f"{name}, {mode}: {runs[0][0]} became {run[0]}: {run[2][-600:]} instead of {runs[0][2][-600:]}")
    for name, said in [("not allowed", b"file-link-outside"), ("rules", b'"pack": "own:1"'), ("devices", b"{"), ("store again", b"{")]:
        code, out, err = results[name][2]
        expect(said in out + err, f"{name}: {code}, {err}")
    expect(len(results["large, to a pipe"][2][1]) > 1 << 21, "too little to be a large report")


def repositories():
    """--against: objects, settings and Git LFS lie where the repository says."""
    whole = fresh("repositories")
    variables = git_repository.environment(whole / "home")
    (whole / "home" / "own").write_text("[core]\n\tattributesfile = ~/attributes\n")
    (whole / "home" / "attributes").write_text("*.none text\n")
    (whole / "home" / ".gitconfig").write_text("[include]\n\tpath = own\n[includeIf \"gitdir:/\"]\n\tpath = ~/own\n")
    lender = git_repository.Repository(whole / "lender", variables)
    small_designs.write(lender.folder / "designs" / "p.xml", limit="120")
    lender.commit()
    lender.git("clone", "-q", "--shared", lender.folder, whole / "borrower")
    lender.git("clone", "-q", "--reference", whole / "borrower", lender.folder, whole / "second")
    lender.git("worktree", "add", "-q", "-b", "topic", whole / "linked")
    (whole / "outside").mkdir()
    lender.git("clone", "-q", f"--separate-git-dir={whole / 'outside' / 'git'}", lender.folder, whole / "apart")
    for name in ("lender", "borrower", "second", "linked", "apart"):
        folder = whole / name
        small_designs.write(folder / "designs" / "p.xml", limit="100")
        runs = [luxgate("check", "p.xml", "--against", "HEAD", "--format", "json", "--sandbox", mode, cwd=folder / "designs", env=variables) for mode in ("off", "on")]
        same = [(run.returncode, run.stdout, run.stderr) for run in runs]
        expect(same[0] == same[1] and b'"revision"' in same[0][1], f"repository '{name}': {same[0][0]} became {same[1][0]}: {same[1][2]} instead of {same[0][2]}")


def without_kernel():
    """Where the kernel has neither: auto goes on, on says so."""
    usual = luxgate("check", "p.xml", "--format", "json", "--pictures", "off", cwd=small)
    run = luxgate("check", "p.xml", "--format", "json", "--pictures", "off", cwd=small, preexec_fn=old_kernel)
    expect((run.returncode, run.stdout, run.stderr) == (usual.returncode, usual.stdout, usual.stderr), f"auto, old kernel: {run.returncode}, {run.stderr}")
    (small / "r.json").write_bytes(usual.stdout)
    for words in (["check", "p.xml"], ["validate", "p.xml"], ["plan", "p.xml"], ["report", "r.json"]):
        run = luxgate(*words, "--sandbox", "on", cwd=small, preexec_fn=old_kernel)
        expect(run.returncode == 2 and b"error[sandbox-not-possible]" in run.stderr and not run.stdout, f"on, old kernel, {words}: {run.returncode}, {run.stderr}")
    run = luxgate("check", "p.xml", "--sandbox", "yes", cwd=small)
    expect(run.returncode == 2 and b"auto" in run.stderr, f"a wrong word: {run.returncode}, {run.stderr}")


for part in (kernel, files_read, files_written, same_bytes, repositories, without_kernel):
    part()
print("\n".join(problems))
sys.exit(1 if problems else 0)
