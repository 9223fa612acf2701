"""Batches of `luxgate submit` by real engines: the bytes of one machine, whatever happens to shards on the way.

    batch_engines.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew

bash is always there; GNU parallel and Slurm are tried where they are installed.
"""
import contextlib
import heapq
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import threading
import time

import private_slurm
import small_designs

PROGRAM, WORK, EXAMPLES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
FORMATS = ["json", "csv", "html"]
PATIENCE_S = 90
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


class Batch:
    """Designs in a folder with a blank in its name, and what one machine says of them."""

    def __init__(self, name, count, *options):
        self.folder, self.options = WORK / name, ["--pictures", "off", "--quiet", "--seed", "3", *options]
        self.designs = [pathlib.Path(small_designs.write(self.folder / f"design {k:02}.xml", name=f"Design {k}", columns=2 + k % 3,
                                                         points=6 + k % 5)).name for k in range(count)]
        run = subprocess.run([PROGRAM, "check", *self.designs, *self.options, *formats(self.folder / "one")], cwd=self.folder,
                             capture_output=True, text=True, check=False)
        expect(run.returncode == 1, f"{name}: one machine ends with {run.returncode}: {run.stderr}")

    def submit(self, engine, case, shards, *more, store=None):
        out = self.folder / f"{engine} {case}"
        wait = ["--wait"] if engine == "slurm" else []
        return [PROGRAM, "submit", "--engine", engine, *self.designs, *self.options, "--store", store or f"{out}/looks", "--job-folder",
                f"{out}/job", "--shards", str(shards), "--send", *wait, *formats(out), *more]

    def start(self, command, environment):
        return subprocess.Popen(command, cwd=self.folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def expect_same(self, engine, case, process, words=""):
        _, messages = process.communicate(timeout=PATIENCE_S)
        what = f"{engine}, {case}{words}"
        expect(process.returncode == 1, f"{what}: exit code {process.returncode}, expected 1: {messages}")
        for name in FORMATS:
            written, wanted = self.folder / f"{engine} {case}" / f"x.{name}", self.folder / "one" / f"x.{name}"
            expect(written.exists() and written.read_bytes() == wanted.read_bytes(), f"{what}: {name} is not that of one machine")


def formats(out):
    return [word for name in FORMATS for word in ("--format", f"{name}={out}/x.{name}")]


def units_of_shard(job, count, wanted):
    """By name, as the program shares them out: the costliest first, each to the shard that has least."""
    units = json.loads((job / "units.json").read_text())["units"]
    least, names = [(0.0, shard) for shard in range(count)], set()
    for unit in sorted(units, key=lambda unit: -unit["first_look_s"]):
        seconds, shard = heapq.heappop(least)
        heapq.heappush(least, (seconds + unit["first_look_s"], shard))
        if shard + 1 == wanted:
            names.add(f"{unit['project']}: {unit['space']}")
    return names


def missing_units(messages):
    names = {f"{line.split(': room', 1)[0]}: room" for line in messages.replace("'", "").split(", ") if ": room" in line}
    return {name[name.index("design"):] for name in names if "design" in name}


def same_bytes(batch, engine, environment):
    """In 1, 2 and 4 shards, and two batches with one store: all five at once."""
    store = batch.folder / f"{engine} shared looks"
    cases = [("1 shard", 1, None), ("2 shards", 2, None), ("4 shards", 4, None), ("first of two", 2, store), ("second of two", 3, store)]
    started = [(case, batch.start(batch.submit(engine, case, shards, store=one), environment)) for case, shards, one in cases]
    for case, process in started:
        batch.expect_same(engine, case, process)


def left_out(batch):
    """The closing job names exactly what no shard has done."""
    case, shards = "left out", 3
    job = batch.folder / f"local {case}" / "job"
    command = [word for word in batch.submit("local", case, shards) if word != "--send"]
    printed = subprocess.run(command, cwd=batch.folder, capture_output=True, text=True, check=False)
    expect(printed.returncode == 0, f"submit: exit code {printed.returncode}: {printed.stderr}")
    expect(printed.stdout == (job / "job.sh").read_text(), "submit prints another script than it writes")
    for shard in (1, 3):
        run = subprocess.run(["bash", job / "job.sh", "shard", str(shard)], capture_output=True, text=True, check=False)
        expect(run.returncode == 0, f"shard {shard}: exit code {run.returncode}: {run.stderr}")
    run = subprocess.run(["bash", job / "job.sh", "close"], capture_output=True, text=True, check=False)
    expect(run.returncode == 2, f"left out: exit code {run.returncode}, expected 2")
    wanted, named = units_of_shard(job, shards, 2), missing_units(run.stderr)
    expect(wanted and named == wanted, f"left out: {sorted(named)} are named, {sorted(wanted)} are missing: {run.stderr}")
    batch.expect_same("local", case, batch.start(batch.submit("local", case, shards), None), ", submitted again")


class Killer(threading.Thread):
    """Ends the luxgate process of a shard of this job, a random time after it began."""

    def __init__(self, job, shard):
        super().__init__(daemon=True)
        self.job, self.shard, self.has_killed = str(job), shard, False
        self.start()

    def run(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            for entry in pathlib.Path("/proc").iterdir():
                if not entry.name.isdigit():
                    continue
                with contextlib.suppress(OSError):
                    words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                    if words[0] == str(PROGRAM) and self.shard in words and f"{self.job}/units.json" in words:
                        time.sleep(random.random() * 0.2)
                        os.kill(int(entry.name), signal.SIGKILL)
                        self.has_killed = True
                        return
            time.sleep(0.005)


def killed(batch, engine, environment):
    """A shard at random; the same once more completes it, GNU parallel with that shard alone."""
    case, shards = "killed", 3
    job = batch.folder / f"{engine} {case}" / "job"
    victim = random.randint(1, shards)
    killer = Killer(job, f"{victim}/{shards}")
    process = batch.start(batch.submit(engine, case, shards), environment)
    _, messages = process.communicate(timeout=PATIENCE_S)
    killer.join(1)
    expect(killer.has_killed, f"{engine}, killed: shard {victim} was never there")
    expect(process.returncode == 2, f"{engine}, killed: exit code {process.returncode}, expected 2: {messages}")
    named = missing_units(messages)
    expect(named and named <= units_of_shard(job, shards, victim), f"{engine}, killed: {sorted(named)} are named: {messages}")
    again = batch.submit(engine, case, shards)
    if engine == "parallel":
        again = ["bash", job / "job.sh"]
    batch.expect_same(engine, case, batch.start(again, environment), ", again")
    if engine == "parallel":
        rows = [line.split("\t") for line in (job / "joblog").read_text().splitlines()[1:]]
        redone = [row[0] for row in rows].count(str(victim))
        expect(len(rows) == shards + 1 and redone == 2, f"parallel: shards other than {victim} ran twice: {rows}")


def cancelled(batch, slurm):
    """scancel of a shard that waits: the closing job comes all the same."""
    case, shards = "cancelled", 2
    job = batch.folder / f"slurm {case}" / "job"
    process = batch.start(batch.submit("slurm", case, shards, "--at-once", "1"), slurm.environment)
    array = next((line.split()[-1] for line in process.stderr if line.startswith("shards: job ")), "")
    slurm.run("scancel", f"{array}_{shards}")
    _, messages = process.communicate(timeout=PATIENCE_S)
    expect(process.returncode == 2, f"slurm, cancelled: exit code {process.returncode}, expected 2: {messages}")
    wanted, named = units_of_shard(job, shards, shards), missing_units(messages)
    expect(wanted == named, f"slurm, cancelled: {sorted(named)} are named, {sorted(wanted)} are missing: {messages}")
    store = batch.folder / f"slurm {case}" / "looks"
    batch.expect_same("local", case, batch.start(batch.submit("local", case, shards, store=store), None), ", what Slurm left")


def by_hand(batch, engine, environment):
    """The scripts in examples/batch."""
    folder, commands = batch.folder / f"{engine} by hand", batch.folder / "commands"
    folder.mkdir()
    commands.mkdir(exist_ok=True)
    if not (commands / "luxgate").exists():
        (commands / "luxgate").symlink_to(PROGRAM)
    environment = {**(environment or os.environ), "STORE": str(folder / "looks"), "WAIT": "1"}
    environment["PATH"] = f"{commands}:{environment['PATH']}"
    designs = [f"../{name}" for name in batch.designs]
    one = subprocess.run([PROGRAM, "check", *designs, "--seed", "1", *formats(folder)], cwd=folder, capture_output=True, check=False)
    run = subprocess.run(["bash", EXAMPLES / "batch" / f"{engine}.sh", *designs], cwd=folder, env=environment, capture_output=True,
                         text=True, timeout=PATIENCE_S, check=False)
    expect(run.returncode == one.returncode == 1, f"{engine} by hand: exit code {run.returncode}, expected 1: {run.stderr}")
    for name in FORMATS:
        written = folder / f"batch.{name}"
        expect(written.exists() and written.read_bytes() == (folder / f"x.{name}").read_bytes(),
               f"{engine} by hand: {name} is not that of one machine")


def refused(batch):
    """What is wrong is said before anything is sent."""
    for words, message in [([], "--store is needed"), (["--store", "off"], "--store: a batch needs one"),
                           (["--store", "s", "--wait"], "--wait needs --send"),
                           (["--store", "s", "--shard", "1/2"], "not expected: --shard"),
                           (["--store", "s", "--format", "csv", "--format", "json"], "only one kind can go to standard output"),
                           (["--store", "s", "gone.xml"], "no job is made")]:
        run = subprocess.run([PROGRAM, "submit", "--engine", "local", batch.designs[0], *words], cwd=batch.folder, capture_output=True,
                             text=True, env={**os.environ, "LUXGATE_STORE": ""}, check=False)
        expect(run.returncode == 2 and message in run.stderr and not run.stdout, f"{words}: {run.returncode}, {run.stderr}")
    expect(not (batch.folder / "s").exists() and not (batch.folder / "s-job").exists(), "a refused batch has left something")


def timed(name, work, *arguments):
    begin = time.monotonic()
    try:
        work(*arguments)
    except Exception as error:  # in a thread it would be lost
        problems.append(f"{name}: {error!r}")
    print(f"{time.monotonic() - begin:5.1f} s  {name}", flush=True)


seed = int(os.environ.get("LUXGATE_TEST_SEED", "0")) or random.SystemRandom().randrange(1, 1 << 30)
random.seed(seed)
print(f"LUXGATE_TEST_SEED={seed}")
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
small, long = Batch("small", 8), Batch("long work", 3, "--goal", "accuracy", "--tolerance", "0.1%", "--max-paths", "16384")
timed("refused", refused, small)
timed("left out", left_out, small)
engines = [("local", None)] + ([("parallel", None)] if shutil.which("parallel") else [])
if len(engines) == 1:
    print("without GNU parallel: not installed")
for engine, environment in engines:
    for work, batch in [(same_bytes, small), (killed, long)]:
        timed(f"{engine}, {work.__name__}", work, batch, engine, environment)
    if engine == "parallel":
        timed("parallel, by_hand", by_hand, small, engine, environment)
with private_slurm.PrivateSlurm() as slurm:
    if slurm.problem:
        print(f"without Slurm: {slurm.problem}")
    else:
        # All at once: sbatch --wait looks every ten seconds.
        threads = [threading.Thread(target=timed, args=arguments)
                   for arguments in [("slurm, same_bytes", same_bytes, small, "slurm", slurm.environment),
                                     ("slurm, by_hand", by_hand, small, "slurm", slurm.environment),
                                     ("slurm, cancelled", cancelled, long, slurm)]]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
print("\n".join(problems))
if not problems and len(engines) == 1 and slurm.problem:
    print("skipped: neither GNU parallel nor Slurm can run here; bash alone was tried")
sys.exit(1 if problems else 0)
