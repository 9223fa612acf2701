"""A batch of 100,000 rooms on 1 to 10,000 cores, simulated: how long, what waits for what, what breaks first.

    simulate_cluster.py [--write FILE]     prints the tables of tests/validation/scale.md (or writes them)
    simulate_cluster.py --check [FILE]     tests the simulation itself, in seconds, and whether FILE has its tables, as far as
                                           seconds show; exit code 1 if something is wrong

Tasks are dispatched by one scheduler, one after the other, to the core that is free first; each reads the list of units from one file
server, then its projects, then computes. The shards are those of report/check/units.cpp. No clock is read: same tables every time.
"""
import argparse
import math
import pathlib
import statistics
import sys
from dataclasses import replace

from cluster_rooms import FIRST_SCENE_S, LIST_BYTES, LIST_S, LOAD_S, MEASURED, PLAN_S, PROJECT_CALLS, REPORT_S, SHARE, START_S, WRITE_CALLS, make_batch
from cluster_run import (BYTES_PER_S, CALL_S, CALLS_PER_S, MOST_TASKS, NODE_CORES, SLURM_S, TUNED_S,
                         Cluster, closing_s, planning_s, run, shards_by_size, shards_for, shards_of)

KNOWN = {}


def known_run(batch, shard, cluster):
    """As run: more cores than shards have nothing to do."""
    key = id(batch), id(shard), *vars(replace(cluster, cores=min(cluster.cores, max(shard) + 1))).values()
    if key not in KNOWN:
        KNOWN[key] = run(batch, shard, cluster), batch, shard  # kept, so that no id comes again
    return KNOWN[key][0]


def what_costs(batch, cluster, shard, whole_s):
    """Shares of the time from start to report that would not be there without one thing; at least a tenth."""
    count, span_s = max(shard) + 1, known_run(batch, shard, cluster).span_s
    shorter = {"closing job": closing_s(batch, cluster), "planning": planning_s(batch, cluster),
               "store": span_s - known_run(batch, shard, replace(cluster, **NO_SERVER)).span_s,
               "scheduler": span_s - known_run(batch, shard, replace(cluster, dispatch_s=0.0)).span_s,
               "reading the list": span_s - known_run(batch, shard, replace(cluster, list_s=0.0)).span_s}
    if 1 < count < 2000:
        shorter["prediction"] = span_s - known_run(batch, cut(batch, shards_of, count, by_truth=True), cluster).span_s
    if count < cluster.cores:
        shorter["too few shards"] = span_s - known_run(batch, cut(batch, shards_of, cluster.cores), cluster).span_s
    costs = sorted(((some_s / whole_s, name) for name, some_s in shorter.items() if some_s > 0.1 * whole_s), reverse=True)
    return ", ".join(f"{name} {share:.0%}" for share, name in costs[:3]) or "nothing: it computes"


NO_SERVER = dict(call_s=0.0, calls_per_s=math.inf, bytes_per_s=math.inf)
SHARDS = {}


def cut(batch, rule, count, by_truth=False):
    key = id(batch), rule, count, by_truth
    if key not in SHARDS:
        SHARDS[key] = rule(batch.true if by_truth else batch.predicted, count)
    return SHARDS[key]


CORES = (1, 10, 100, 1000, 10_000)


def seconds(value):
    return f"{value:,.0f}" if value >= 9.95 else f"{value:.1f}"


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|---" * len(head) + "|"] + ["| " + " | ".join(map(str, row)) + " |" for row in rows]) + "\n"


def measured_table():
    rows = []
    for kind, rooms in MEASURED.items():
        true, ratio = [room[1] for room in rooms], sorted(room[1] / room[0] for room in rooms)
        rows.append((kind, f"{SHARE[kind]:.1%}", len(rooms), f"{statistics.median(true):.3f}", f"{max(true):.2f}",
                     f"{ratio[0]:.2f} to {ratio[-1]:.2f}", f"{statistics.median(ratio):.2f}", f"{statistics.mean(room[2] for room in rooms):.1f}",
                     f"{statistics.mean(room[3] for room in rooms):,.0f}"))
    return table(["kind", "share, assumed", "measured", "s, median", "s, most", "s / predicted", "median", "looks kept", "kB kept"], rows)


def whole_table(batch, count_of, dispatch_s):
    rows, first_s = [], None
    for cores in CORES:
        cluster, shard = Cluster(cores, dispatch_s), cut(batch, shards_of, count_of(cores))
        done, plan_s, close_s = known_run(batch, shard, cluster), planning_s(batch, cluster), closing_s(batch, cluster)
        free = known_run(batch, shard, replace(cluster, **NO_SERVER))
        whole_s = plan_s + done.span_s + close_s
        first_s = first_s or whole_s
        rows.append((f"{cores:,}", f"{max(shard) + 1:,}", seconds(plan_s), seconds(done.span_s), seconds(done.tail_s), seconds(close_s),
                     seconds(whole_s), f"{first_s / whole_s:.1f}", f"{done.calls / done.span_s:,.0f}", f"{free.calls / free.span_s:,.0f}",
                     f"{sum(batch.bytes) / done.span_s / 1e6:,.0f}", f"{done.list_bytes / 1e9:.2f}", what_costs(batch, cluster, shard, whole_s)))
    return table(["cores", "shards", "plan s", "shards s", "tail s", "closing s", "all s", "speed-up", "store calls /s", "wanted /s",
                  "store MB/s", "list read GB", "a tenth or more of all s"], rows)


def limits_table(batch, costly):
    """Closed formulas: where a thing alone takes as long as the light on that many cores."""
    def limits(some):
        total, looks, size = sum(some.true), sum(some.looks), sum(some.bytes)
        return {"closing job, one thread": total / closing_s(some, Cluster(1)), "closing job, sixteen threads": total / closing_s(some, Cluster(1), 16),
                f"file server, {CALLS_PER_S:,} calls a second": total * CALLS_PER_S / (looks * WRITE_CALLS),
                f"Slurm as measured, {SLURM_S} s a task, a shard for each core": math.sqrt(total / SLURM_S),
                "shards of `luxgate submit`": shards_for(some.predicted), "plan before the start": total / planning_s(some, Cluster(1)),
                f"file server, {BYTES_PER_S / 1e9:.0f} GB a second": total * BYTES_PER_S / size,
                "longest unit, which cannot be cut": total / max(some.true), "tasks of an array, unless Slurm is told otherwise": MOST_TASKS,
                "Slurm tuned, 2 ms a task, a shard for each core": math.sqrt(total / TUNED_S),
                "each shard plans anew, without `--units`": total / (START_S + len(some.true) * PLAN_S),
                "each shard starts and reads the list": total / (START_S + FIRST_SCENE_S + len(some.true) * LIST_S)}
    own, other = limits(batch), limits(costly)
    return table(["what", "cores", "work a hundred times"], [(name, f"{own[name]:,.0f}", f"{other[name]:,.0f}") for name in sorted(own, key=own.get)])


def chunk_tables(batch):
    total, longest = sum(batch.true), max(batch.true)
    ways = [("luxgate submit", lambda cores: shards_for(batch.predicted), shards_of), ("shards = cores", lambda cores: cores, shards_of),
            ("4 × cores", lambda cores: 4 * cores, shards_of), ("5 minutes each", lambda cores: math.ceil(total / 300), shards_of),
            ("1 minute each", lambda cores: math.ceil(total / 60), shards_of),
            ("shards = cores, costliest first", lambda cores: cores, shards_by_size), ("a task each room", lambda cores: len(batch.true), each_alone)]
    tables = []
    for dispatch_s in (SLURM_S, TUNED_S):
        rows = []
        for name, count_of, rule in ways:
            done = [(count_of(cores), known_run(batch, cut(batch, rule, count_of(cores)), Cluster(cores, dispatch_s))) for cores in CORES]
            rows.append((name, *[seconds(one.span_s) + ("*" if count > MOST_TASKS else "") for count, one in done]))
        rows.append(("no less than", *[seconds(max(total / cores, longest)) for cores in CORES]))
        tables.append(table(["shards", "1 core"] + [f"{cores:,} cores" for cores in CORES[1:]], rows))
    return tables


def each_alone(predicted, _):
    return range(len(predicted))


def projects_table(units):
    rows = []
    for rooms in (1, 20, 200, 1000):
        batch, projects = make_batch(units, rooms), units / rooms
        cells = []
        for rule in (shards_of, shards_by_size):
            done = run(batch, rule(batch.predicted, 1000), replace(Cluster(1000, TUNED_S), **NO_SERVER))
            cells += [f"{done.loads / projects:.0f}", f"{done.loads * rooms * LOAD_S:,.0f}", seconds(done.span_s)]
        rows.append((rooms, f"{projects:,.0f}", *cells))
    return table(["rooms of a project", "projects", "reads of each project", "core s for it", "shards s",
                  "costliest first: reads", "core s for it", "shards s"], rows)


def killed_table(batch):
    rows = []
    for cores in (10, 100):
        shard = cut(batch, shards_of, 4 * cores)
        for killed in (0.0, 0.01, 0.1, 0.5):
            kept, lost = (known_run(batch, shard, Cluster(cores, TUNED_S, killed=killed, keeps=keeps)) for keeps in (True, False))
            twice = [f"{abs(done.work_s / sum(batch.true) - 1):.2%}" for done in (kept, lost)]
            rows.append((cores, 4 * cores, kept.tasks - 4 * cores, seconds(kept.span_s), twice[0], seconds(lost.span_s), twice[1]))
    return table(["cores", "tasks", "killed once", "shards s", "light twice", "without a store: s", "light twice"], rows)


def planning_table(batch):
    rows = []
    for cores in CORES[1:]:
        runs = [known_run(batch, cut(batch, shards_of, cores), Cluster(cores, TUNED_S, plans_in_shards=plans)) for plans in (False, True)]
        rows.append((f"{cores:,}", *[cell for done in runs for cell in (seconds(done.span_s), f"{done.list_bytes / 1e9:.2f}")]))
    return table(["cores = shards", "with --units: s", "GB read", "without: s", "GB read"], rows)


def closing_table(batch):
    each = [closing_s(batch, Cluster(1), threads) for threads in (1, 4, 16, 64)]
    local = [closing_s(batch, Cluster(1, call_s=0.0), threads) for threads in (1, 4, 16, 64)]
    return table(["closing job", "1 thread", "4", "16", "64"], [("file server: s", *map(seconds, each)), ("calls cost nothing: s", *map(seconds, local)),
                                                               ("of it reports: s", *[seconds(len(batch.true) * REPORT_S)] * 4)])


def document(units=100_000):
    batch, costly = make_batch(units), make_batch(units, scale=100.0)
    total, looks, size = sum(batch.true), sum(batch.looks), sum(batch.bytes)
    slurm_table, tuned_table = chunk_tables(batch)
    return f"""# A batch of 100,000 rooms on many cores

Printed by `python3 tests/bench/simulate_cluster.py`. This is a simulation: what a room costs was measured, the cluster is made up.
`tests/bench/cluster_rooms.py` says how each number was measured, `cluster_run.py` what was assumed.

## What breaks first

A thing breaks at the number of cores on which the light takes as long as the thing alone: more cores help little from there.

{limits_table(batch, costly)}
- **The closing job first.** It is one process, and waits for the file server at each look: with one thread it is half of the time on 10
  cores. `luxgate submit --closing-jobs 16` takes two thirds off it.
- **Then the file server and Slurm.** A room is less than a tenth of a second of light and some 30 calls to the store. From 100 cores on
  the server that was assumed is full. With a task for each room Slurm, as it was measured, would be busy for 33 hours.
- **Rooms a hundred times as costly** fit a cluster: 100 cores are 80 times as fast as one.
- The rule of shards is not what breaks. Single rooms take up to 13 times what is predicted; on 10 cores half of them still wait less
  than 6 % of the time for the last. Cut in the order of the list, shards read projects a few times at most; dealt out by size, costliest
  first, they are a little more even, and each shard reads most of the projects.

## What was measured

Rooms made by chance: size, furniture, planes and limits differ; limits lie near and far from what is measured. Processor time of one
thread. The share of each kind is assumed. A factor from prediction to time that all rooms have is the machine's speed and does no harm;
what differs from room to room makes shards uneven. The machine was shared: some of the difference is its noise.

{measured_table()}
In all: {total:,.0f} s of one core for the light, {total / units:.3f} s a room, the longest {max(batch.true):.1f} s; {looks:,} looks kept, {size / 1e9:.1f} GB.
Assumed: one file server of {CALLS_PER_S:,} calls and {BYTES_PER_S / 1e9:.0f} GB a second, {CALL_S * 1000:.1f} ms a call when it is idle; {NODE_CORES} cores a node; {batch.rooms_of_project} rooms a project.

## As `luxgate submit` cuts it, Slurm as measured ({SLURM_S} s a task)

"Tail": after half of the cores used have nothing more to do. "Wanted": calls a second if the server had no limit. The last column leaves
out one thing after the other, and says how much of the time goes with it.

{whole_table(batch, lambda cores: shards_for(batch.predicted), SLURM_S)}
## As many shards as cores, Slurm tuned for short tasks ({TUNED_S * 1000:.0f} ms a task)

{whole_table(batch, lambda cores: cores, TUNED_S)}
## Rooms of a hundred times the work, `luxgate submit`, Slurm as measured

{whole_table(costly, lambda cores: shards_for(costly.predicted), SLURM_S)}
## Other cuts: seconds until the last shard ends

Without plan and closing job. `*`: more tasks than one array may have. Slurm as measured:

{slurm_table}
Slurm tuned:

{tuned_table}
## The closing job

It is assumed that threads share the reading evenly; reports are written by one.

{closing_table(batch)}
## Rooms of a project

1,000 shards on 1,000 cores, Slurm tuned, a file server without limits. A shard reads every project of which it has a room.

{projects_table(units)}
## Tasks that die

A share of 0, 1, 10 and 50 % of all tasks, each at a moment by chance, then queued again. With a store only the room in work is lost.

{killed_table(batch)}
## The start

All shards read the list of units at the same time ({units * LIST_BYTES / 1e6:.0f} MB, once a node), or plan all projects anew if `--units` is not given.
Slurm tuned.

{planning_table(batch)}
## Not in it

Nodes that are slow or busy with other work; waiting in Slurm's queue, and its pause before a killed task starts again; disks that fill
up; caches of file servers; GPUs. No room was cut at its planes: of those measured only the large hall is above 10 s, and it is one plane.
Nothing of it was run on more than one machine.
"""


def flaws(rule=shards_of, play=run):
    """What of a small batch is not as it must be."""
    found, batch = [], make_batch(2000, 20)
    def must(is_so, words):
        if not is_so:
            found.append(words)
    must(rule([5, 4, 3, 3, 3], 2) == [0, 0, 1, 1, 1], "cut in the middle of the sum")
    must(rule([1, 1, 6], 2) == [0, 0, 1], "a large unit goes where its middle lies")
    must(rule([1, 1, 1], 3) == [0, 1, 2], "equal units in order")
    for count in (1, 7, 64):
        shard = rule(batch.predicted, count)
        must(len(shard) == len(batch.true) and set(shard) == set(range(count)), f"{count} shards: each has units, each unit a shard")
        loads = [0.0] * count
        for u, s in enumerate(shard):
            loads[s] += batch.predicted[u]
        must(math.isclose(sum(loads), sum(batch.predicted)), f"{count} shards: predicted work is kept")
        must(max(loads) <= sum(batch.predicted) / count + max(batch.predicted), f"{count} shards: no more than a unit above the mean")
        for cores in (1, 5, 64):
            cluster = Cluster(cores, 0.5)
            done = play(batch, shard, cluster)
            bound = max(sum(batch.true) / min(cores, count), max(batch.true))
            must(done.span_s >= bound, f"{count} shards, {cores} cores: quicker than can be")
            must(math.isclose(done.work_s, sum(batch.true)), f"{count} shards, {cores} cores: light is lost or twice")
            must(done.span_s >= count * cluster.dispatch_s, f"{count} shards, {cores} cores: the scheduler does two at once")
            must(done.calls == sum(batch.looks) * WRITE_CALLS + done.loads * PROJECT_CALLS, f"{count} shards, {cores} cores: calls")
            must(done.tasks == count, f"{count} shards, {cores} cores: tasks")
            if cores == 1:
                must(math.isclose(done.span_s, done.busy_s + count * 0.5), f"{count} shards, one core: the sum of all")
    whole, shard = play(batch, rule(batch.predicted, 10), Cluster(10)), rule(batch.predicted, 10)
    must(play(batch, shard, Cluster(10)) == whole, "the same twice")
    must(play(batch, shard, Cluster(10, dispatch_s=0.0)).span_s < whole.span_s, "a scheduler without time is quicker")
    must(play(batch, shard, Cluster(10, calls_per_s=100.0)).span_s >= sum(batch.looks) * WRITE_CALLS / 100.0, "the server does more than it can")
    kept, lost = (play(batch, shard, Cluster(10, killed=1.0, keeps=keeps)) for keeps in (True, False))
    must(kept.tasks == lost.tasks == 20, "each killed task is queued again")
    must(sum(batch.true) < kept.work_s <= sum(batch.true) + 10 * max(batch.true), "killed, with a store: a room each is lost")
    must(lost.work_s > kept.work_s and lost.span_s > kept.span_s, "killed, without a store: more is lost")
    return found


def quick_tables(units=100_000):
    """Those of document() that run nothing."""
    batch, costly = make_batch(units), make_batch(units, scale=100.0)
    return {"what breaks first": limits_table(batch, costly), "what was measured": measured_table(), "the closing job": closing_table(batch)}


def check(file):
    """The simulation is right, each way to spoil it is seen, and a file has what it says."""
    found = flaws()
    text = pathlib.Path(file).read_text() if file else None
    found += [f"{file} has another table: {name}" for name, one in quick_tables().items() if text is not None and one not in text]
    def spoilt_run(**changes):
        return lambda batch, shard, cluster: replace(run(batch, shard, cluster), **{
            name: change(getattr(run(batch, shard, cluster), name)) for name, change in changes.items()})
    spoilt = {"in turn": dict(rule=lambda costs, n: [u % n for u in range(len(costs))]),
              "costliest first": dict(rule=shards_by_size),
              "by number": dict(rule=lambda costs, n: shards_of([1.0] * len(costs), n)),
              "one unit less": dict(rule=lambda costs, n: shards_of(costs[:-1], n)),
              "no scheduler": dict(play=lambda batch, shard, cluster: run(batch, shard, replace(cluster, dispatch_s=0.0))),
              "one core more": dict(play=lambda batch, shard, cluster: run(batch, shard, replace(cluster, cores=cluster.cores + 1))),
              "nobody dies": dict(play=lambda batch, shard, cluster: run(batch, shard, replace(cluster, killed=0.0))),
              "all is kept": dict(play=lambda batch, shard, cluster: run(batch, shard, replace(cluster, keeps=True))),
              "an endless server": dict(play=lambda batch, shard, cluster: run(batch, shard, replace(cluster, calls_per_s=math.inf))),
              "too quick": dict(play=spoilt_run(span_s=lambda span_s: span_s * 0.97)),
              "light lost": dict(play=spoilt_run(work_s=lambda work_s: work_s * 0.999)),
              "calls lost": dict(play=spoilt_run(calls=lambda calls: calls - 1))}
    found += [f"not seen: {name}" for name, parts in spoilt.items() if not flaws(**parts)]
    print("\n".join(found) or f"right; {len(spoilt)} ways to spoil it are seen")
    return 1 if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE")
    parser.add_argument("--check", nargs="?", const="", metavar="FILE")
    options = parser.parse_args()
    if options.check is not None:
        return check(options.check)
    if options.write:
        pathlib.Path(options.write).write_text(document())
    else:
        print(document(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
