"""A cluster that works on a batch, event by event: for simulate_cluster.py."""
import heapq
import math
import random
from collections import deque
from dataclasses import dataclass

from cluster_rooms import (CLOSE_LOOK_S, CLOSE_MB_S, CLOSE_ROOM_S, FIRST_SCENE_S, LIST_BYTES, LIST_S, LOAD_S, PLAN_S, PROJECT_CALLS, READ_CALLS,
                           REPORT_S, ROOM_BYTES, START_S, WRITE_CALLS)

SLURM_S = 1.2            # a task, an array of 100 empty ones: design note SCALE.md; 1 a second, one small Slurm
TUNED_S = 0.002          # Slurm's high_throughput.shtml: "500 simple batch jobs per second" on a sustained basis
MOST_TASKS = 1000        # report/tools/submit/job_script.cpp, for Slurm's MaxArraySize of 1001
SHARD_S, LOOKS_OF_WORK = 180.0, 4.0  # the same file

# Assumed, not measured: a file server for the whole cluster.
CALLS_PER_S, BYTES_PER_S, CALL_S, NODE_CORES = 20_000, 1e9, 0.3e-3, 32


@dataclass
class Cluster:
    cores: int
    dispatch_s: float = SLURM_S
    call_s: float = CALL_S
    calls_per_s: float = CALLS_PER_S
    bytes_per_s: float = BYTES_PER_S
    list_s: float = LIST_S
    plans_in_shards: bool = False  # without --units
    killed: float = 0.0            # share of tasks that end once before they are done
    keeps: bool = True             # what a killed task had done


@dataclass
class Run:
    span_s: float      # until the last shard ends
    tail_s: float      # of it: after half of the cores used have nothing more to do
    busy_s: float      # all tasks together
    work_s: float      # light computed, all tasks together
    tasks: int
    loads: int         # projects read
    calls: int
    list_bytes: float  # read from the server


def shards_of(predicted, count):
    """As report/check/units.cpp: the list is cut where the predicted sum says, so that rooms of a project stay together."""
    total, before, shard = sum(predicted), 0.0, []
    for seconds in predicted:
        shard.append(min(count - 1, int((before + seconds / 2) / total * count)))
        before += seconds
    return shard


def shards_by_size(predicted, count):
    """As it was before, better balanced: the costliest first, each to the shard that has least; the first of equals."""
    least = [(0.0, s) for s in range(count)]
    shard = [0] * len(predicted)
    for u in sorted(range(len(predicted)), key=lambda u: -predicted[u]):
        seconds, s = least[0]
        shard[u] = s
        heapq.heapreplace(least, (seconds + predicted[u], s))
    return shard


def shards_for(predicted):
    """As luxgate submit."""
    return max(1, min(len(predicted), MOST_TASKS, math.ceil(sum(predicted) * LOOKS_OF_WORK / SHARD_S)))


def run(batch, shard, cluster, seed=2):
    """Event by event: tasks in a line, one scheduler, cores, one file server that serves one after the other."""
    own = [[] for _ in range(max(shard) + 1)]
    for u, s in enumerate(shard):
        own[s].append(u)
    own = [units for units in own if units]
    chance, units_of_list, result = random.Random(seed), len(batch.true), Run(0, 0, 0, 0, 0, 0, 0, 0)
    waiting = deque((units, 0, chance.random() if chance.random() < cluster.killed else None) for units in own)
    each_bytes, each_s = (ROOM_BYTES, PLAN_S) if cluster.plans_in_shards else (LIST_BYTES, cluster.list_s)
    true, call_s = batch.true, cluster.call_s
    writes = [looks * WRITE_CALLS for looks in batch.looks]
    serving = [max(calls / cluster.calls_per_s, size / cluster.bytes_per_s) for calls, size in zip(writes, batch.bytes)]
    scheduler = wire = server = 0.0
    nodes, ends = {}, []

    def begin(now, core):
        """Dispatches the next task: (when its first unit is computed, core, what is left to do)."""
        nonlocal scheduler, wire
        units, done, kill_at = waiting.popleft()
        start = scheduler = max(scheduler, now) + cluster.dispatch_s
        node = core // NODE_CORES
        if node not in nodes:  # later ones of the node find the list in its memory
            wire = nodes[node] = max(wire, start) + units_of_list * each_bytes / cluster.bytes_per_s
            result.list_bytes += units_of_list * each_bytes
        projects = len({batch.project[u] for u in units})
        calls = projects * PROJECT_CALLS + sum(batch.looks[u] for u in units[:done]) * READ_CALLS
        ready = max(start, nodes[node]) + START_S + FIRST_SCENE_S + units_of_list * each_s + projects * batch.rooms_of_project * LOAD_S
        left_s = math.inf if kill_at is None else kill_at * sum(true[u] for u in units)
        result.loads += projects
        result.calls += calls
        result.tasks += 1
        result.busy_s -= start
        return compute(ready + calls * call_s, core, units, done, left_s)

    def compute(now, core, units, place, left_s):
        u = units[place]
        return now + min(true[u], left_s) + (writes[u] * call_s if left_s >= true[u] else 0.0), core, units, place, left_s

    events = []
    for core in range(min(cluster.cores, len(own))):
        heapq.heappush(events, begin(0.0, core))
    while events:
        now, core, units, place, left_s = events[0]
        u = units[place]
        is_killed = left_s < true[u]
        result.work_s += min(left_s, true[u])
        if not is_killed:  # its looks go to the store
            server = max(server, now) + serving[u]
            now = max(now, server)
            result.calls += writes[u]
            if place + 1 < len(units):
                heapq.heapreplace(events, compute(now, core, units, place + 1, left_s - true[u]))
                continue
        else:
            waiting.append((units, place if cluster.keeps else 0, None))
        result.busy_s += now
        if waiting:
            heapq.heapreplace(events, begin(now, core))
        else:
            heapq.heappop(events)
            ends.append(now)
    result.span_s, result.tail_s = max(ends), max(ends) - sorted(ends)[len(ends) // 2]
    return result


def closing_s(batch, cluster, threads=1):
    """One process: threads read the store; reports are written in order by one."""
    units, looks = len(batch.true), sum(batch.looks)
    reading_s = units * CLOSE_ROOM_S + looks * CLOSE_LOOK_S + sum(batch.bytes) * CLOSE_MB_S / 1e6
    reading_s += (looks * READ_CALLS + units / batch.rooms_of_project * PROJECT_CALLS) * cluster.call_s
    reading_s = max(reading_s / threads, looks * READ_CALLS / cluster.calls_per_s, sum(batch.bytes) / cluster.bytes_per_s)
    return cluster.dispatch_s + START_S + FIRST_SCENE_S + reading_s + units * REPORT_S


def planning_s(batch, cluster):
    return START_S + len(batch.true) * PLAN_S + len(batch.true) / batch.rooms_of_project * PROJECT_CALLS * cluster.call_s
