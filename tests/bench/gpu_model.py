#!/usr/bin/env python3
"""What the GPU backend should take on devices, phase by phase, and what limits each phase.

    gpu_model.py [--counts FILE] [--tree eight|binary] [--visits KIND=NODES,TRIANGLES]...
                 [--threads N] [--markdown|--check]

Counted work (gpu_model_counts.json, by gpu_model_counts) times instructions counted by hand from the
shaders, over published rates. Node visits are an input (gpu_model_visits.json): --visits
connections=4,1 takes the place of what is there of connections, light_paths or near_field. Nothing
here was measured on a GPU.
"""

import argparse
import json
import math
import pathlib
import sys

# --- devices: published ---------------------------------------------------------------------------
# sms, clock: what makes up the published peak (2 operations per lane and clock). fp64: lanes per SM.
# l1: bytes per clock and SM. Of L2 no rate is published: measured by others, or assumed from that.
HOPPER = "data sheets of NVIDIA H100 and H200, Hopper tuning guide; L2 measured on an H100 PCIe (chipsandcheese.com)"
ADA = "data sheets of NVIDIA L4 and GeForce RTX 4090, Ada tuning guide; L2 assumed"
DEVICES = {
    "H100 SXM": dict(sms=132, clock=1.98e9, fp32=128, fp64=64, threads=2048, hbm=3.35e12, l2_mb=50,
                     l2=5.5e12, pcie=64e9, source=HOPPER),
    "H200 SXM": dict(sms=132, clock=1.98e9, fp32=128, fp64=64, threads=2048, hbm=4.8e12, l2_mb=50,
                     l2=5.5e12, pcie=64e9, source=HOPPER),
    "L4": dict(sms=58, clock=2.04e9, fp32=128, fp64=2, threads=1536, hbm=0.3e12, l2_mb=48,
               l2=2.0e12, pcie=32e9, source=ADA),
    "RTX 4090": dict(sms=128, clock=2.52e9, fp32=128, fp64=2, threads=1536, hbm=1.008e12, l2_mb=72,
                     l2=5.0e12, pcie=32e9, source=ADA),
}

# --- assumed --------------------------------------------------------------------------------------
ASSUMED = {
    "rays_lanes": (0.35, "share of a warp's lanes that a divergent traversal keeps busy"),
    "code_lanes": (0.9, "the same where all do the same"),
    "issue": (0.5, "share of the peak rate that real code issues"),
    "double_divide": (10.0, "fp64 instructions of a division or root"),
    "float_divide": (8.0, "fp32 instructions of a division or root"),
    "l1_bytes_per_clock": (128.0, "bytes an SM reads from L1 in a clock"),
    "l1_miss": (0.15, "share of node and triangle reads that L1 does not hold (100 kB of tree)"),
    "occupancy": (0.5, "share of the threads of an SM that registers leave room for"),
    "in_flight": (3.0, "pieces on the device at a time (gpu/draw_queue), if reads do not block"),
    "launch_s": (5e-6, "of a dispatch or an upload, processor and driver"),
    "read_s": (3e-5, "of a blocking read, beside its bytes"),
    "pcie_share": (0.5, "share of the published PCIe rate that plain buffers reach"),
}
A = {name: value for name, (value, _) in ASSUMED.items()}

# --- instructions, by hand from the shaders -------------------------------------------------------
# (fp32 and integer, fp64, bytes). d: a division or root, counted by the assumption above.
D, F = A["double_divide"], A["float_divide"]
COUNTED = {
    # visibility.glsl, a node of eight: grid 9, cell 3, begin 6, slack 15, signs and choice 15; twice
    # four boxes: 6 words taken apart and converted at 12, 24 products with sums, 24 min/max, 10 to
    # join them; links 15, stack and loop 30. Shared memory is left out
    "node visit, eight": (9 + 3 + 6 + 15 + 15 + 2 * (72 + 24 + 24 + 10) + 45, 0, 80),
    # the binary tree before it: 6 subtractions, 6 products, 6 min/max per pair, 6 to join them, 2
    # products, 1 comparison = 27; the loop: 2 comparisons, 3 to take the leaf apart, 4 of addresses,
    # 1 step = 10
    "node visit, binary": (37, 0, 32),
    # is_crossed: 9 differences; 3 volumes of 6 + 9 + 5 (precise: nothing is fused) = 60; rounding 4;
    # inside 8; one in three goes on to slope, distance and division: (5 + 5 + F) / 3
    "triangle test": (81 + (10 + F) / 3, 0, 48),
    # along, length, three reciprocals
    "ray": (16 + 4 * F, 0, 0),
    # find_draw.glsl: place 3; two binary searches of 8 and 4 steps; 3 divisions; 8 others.
    # connection_terms.glsl and the rest of trace.glsl: 60
    "draw": (60 + 12 * 8, 3 + 12 + 3 * D + 8, 64 + 12 * 8),
    # weigh.glsl of one receiver and node: 50 of node_terms.glsl, two exact quotients of 25 + F and an
    # exact root of 25 + F, 15 of addresses; reads 80 bytes, of which neighbours share most; writes 4
    "weight": (50 + 3 * (25 + F) + 15, 0, 4 + 80 / 32),
    # share.glsl of one: two sums over it, one in float, a store
    "share": (10, 4, 4 + 4 + 4 + 8),
    # add.glsl: one of a draw
    "sum": (12, 2, 8),
    # light_paths.glsl, one reflection beside its ray: place_on 92 and conversions 15; surface 45;
    # flux and survival 9; cosine_direction 115 of which 3 divisions or roots are apart; two Sobol'
    # samples of 32 steps
    "reflection": (2 * 32 * 5 + 40, 92 + 15 + 45 + 9 + 85 + 5 * D, 160),
    # path_starts.glsl: about seven turns of segment_at (95), opening 60, choice 20; five samples
    "path start": (5 * 32 * 5 + 80, 7 * 95 + 60 + 20 + 10 * D, 800),
    # short_rays.glsl beside its ray: request search 12 steps; two samples; direction; place_on
    "short ray": (12 * 6 + 2 * 32 * 5 + 30, 85 + 107 + 8 + 5 * D, 64 + 12),
}

# --- the processor beside it: one thread, measured ------------------------------------------------
CPU_NS = {"connection": 95.0, "pool_ray": 480.0, "near_ray": 300.0}  # calc/forecast/cost_model.cpp
BESIDE_NS = {"connection": 20.0, "path": 400.0, "vertex": 45.0 + 15.0, "short_ray": 5.0}
FIRST_SHORT_RAY_NS = 75.0
RAYS_PER_SHORT_RAY = 1.7
VERTEX_UP, VERTEX_DOWN = 90, 48
# llvmpipe: floats of a vector of 256 bits, vectors a clock and clocks for a word of a buffer (both
# assumed), clocks a second (measured)
SOFTWARE = dict(lanes=8, per_clock=2.0, word_clocks=5.0, clock=2.46e9)
RECEIVERS_PER_PIECE = 2048


def draws_per_point(paths, points):
    """calc::draws_per_point()"""
    wanted = min(max(16 * paths // max(1, points), max(paths // 64, 16)), max(paths // 2, 16))
    return 1 << (wanted.bit_length() - 1)


def cut_nodes(draws):
    """calc/radiosity/plane_connect.cpp"""
    return min(max(16 * draws, 128), max(1024, draws))


class Work:
    """Counts of a whole run: those of a look, stretched to the error that is wanted. Looks begin with
    256 light paths and double; errors go with the root of all paths."""

    def __init__(self, look, error):
        self.points, self.replicates = look["points"], look["replicates"]
        wanted = look["paths"] * (look["error"] / error) ** 2
        self.looks = max(1, math.ceil(math.log2(wanted / 256) - 1e-9) + 1)
        self.set_paths(look, [256] + [256 * 2**k for k in range(self.looks - 1)])

    @classmethod
    def of_look(cls, look):
        """The look itself."""
        work = cls.__new__(cls)
        work.points, work.replicates, work.looks = look["points"], look["replicates"], 1
        work.set_paths(look, [look["paths"]])
        return work

    def set_paths(self, look, batches):
        self.paths = sum(batches)  # of a replicate
        self.light_paths = self.paths * self.replicates
        self.pool_rays = look["pool_rays"] * self.paths / look["paths"]
        drawn = [draws_per_point(paths, self.points) for paths in batches]
        self.draws = drawn[-1]
        shares = [draws / draws_per_point(look["paths"], self.points) for draws in drawn]
        self.connections = look["connections"] * sum(shares)
        # They follow variance, not draws: measured, see "Stretching".
        self.near_rays = look["near_rays"] * sum(math.sqrt(share) for share in shares)
        self.receivers = self.points * self.replicates  # of one look
        # Exact, or as good as that, however many looks.
        self.direct_cpu_s = look["seconds"]["direct"]


class Device:
    def __init__(self, name):
        self.__dict__.update(DEVICES[name])
        self.name = name
        self.peak32 = self.sms * self.fp32 * self.clock
        self.peak64 = self.sms * self.fp64 * self.clock
        self.l1 = self.sms * A["l1_bytes_per_clock"] * self.clock
        self.resident = self.sms * self.threads

    def limits(self, items, lanes, l1_share, pool_bytes=0.0, threads=math.inf):
        """items: (count, kind). Seconds by limit: the largest is the time of the device's part."""
        fill = min(1.0, A["in_flight"] * threads / (A["occupancy"] * self.resident))
        n32 = sum(count * COUNTED[kind][0] for count, kind in items)
        n64 = sum(count * COUNTED[kind][1] for count, kind in items)
        size = sum(count * COUNTED[kind][2] for count, kind in items)
        rate = lanes * A["issue"] * fill
        beyond = size * (1.0 - l1_share)
        is_in_l2 = pool_bytes < self.l2_mb * 1e6
        return {
            "fp32": n32 / (self.peak32 * rate),
            "fp64": n64 / (self.peak64 * rate),
            "L1": size / self.l1 / fill,
            "L2": (beyond if is_in_l2 else 0.3 * beyond) / self.l2 / fill,
            "memory": (0.0 if is_in_l2 else 0.7 * beyond) / self.hbm / fill,
        }

    def pcie_s(self, size):
        return size / (A["pcie_share"] * self.pcie)


def ray_items(rays, visits):
    return [(rays, "ray"), (rays * visits["nodes"], f"node visit, {visits['tree']}"),
            (rays * visits["triangles"], "triangle test")]


def added(*parts):
    return {key: sum(part[key] for part in parts) for key in parts[0]}


def phase(limits, others):
    """The device's largest limit, and what comes before and after it, one after the other."""
    name = max(limits, key=limits.get)
    whole = {name: limits[name], **others}
    return sum(whole.values()), max(whole, key=whole.get), limits


def predict(device, work, visits, threads):
    ns = 1e-9 / threads
    phases = {"direct": (work.direct_cpu_s / threads, "CPU", {})}

    still = 1.0 - A["l1_miss"]
    limits = added(
        device.limits([(work.light_paths, "path start")], A["code_lanes"], still),
        device.limits([(work.pool_rays, "reflection"),
                       *ray_items(work.pool_rays, visits["light_paths"])], A["rays_lanes"], still,
                      threads=65536))
    trips = math.ceil(work.light_paths / 16384)
    phases["light paths"] = phase(limits, {
        "CPU beside": 1e-9 * BESIDE_NS["path"] * work.light_paths +
                      ns * BESIDE_NS["vertex"] * work.pool_rays,
        "PCIe": device.pcie_s(VERTEX_DOWN * work.pool_rays),
        "launches": trips * (6 * A["launch_s"] + A["read_s"])})

    draws = work.connections / 0.9
    nodes = draws * cut_nodes(work.draws) / work.draws
    pieces = work.looks * math.ceil(work.receivers / RECEIVERS_PER_PIECE)
    vertices = work.pool_rays / work.replicates / 2  # of the largest batch
    limits = added(
        device.limits([(nodes, "weight"), (nodes, "share")], A["code_lanes"], 0.0,
                      RECEIVERS_PER_PIECE * cut_nodes(work.draws) * 12),
        device.limits(ray_items(work.connections, visits["connections"]), A["rays_lanes"], still,
                      threads=RECEIVERS_PER_PIECE * work.draws),
        device.limits([(draws, "draw"), (draws, "sum")], A["code_lanes"], 0.0, 64 * vertices,
                      threads=RECEIVERS_PER_PIECE * work.draws))
    up = VERTEX_UP * work.pool_rays + work.looks * work.receivers * (
        64 + 4 * cut_nodes(work.draws) / 32)
    phases["connections"] = phase(limits, {
        "CPU beside": ns * BESIDE_NS["connection"] * work.connections,
        "PCIe": device.pcie_s(up + 32 * work.looks * work.receivers),
        "launches": pieces * (12 * A["launch_s"] + A["read_s"])})

    first = work.near_rays / RAYS_PER_SHORT_RAY
    limits = device.limits([(first, "short ray"), *ray_items(first, visits["near_field"])],
                           A["rays_lanes"], still, threads=1 << 18)
    rest_ns = CPU_NS["near_ray"] * work.near_rays - FIRST_SHORT_RAY_NS * first
    phases["near field"] = phase(limits, {
        "CPU": ns * (rest_ns + BESIDE_NS["short_ray"] * first),
        "PCIe": device.pcie_s(12 * first),
        "launches": math.ceil(first / (1 << 20)) * (6 * A["launch_s"] + A["read_s"])})
    return phases


def cpu_phases(work, threads):
    ns = 1e-9 / threads
    return {"direct": work.direct_cpu_s / threads,
            "light paths": ns * CPU_NS["pool_ray"] * work.pool_rays,
            "connections": ns * CPU_NS["connection"] * work.connections,
            "near field": ns * CPU_NS["near_ray"] * work.near_rays}


def best_look(looks, points):
    return max((look for look in looks if look["points"] == points), key=lambda l: l["paths"])


def number(x):
    return f"{x:.2g}" if x < 100 else f"{x:.0f}"


def table(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def predictions(counts, visits, threads):
    rows = []
    for points in sorted({look["points"] for look in counts["looks"]}):
        for error in (0.01, 0.001):
            work = Work(best_look(counts["looks"], points), error)
            on_cpu = cpu_phases(work, threads)
            cpu_s = sum(on_cpu.values())
            rows.append([f"{points} to {100 * error:g} %", f"{threads} threads",
                         *(number(s) for s in on_cpu.values()), number(cpu_s), "", ""])
            for name in DEVICES:
                phases = predict(Device(name), work, visits, threads)
                whole = sum(s for s, _, _ in phases.values())
                best = sum(min(phases[what][0], on_cpu[what]) for what in phases)
                rows.append(["", name, *(f"{number(s)} ({why})" for s, why, _ in phases.values()),
                             number(whole), number(cpu_s / whole), number(cpu_s / best)])
    return table(["points, error", "by", "direct, s", "light paths, s", "connections, s",
                  "near field, s", "all, s", "CPU / all", "CPU / best stages"], rows)


def kernel_rates(counts, visits):
    """Of the device alone: items a second of each kind, and what limits them."""
    sizes = sorted({look["points"] for look in counts["looks"]})
    work = Work(best_look(counts["looks"], sizes[len(sizes) // 2]), 0.001)
    rows = []
    for name in DEVICES:
        device, row = Device(name), [name]
        for what in ("light paths", "connections", "near field"):
            _, _, limits = predict(device, work, visits, 1)[what]
            amount = {"light paths": work.pool_rays, "connections": work.connections,
                      "near field": work.near_rays / RAYS_PER_SHORT_RAY}[what]
            why = max(limits, key=limits.get)
            second = sorted(limits, key=limits.get)[-2]
            row.append(f"{number(1e-9 * amount / limits[why])} ({why}; {second} "
                       f"{100 * limits[second] / limits[why]:.0f} %)")
        rows.append(row)
    return table(["device", "rays of light paths, 1e9/s", "connections, 1e9/s",
                  "short rays, 1e9/s"], rows)


def cpu_check(counts):
    rows = []
    for look in counts["looks"]:
        work = Work.of_look(look)
        predicted, measured = cpu_phases(work, 1), look["seconds"]
        cells = []
        for name, key in (("light paths", "light_paths"), ("connections", "connections"),
                          ("near field", "near_field")):
            cells.append(f"{number(predicted[name])} / {number(measured[key])}")
        rows.append([str(look["points"]), str(look["paths"]), f"{100 * look['error']:.2f}", *cells])
    return table(["points", "paths", "error, %", "light paths, s", "connections, s",
                  "near field, s"], rows)


def stretch_check(counts):
    """Do counts and errors stretch as Work has it? From the smaller look to the larger one."""
    rows = []
    for points in sorted({look["points"] for look in counts["looks"]}):
        looks = sorted((l for l in counts["looks"] if l["points"] == points),
                       key=lambda l: l["paths"])
        for small, large in zip(looks, looks[1:]):
            work = Work.of_look(small)
            work.set_paths(small, [large["paths"]])
            paths = small["paths"] * (small["error"] / large["error"]) ** 2
            rows.append([str(points), f"{small['paths']} to {large['paths']}",
                         f"{paths / large['paths']:.2f}",
                         f"{work.connections / large['connections']:.2f}",
                         f"{work.near_rays / max(1, large['near_rays']):.2f}"])
    return table(["points", "paths", "paths for that error, predicted / true", "connections",
                  "near rays"], rows)


def software_check(counts, trees):
    """llvmpipe: the same instructions on vectors, but every word of a buffer is read lane by lane, also
    for lanes that only wait for others."""
    soft = counts.get("llvmpipe")
    if not soft:
        return ["Not measured."]
    draws = soft["draws"]
    visits = trees[soft["tree"]]  # as it was when it was measured
    nodes = cut_nodes(draws) / draws
    vectors = words = 0.0
    for count, kind in [*ray_items(1.0, visits["connections"]), (1.0, "draw"), (1.0, "sum"),
                        (nodes, "weight"), (nodes, "share")]:
        is_ray = kind in ("ray", "triangle test") or kind.startswith("node visit")
        lanes = A["rays_lanes"] if is_ray else A["code_lanes"]
        n32, n64, size = COUNTED[kind]
        vectors += count * (n32 + 2 * n64) / lanes / SOFTWARE["lanes"]
        words += count * (21 if kind == "weight" else size / 4) / lanes
    clocks = vectors / SOFTWARE["per_clock"] + words * SOFTWARE["word_clocks"]
    predicted = 1e9 * clocks / SOFTWARE["clock"]
    measured = soft["ns_per_connection"]
    reads = words * SOFTWARE["word_clocks"] / clocks
    return [f"Predicted {predicted:.0f} ns of processor time for a connection, measured {measured:.0f} "
            f"ns: {measured / predicted:.1f} times as much.",
            "Left out: barriers, which llvmpipe makes of switches between coroutines, and groups of 64 "
            f"for 17 draws. {100 * reads:.0f} % of the",
            "prediction are reads lane by lane, which no GPU does: llvmpipe does not check this model "
            "beyond its order of magnitude."]


def all_tables(counts, trees, visits, threads):
    yield from ["## Predicted", ""]
    yield from predictions(counts, visits, threads)
    yield from ["", "## The device alone", ""]
    yield from kernel_rates(counts, visits)
    yield from ["", "## Against the processor, predicted / measured on one thread", ""]
    yield from cpu_check(counts)
    yield from ["", "## Stretching counts to an error", ""]
    yield from stretch_check(counts)
    yield from ["", "## Against llvmpipe", ""]
    yield from software_check(counts, trees)
    yield from ["", "## Inputs", "", "Node visits and triangle tests of a ray:", ""]
    yield from table(["kind", "nodes", "triangles", "share that hits"],
                     [[kind, f"{v['nodes']:.1f}", f"{v['triangles']:.1f}", f"{v['hits']:.2f}"]
                      for kind, v in visits.items()])
    yield from ["", "Published (L2 rates: measured by others on H100, else assumed; PCIe one way):", ""]
    yield from table(["device", "fp32, Tflop/s", "fp64, Tflop/s", "memory, TB/s", "L2, MB",
                      "L2, TB/s", "PCIe, GB/s", "source"],
                     [[n, f"{2e-12 * Device(n).peak32:.1f}", f"{2e-12 * Device(n).peak64:.2f}",
                       f"{1e-12 * d['hbm']:g}", str(d["l2_mb"]), f"{1e-12 * d['l2']:g}",
                       f"{1e-9 * d['pcie']:g}", d["source"]] for n, d in DEVICES.items()])
    yield from ["", "Assumed:", ""]
    yield from table(["value", "what"], [[f"{v:g}", what] for v, what in ASSUMED.values()])
    yield from ["", "Instructions and bytes, counted by hand (how: `COUNTED` in gpu_model.py):", ""]
    yield from table(["of one", "fp32 and integer", "fp64", "bytes"],
                     [[kind, f"{a:.0f}", f"{b:.0f}", f"{c:.0f}"] for kind, (a, b, c) in COUNTED.items()])


def main():
    here = pathlib.Path(__file__).parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counts", type=pathlib.Path, default=here / "gpu_model_counts.json")
    parser.add_argument("--tree", choices=("eight", "binary"), default="eight")
    parser.add_argument("--visits", action="append", default=[], metavar="KIND=NODES,TRIANGLES")
    parser.add_argument("--threads", type=int, default=16, help="of the processor beside the device")
    parser.add_argument("--markdown", action="store_true", help="write gpu_model.md")
    parser.add_argument("--check", action="store_true",
                        help="end with 1 if gpu_model.md holds something else")
    options = parser.parse_args()
    counts = json.loads(options.counts.read_text(encoding="utf-8"))
    trees = json.loads((here / "gpu_model_visits.json").read_text(encoding="utf-8"))
    for name, kinds in trees.items():
        for kind in kinds.values():
            kind["tree"] = name
    visits = trees[options.tree]
    for given in options.visits:
        kind, _, values = given.partition("=")
        if kind not in visits:
            parser.error(f"--visits: '{kind}' is none of {', '.join(visits)}")
        visits[kind]["nodes"], visits[kind]["triangles"] = map(float, values.split(","))
    text = "\n".join(all_tables(counts, trees, visits, options.threads)) + "\n"
    if not options.markdown and not options.check:
        print(text, end="")
        return 0
    kept = (here / "gpu_model.md").read_text(encoding="utf-8")
    whole = kept.split("## Predicted")[0] + text
    if options.check:
        if whole != kept:
            print("gpu_model.md is not what gpu_model.py --markdown writes", file=sys.stderr)
        return int(whole != kept)
    (here / "gpu_model.md").write_text(whole, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
