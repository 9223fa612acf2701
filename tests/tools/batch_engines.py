"""Batches of `luxgate submit` by real engines: the bytes of one machine, whatever happens to shards on the way.

    batch_engines.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew

bash is always there; GNU parallel, Slurm and Snakemake are tried where they are installed. What pods of Kubernetes run is run by bash.
"""
import contextlib
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

import yaml

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
            expect(written.exists(), f"{what}: {name} was not written: {messages}")
            expect(not written.exists() or written.read_bytes() == wanted.read_bytes(), f"{what}: {name} is not that of one machine: {messages}")


def folder_of(jobs):
    """Of the one batch in a job folder."""
    return next(iter(jobs.iterdir()))


def formats(out):
    return [word for name in FORMATS for word in ("--format", f"{name}={out}/x.{name}")]


def units_of_shard(job, count, wanted):
    """By name, as the program shares them out: in the order of the list, cut where the sum of predicted seconds says."""
    units = json.loads((job / "units.json").read_text())["units"]
    names, before, total = set(), 0.0, sum(unit["first_look_s"] for unit in units)
    for unit in units:
        if int((before + unit["first_look_s"] / 2) / total * count) + 1 == wanted:
            names.add(f"{unit['project']}: {unit['space']}")
        before += unit["first_look_s"]
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
    jobs = batch.folder / f"local {case}" / "job"
    command = [word for word in batch.submit("local", case, shards) if word != "--send"]
    printed = subprocess.run(command, cwd=batch.folder, capture_output=True, text=True, check=False)
    expect(printed.returncode == 0, f"submit: exit code {printed.returncode}: {printed.stderr}")
    job = folder_of(jobs)
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

    def __init__(self, jobs, shard):
        super().__init__(daemon=True)
        self.jobs, self.shard, self.has_killed = str(jobs), shard, False
        self.start()

    def run(self):
        end = time.monotonic() + 60
        while time.monotonic() < end:
            for entry in pathlib.Path("/proc").iterdir():
                if not entry.name.isdigit():
                    continue
                with contextlib.suppress(OSError):
                    words = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
                    if words[0] == str(PROGRAM) and self.shard in words and any(w.startswith(self.jobs) and w.endswith("/units.json") for w in words):
                        time.sleep(random.random() * 0.2)
                        os.kill(int(entry.name), signal.SIGKILL)
                        self.has_killed = True
                        return
            time.sleep(0.005)


def killed(batch, engine, environment):
    """A shard at random; the same once more completes it, GNU parallel with that shard alone."""
    case, shards = "killed", 3
    jobs = batch.folder / f"{engine} {case}" / "job"
    victim = random.randint(1, shards)
    killer = Killer(jobs, f"{victim}/{shards}")
    process = batch.start(batch.submit(engine, case, shards), environment)
    _, messages = process.communicate(timeout=PATIENCE_S)
    killer.join(1)
    expect(killer.has_killed, f"{engine}, killed: shard {victim} was never there")
    expect(process.returncode == 2, f"{engine}, killed: exit code {process.returncode}, expected 2: {messages}")
    job, named = folder_of(jobs), missing_units(messages)
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
    process = batch.start(batch.submit("slurm", case, shards, "--at-once", "1"), slurm.environment)
    array = next((line.split()[-1] for line in process.stderr if line.startswith("shards: job ")), "")
    slurm.run("scancel", f"{array}_{shards}")
    _, messages = process.communicate(timeout=PATIENCE_S)
    expect(process.returncode == 2, f"slurm, cancelled: exit code {process.returncode}, expected 2: {messages}")
    job = folder_of(batch.folder / f"slurm {case}" / "job")
    wanted, named = units_of_shard(job, shards, shards), missing_units(messages)
    expect(wanted == named, f"slurm, cancelled: {sorted(named)} are named, {sorted(wanted)} are missing: {messages}")
    store = batch.folder / f"slurm {case}" / "looks"
    batch.expect_same("local", case, batch.start(batch.submit("local", case, shards, store=store), None), ", what Slurm left")


def node_down(batch, slurm):
    """A node that is gone in the middle: Slurm queues its shards again, and they go on from the store when it is back."""
    process = batch.start(batch.submit("slurm", "node down", 2), slurm.environment)
    array = next((line.split()[-1] for line in process.stderr if line.startswith("shards: job ")), "")
    def states():
        return slurm.run("squeue", "--noheader", "--array", "-j", array, "-o", "%T").stdout.split()
    expect(slurm.wait(lambda: "RUNNING" in states(), 20), "slurm, node down: no shard begins")
    slurm.run("scontrol", "update", f"nodename={slurm.host}", "state=down", "reason=test")
    expect(slurm.wait(lambda: states() and set(states()) == {"PENDING"}, 20), f"slurm, node down: shards are not queued again: {states()}")
    end = time.monotonic() + PATIENCE_S
    while process.poll() is None and time.monotonic() < end:
        if "down" in slurm.run("sinfo", "--noheader", "-o", "%T").stdout:
            slurm.run("scontrol", "update", f"nodename={slurm.host}", "state=resume")
        for task in slurm.run("squeue", "--noheader", "--array", "-j", array, "-t", "PENDING", "-o", "%i").stdout.split():
            slurm.run("scontrol", "release", task)  # held if the node went away while it began
            slurm.run("scontrol", "update", f"jobid={task}", "starttime=now")  # Slurm would wait two minutes
        time.sleep(1)
    if process.poll() is None:
        problems.append("slurm, node down: " + slurm.run("squeue", "--array", "-o", "%i %T %r %S").stdout + slurm.run("sinfo", "-R").stdout)
    batch.expect_same("slurm", "node down", process)


def not_closed(slurm):
    """A closing job that never ran is no verdict, whatever lies there of a batch before."""
    folder = WORK / "not closed"
    design = pathlib.Path(small_designs.write(folder / "a.xml", far=False))
    words = [PROGRAM, "submit", "--engine", "slurm", "a.xml", "--store", "looks", "--send", "--wait", "--quiet"]
    run = subprocess.run(words, cwd=folder, env=slurm.environment, capture_output=True, text=True, timeout=PATIENCE_S, check=False)
    expect(run.returncode == 0, f"slurm, not closed: a design that passes ends with {run.returncode}: {run.stderr}")
    small_designs.write(design, far=False, limit="90000")
    process = subprocess.Popen(words, cwd=folder, env=slurm.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    slurm.wait(lambda: slurm.run("squeue", "--noheader", "--name=luxgate-close", "--format=%i").stdout, 20)
    slurm.run("scancel", "--name=luxgate-close")
    out, messages = process.communicate(timeout=PATIENCE_S)
    expect(process.returncode == 2 and not out and "did not finish" in messages, f"slurm, not closed: {process.returncode}, {out}, {messages}")


def two_batches(engine, rounds):
    """With one store, and so the same job folder: neither gets the verdict of the other."""
    folder = WORK / f"{engine} two batches"
    for name, limit in (("good", "100"), ("bad", "90000")):
        small_designs.write(folder / f"{name}.xml", far=False, limit=limit)
    for _ in range(rounds):
        started = [(name, code, subprocess.Popen([PROGRAM, "submit", "--engine", engine, f"{name}.xml", "--store", "looks", "--send", "--quiet"],
                                                 cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True))
                   for name, code in (("good", 0), ("bad", 1))]
        for name, code, process in started:
            _, messages = process.communicate(timeout=PATIENCE_S)
            expect(process.returncode == code, f"{engine}, two batches: the {name} one ends with {process.returncode}: {messages}")


def interrupted(batch, engine, environment):
    """Ctrl-C at a terminal, and a signal to the script alone: 130, no report, and nothing goes on."""
    for case, sends in [("interrupted", os.killpg), ("ended", os.kill)]:
        process = subprocess.Popen(batch.submit(engine, case, 3), cwd=batch.folder, env=environment, start_new_session=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        jobs = str(batch.folder / f"{engine} {case}" / "job")
        def is_begun():
            return any(words[0] == str(PROGRAM) and "--shard" in words for words in commands_with(jobs))
        end = time.monotonic() + 20
        while not is_begun() and time.monotonic() < end:
            time.sleep(0.02)
        time.sleep(0.1)
        sends(process.pid, signal.SIGINT if sends is os.killpg else signal.SIGTERM)
        _, messages = process.communicate(timeout=PATIENCE_S)
        expect(process.returncode == 130, f"{engine}, {case}: exit code {process.returncode}, expected 130: {messages}")
        time.sleep(0.3)
        left = commands_with(jobs)
        expect(not left, f"{engine}, {case}: {left} go on")
        expect(not (batch.folder / f"{engine} {case}" / "x.json").exists(), f"{engine}, {case}: a report was written")


def commands_with(path):
    """Of processes that have it in a word; GNU parallel gives each job a group of its own."""
    commands = []
    for entry in pathlib.Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if entry.name.isdigit():
                commands.append((entry / "cmdline").read_bytes().decode(errors="replace").split("\0"))
    return [words for words in commands if any(path in word for word in words)]


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


class Folder:
    """A copy of the designs in designs/, as the scripts for Kubernetes and Snakemake want them, and what one machine says of them."""

    def __init__(self, batch, name):
        self.path = batch.folder / name
        (self.path / "designs").mkdir(parents=True)
        for file in [*batch.designs, "spot.ies"]:
            shutil.copy(batch.folder / file, self.path / "designs")
        commands = self.path / "commands"
        commands.mkdir()
        (commands / "luxgate").symlink_to(PROGRAM)
        self.environment = {**os.environ, "PATH": f"{commands}:{os.environ['PATH']}"}
        self.name, designs = name, sorted(f"designs/{design}" for design in batch.designs)
        one = subprocess.run([PROGRAM, "check", *designs, "--seed", "1", *formats("one")], cwd=self.path, capture_output=True, check=False)
        expect(one.returncode == 1, f"{name}: one machine ends with {one.returncode}")

    def run(self, *command, **environment):
        return subprocess.run(command, cwd=self.path, env={**self.environment, **environment}, capture_output=True, text=True,
                              timeout=PATIENCE_S, check=False)

    def expect_same(self, *names):
        for name in names:
            written, wanted = self.path / f"batch.{name}", self.path / "one" / f"x.{name}"
            expect(written.exists() and written.read_bytes() == wanted.read_bytes(), f"{self.name}: {name} is not that of one machine")


def kubernetes(batch):
    """What the pods would run, by bash: completions are shards, and count from 0."""
    folder = Folder(batch, "kubernetes")
    shards, close = yaml.safe_load_all((EXAMPLES / "batch" / "kubernetes.yaml").read_text())
    def container(job):
        one = job["spec"]["template"]["spec"]["containers"][0]
        return one["command"] + one["args"], {entry["name"]: entry["value"] for entry in one.get("env", [])}
    words, variables = container(shards)
    count = shards["spec"]["completions"]
    expect(variables["SHARDS"] == str(count), f"kubernetes: {count} completions of {variables['SHARDS']} shards")
    for index in range(count):
        run = folder.run(*words, **variables, JOB_COMPLETION_INDEX=str(index))
        expect(run.returncode == 0, f"kubernetes, pod {index}: {run.returncode}, {run.stderr}")
    run = folder.run(*container(close)[0])
    expect(run.returncode == 1, f"kubernetes, closing job: {run.returncode}, {run.stderr}")
    folder.expect_same("html", "json")


def snakemake(batch):
    """Twice: the second has nothing to do. Then one design changes."""
    folder = Folder(batch, "snakemake")
    words = ["snakemake", "--cores", "2", "--snakefile", str(EXAMPLES / "batch" / "Snakefile"), "--directory", str(folder.path)]
    run = folder.run(*words, HOME=str(folder.path))
    expect(run.returncode == 0 and (folder.path / "batch.code").exists(), f"snakemake: {run.returncode}, {run.stderr}")
    expect((folder.path / "batch.code").read_text() == "1\n", "snakemake: batch.code is not 1")
    folder.expect_same("html", "json")
    run = folder.run(*words, HOME=str(folder.path))
    expect(run.returncode == 0 and "Nothing to be done" in run.stderr + run.stdout, f"snakemake, again: {run.stderr}")


def full_disk(batch):
    """A store on a disk of 64 KiB, in a mount namespace of its own: exit code 2; the same with room for it completes it."""
    out = batch.folder / "local full disk"
    store = out / "looks"
    store.mkdir(parents=True)
    words = [str(word) for word in batch.submit("local", "full disk", 2)]
    script = 'mount -t tmpfs -o size=64k none "$0" || exit 77; "$@" 2>"$0-full"; echo "$?" >"$0-code"; mount -o remount,size=64m "$0"; exec "$@"'
    enter = ["unshare", "--mount", "--map-root-user"]
    tried = subprocess.run([*enter, "bash", "-c", 'mount -t tmpfs none "$0"', store], capture_output=True, text=True, check=False)
    if tried.returncode != 0:
        print(f"without a full disk: {tried.stderr.strip()}")
        return
    process = batch.start([*enter, "bash", "-c", script, str(store), *words], None)
    batch.expect_same("local", "full disk", process, ", with room")
    code, messages = pathlib.Path(f"{store}-code").read_text(), pathlib.Path(f"{store}-full").read_text()
    expect(code == "2\n" and "No space left on device" in messages, f"full disk: exit code {code}: {messages}")
    expect(missing_units(messages), f"full disk: nothing is named: {messages}")


def refused(batch):
    """What is wrong is said before anything is sent."""
    for words, message in [([], "--store is needed"), (["--store", "off"], "--store: a batch needs one"),
                           (["--store", "s", "--wait"], "--wait needs --send"),
                           (["--store", "s", "--shard", "1/2"], "unknown option '--shard'"),
                           (["--store", "s", "--format", "csv", "--format", "json"], "only one kind can go to standard output"),
                           (["--store", "s", "gone.xml"], "no job is made"),
                           (["--store", "s", "--engine", "slurm", "--job-folder", "a\\b"], "Slurm does not allow"),
                           (["--store", "s", "--engine", "parallel", "--job-folder", "a{}b"], "GNU parallel does not allow"),
                           (["--store", "s", b"caf\xe9.xml"], "is not UTF-8")]:
        engine = [] if "--engine" in words else ["--engine", "local"]
        run = subprocess.run([PROGRAM, "submit", *engine, batch.designs[0], *words], cwd=batch.folder, capture_output=True,
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
shutil.copy(small.folder / small.designs[0], os.fsencode(small.folder) + b"/caf\xe9.xml")
timed("refused", refused, small)
timed("left out", left_out, small)
timed("full disk", full_disk, small)
timed("kubernetes", kubernetes, small)
if shutil.which("snakemake"):
    timed("snakemake", snakemake, small)
else:
    print("without Snakemake: not installed")
engines = [("local", None)] + ([("parallel", None)] if shutil.which("parallel") else [])
if len(engines) == 1:
    print("without GNU parallel: not installed")
for engine, environment in engines:
    for work, batch in [(same_bytes, small), (killed, long), (interrupted, long)]:
        timed(f"{engine}, {work.__name__}", work, batch, engine, environment)
    timed(f"{engine}, two_batches", two_batches, engine, 4)
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
        timed("slurm, node down", node_down, long, slurm)
        timed("slurm, not closed", not_closed, slurm)
print("\n".join(problems))
if not problems and len(engines) == 1 and slurm.problem:
    print("skipped: neither GNU parallel nor Slurm can run here; bash alone was tried")
sys.exit(1 if problems else 0)
