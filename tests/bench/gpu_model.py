#!/usr/bin/env python3
"""What the GPU backend should take on devices, phase by phase, and what limits each phase.

    gpu_model.py [--counts FILE] [--visits KIND=NODES,TRIANGLES]... [--threads N]
                 [--markdown|--check]

Counted work (gpu_model_counts.json, by gpu_model_counts) times instructions counted by hand from the
shaders, over published rates. Node visits are an input: --visits connections=25,6 takes the place of
what is in the file, of connections, light_paths or near_field; proofs and shadow rays of direct light
follow connections. Nothing here was measured on a GPU.
"""

import argparse
import collections
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
    "l1_miss": (0.15, "share of node and triangle reads that L1 does not hold (50 kB of tree and triangles)"),
    "occupancy": (0.5, "share of the threads of an SM that registers leave room for"),
    "in_flight": (3.0, "passes of light paths and casts of short rays that fill the device together; of direct light 1"),
    "round_s": (1.5e-6, "of a round in which a tile opens groups of light vertices: four barriers and a read that nothing hides"),
    "rounds": (90.0, "such rounds of a tile; counted in that office: 50 to 82 for 256 groups, 79 to 112 for 1024"),
    "seen": (2.5, "groups that are looked at for each of a cut (counted: 2.3 to 2.8)"),
    "slots": (0.3, "of a cut, groups that are there in a round, on average (counted: 0.26 to 0.4)"),
    "sorts": (3.0, "of a tile's groups (counted: one, and one for each round that is cut short)"),
    "lit_share": (0.13, "hits of first short rays that may give light, of all first short rays (five rays each, counted)"),
    "hit_nodes": (128.0, "groups that a hit's light from afar is drawn from"),
    "bounds": (2.0, "luminaires whose photometry a hit's bound asks for, with a shadow ray each"),
    "later_steps": (0.06, "of hits, places of later steps of their chains (counted in three rooms: 5 to 6 of 100 hits go on)"),
    "left": (0.002, "light at hits that stays on the CPU: openings that fall into many parts, chains that go on for longer (counted: 0.1 to 0.7 of 100 hits in rooms)"),
    "cast_fill": (0.75, "of a cast of short rays: tasks are halves of halves of a plane's tiles"),
    "launch_s": (5e-6, "of a dispatch or an upload, processor and driver"),
    "read_s": (3e-5, "of a blocking read, beside its bytes"),
    "pcie_share": (0.5, "share of the published PCIe rate that plain buffers reach"),
    "proof_over_ray": (2.0, "node visits and triangles of a proof of free sight, over those of a shadow ray"),
    "children": (5.5, "children of a node (8.5 bytes of tree per triangle, leaves of 2.2 triangles)"),
    "in_box": (0.5, "share of them whose box meets that of the proof's pyramid, and is held against its planes"),
    "axes": (0.25, "share of a proof's triangles that no face of the pyramid separates: 9 to 10 more axes are tried"),
    "rest_lanes": (0.1, "lanes busy in samples of the rest: in a warp each takes a luminaire of its own"),
}
A = {name: value for name, (value, _) in ASSUMED.items()}

# --- instructions, by hand from the shaders -------------------------------------------------------
# (fp32 and integer, fp64, bytes). d: a division or root, counted by the assumption above.
D, F = A["double_divide"], A["float_divide"]
def half_spaces(n):
    """sight.glsl half_space: two sides 6, cross 9, three lengths 15 + 3 d, their product and a comparison 3, unit
    normal 3 + d, side of a place 8, turning it 4, height 5."""
    return n * (53 + 4 * D)


COUNTED = {
    # visibility.glsl, eight boxes at a time (a product and a sum in one). boxes_met: exponents 6, cell 3, begin 6,
    # slack 6, signs 3, choice of planes 12, early and late 6, joining 2 = 44. four_boxes_met: 6 words of 4 bytes taken
    # apart by shift, mask and conversion 72, planes 24, min/max 24, 4 comparisons, 4 and 6 to join them = 134, twice.
    # The loop: what waits 6 + 3 / 2, slot 4, push in one of two 3, address 5 + 5, four_times and mask 11, 4 others = 38.
    # Compilers may take bytes apart by the conversion alone: then 96 less.
    "node visit": (44 + 2 * 134 + 38, 0, 80),
    # closest_hit.glsl: in_order_of_ray and the slot's turn
    "node visit in order": (44 + 2 * 134 + 38 + 19, 0, 80),
    # is_crossed: 9 differences; 3 volumes of 6 + 9 + 5 (precise: nothing is fused) = 60; rounding 4;
    # inside 8; one in three goes on to slope, distance and division: (5 + 5 + F) / 3; the loop 15:
    # lowest bit 4, place among its like 5, addresses 3, limits 3
    "triangle test": (96 + (10 + F) / 3, 0, 48),
    # along, length, three reciprocals
    "ray": (16 + 4 * F, 0, 0),
    # find_draw.glsl: place 3; two binary searches of 8 and 4 steps; 3 divisions; 8 others.
    # connection_terms.glsl and the rest of trace.glsl: 60
    "draw": (60 + 12 * 8, 3 + 12 + 3 * D + 8, 64 + 12 * 8),
    # weigh.glsl of one receiver and node: 50 of node_terms.glsl, two exact quotients of 25 + F and an
    # exact root of 25 + F, 15 of addresses; reads 80 bytes, of which neighbours share most; writes 4
    "weight": (50 + 3 * (25 + F) + 15, 0, 4 + 80 / 32),
    # choose.glsl, one node seen from a tile: behind 14, distance 5 and an exact root of 25 + F, faces away 17, bound 2,
    # error 13 and two exact quotients of 25 + F, step 7, slot 9; reads four vectors
    "node seen": (67 + 3 * (25 + F), 0, 64),
    # one slot in a round: two looks of 6; of the sort, one comparison with its exchange
    "slot looked at": (12, 0, 0),
    "slot compared": (25, 0, 0),
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

    # hit_bounds, hit_direct, hit_further of one hit, beside photometry, rays, weights and draws: places and keys; the bound
    # asks what each of 12 luminaires may give most (17 + d), the choice twice what it is likely to give (60 and three exact
    # quotients or roots); direction and place of the further ray 85 + 5 d and 107
    "hit": (600 + 2 * 12 * (60 + 3 * (25 + F)), 250 + 12 * (17 + D) + 192 + 5 * D, 96 + 3 * 64 + 6 * 128),

    # --- direct light. key_with: twice mix_bits of 4 + 3 * 6 + 2 * 6, and 2 = 70 (mix: 34)
    # lamps.glsl point_illuminance_lx and intensity_cd. Way 3, response 6, length 5 + d, direction 3 + d, in_table 15,
    # quotient 4 + d; across 3 + d; angle_of twice: radius 3 + d, two quotients, conversions 3, turns 1 + d,
    # sine and cosine 28, rest 9 + d = 44 + 5 d, its float arc tangent 28 + F; searches of 7 and 6 steps (5, 1, 8 bytes
    # each); shares of intervals 2 (4 + d); bilinear 15, comparisons 6; 20 of addresses; reads 10 doubles more
    "photometry": (2 * (28 + F) + 13 * 5 + 20, 36 + 3 * D + 3 + D + 2 * (44 + 5 * D) + 13 + 2 * (4 + D) + 21,
                   13 * 8 + 80),
    # classified() of a point opening beside its photometry and ray: lamp and point 33 and 3, reach 6, lifts 20; one word
    "point pair": (60, 30, 64 + 5 + 4),
    # One pair with a proof, beside its rays and nodes: lamp, point and corners 95, four distances 9 + d, pyramid 5 half
    # spaces, edges 18, bounds and margins 40, conversions 12, the same in float 30 and 40; patch_of 41 + 3 d. Lamps are
    # read once by a warp.
    "proof": (160, 30 + 95 + 4 * (9 + D) + half_spaces(5) + 70 + 41 + 3 * D, 64 + 5 + 4),
    # boxes_met_by, in float: of each child 6 planes of 6; 6 differences, 12 comparisons, and where they hold 5 half spaces of
    # 3 (choice of the corner) and 6. The loop as of a ray, slots_of 12, rounding 9
    "proof node visit": (59 + A["children"] * (54 + A["in_box"] * 45), 0, 80),
    # is_outside, in float: rounding 12, differences 9, three planes of 20 where one separates, else five; then
    # meets_triangle: conversions 9, five planes of 19 and half of 19 axes of cross 9, 8 dots of 5, 12 min/max, 6 to decide
    "proof triangle": (40 + 21 + (1 - A["axes"]) * 3 * 20 + A["axes"] * 5 * 20, A["axes"] * (9 + 5 * 19 + 9.5 * 67), 48),
    # is_covered by two triangles: 2 + 1 + 8 half spaces and some 25 places held against them, 6 each
    "hidden": (100, half_spaces(11) + 150, 4 * 48),
    # direct_seen.glsl beside places: lamp and point; patch_of 41 + 3 d; six curves of 6; unseen light 17 + d; mean 8, rest 6
    "patch": (40, 3 + 41 + 3 * D + 36 + 17 + D + 14, 64 + 5 + 16 + 4),
    # place_lx and sketched_lx, float but for the way: way 9, response 6, in_table 18, factor 2, conversions 7, others 4;
    # two arc tangents of 20 + F, two roots and a quotient, 43 of the table
    "place": (12 + 2 * (20 + F) + 3 * F + 43, 46, 16),
    # direct_sums.glsl, one pair and channel: two words of light read, one written
    "pair summed": (12, 3, 4 + 16 + 8),
    # direct_samples.glsl, one pair and replicate: 5 keys, view 30 + 3 d, samples 15 + d, sums
    "chunk": (5 * 70 + 60, 45 + 4 * D, 64 + 5 + 16 + 16),
    # one of its samples beside photometry and ray: two Sobol' samples of four steps 80 and 2, place 15, lift 14, others 12
    "opening sample": (2 * 80 + 20, 4 + 15 + 14 + 12, 0),
    # direct_totals.glsl, one luminaire passed in a replicate: the number that chooses is made anew at each:
    # two keys, fraction 4, quotient 5 + d, 3 comparisons
    "luminaire passed": (2 * 70 + 15, 12 + D, 4 + 8),
    # a sample of the rest beside its patch, places and photometry: three keys, polynomial 13, numbers 12, quotients
    "rest sample": (3 * 70 + 20, 25 + 2 * D, 8),
}

# --- the processor beside it: one thread, measured ------------------------------------------------
CPU_NS = {"connection": 95.0, "pool_ray": 480.0, "near_ray": 300.0, "direct_ray": 300.0,
          "known_opening": 350.0, "known_rest": 400.0, "obstructed": 800.0}  # calc/forecast/cost_model.cpp
# path: by the thread that owns the device, for all others; path_taken, as all else, by any thread.
BESIDE_NS = {"receiver": 55.0, "path": 10.0, "path_taken": 60.0, "vertex": 45.0 + 25.0, "short_ray": 8.0, "pair": 2.0}
FIRST_SHORT_RAY_NS = 75.0
RAYS_PER_SHORT_RAY = 1.7
VERTEX_UP, VERTEX_DOWN = 168, 48
# llvmpipe: floats of a vector of 256 bits, vectors a clock and clocks for a word of a buffer (both
# assumed), clocks a second (measured)
SOFTWARE = dict(lanes=8, per_clock=2.0, word_clocks=5.0, clock=2.46e9)
# gpu/rays/gl_direct_tracer: pairs of a piece; dispatches begin with 4096 pairs and double, in three stages
PAIRS_PER_PIECE, POINTS_PER_BATCH, FIRST_DISPATCHES = 1 << 20, 1 << 14, 3 * 8
PIECES_TOGETHER = 8  # gpu/gather/draw_queue
MOST_PLACES, MOST_WEIGHTS = 1 << 22, 1 << 23  # gpu/gather/draw_piece: of what goes together
LAUNCHES_PER_CAST = 50  # rays, counts, list; of three steps seven each, the first in two parts; ends, sums; fills and copies
LAUNCHES_PER_PIECE = 11  # five dispatches, three or four fills, two copies back

# A plane below many panels, first round. Shares of pairs: measured, 74 to 95 % free, of the rest half hidden, 2.6 to
# 4.8 % of all penumbra. rest: samples of a point, channel and replicate, 2 to 16 (assumed: 4).
PANELS = dict(count=204, seen=0.90, hidden=0.06, sampled=0.04, samples=14, places=9, rest=4, replicates=16, channels=1)


def draws_per_point(paths, points):
    """calc::draws_per_point()"""
    wanted = min(max(16 * paths // max(1, points), max(paths // 64, 16)), max(paths // 2, 16))
    return 1 << (wanted.bit_length() - 1)


def cut_nodes(draws):
    """calc/radiosity/gather/plane_connect.cpp"""
    return min(max(16 * draws, 128), max(1024, draws))


def receivers_per_piece(draws, work, threads):
    """gpu/gather/draw_piece: as many as its lists hold and as a thread has, in 64 to 1024 tiles of 32; of one replicate."""
    wanted = min(MOST_PLACES // (draws + 1), MOST_WEIGHTS // cut_nodes(draws), work.receivers // threads)
    return min(max(wanted, 64 * 32), 1024 * 32, work.points)


def pieces_together(draws, work, threads):
    """gpu/gather/draw_queue: where more wait, up to eight that take no more room than one large one."""
    receivers = receivers_per_piece(draws, work, threads)
    fitting = min(MOST_PLACES // (draws + 1), MOST_WEIGHTS // cut_nodes(draws)) // receivers
    return max(1, min(PIECES_TOGETHER, fitting, threads // 2))


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
        self.draws, self.drawn = drawn[-1], drawn
        shares = [draws / draws_per_point(look["paths"], self.points) for draws in drawn]
        self.connections = look["connections"] * sum(shares)
        # They follow variance, not draws: measured, see "Stretching".
        self.near_rays = look["near_rays"] * sum(math.sqrt(share) for share in shares)
        self.receivers = self.points * self.replicates  # of one look
        self.direct_rays = look["direct_rays"]  # point luminaires: exact, however many looks


class Device:
    def __init__(self, name):
        self.__dict__.update(DEVICES[name])
        self.name = name
        self.peak32 = self.sms * self.fp32 * self.clock
        self.peak64 = self.sms * self.fp64 * self.clock
        self.l1 = self.sms * A["l1_bytes_per_clock"] * self.clock
        self.resident = self.sms * self.threads

    def limits(self, items, lanes, l1_share, pool_bytes=0.0, threads=math.inf, pieces=A["in_flight"]):
        """items: (count, kind). Seconds by limit: the largest is the time of the device's part."""
        fill = min(1.0, pieces * threads / (A["occupancy"] * self.resident))
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


def ray_items(rays, visits, node="node visit"):
    return [(rays, "ray"), (rays * visits["nodes"], node),
            (rays * visits["triangles"], "triangle test")]


def ordered(rays, visits):
    """Closest hits."""
    return ray_items(rays, visits, "node visit in order")


def added(*parts):
    return {key: sum(part[key] for part in parts) for key in parts[0]}


Phase = collections.namedtuple("Phase", "seconds why limits others beside_s")


def phase(limits, others, beside_s=None):
    """The device's largest limit, and what comes before and after it, one after the other. beside_s: of the device
    where it works on several waves at a time."""
    name = max(limits, key=limits.get)
    whole = {name: limits[name], **others}
    return Phase(sum(whole.values()), max(whole, key=whole.get), limits, others,
                 limits[name] if beside_s is None else beside_s)


def direct_phase(device, limits, pairs, points, pieces, bytes_down, launches, reads, list_bytes=0.0):
    # One caller looks at a piece while the device has the next.
    caller_s, device_s = 1e-9 * BESIDE_NS["pair"] * pairs, max(limits.values())
    return phase(limits, {
        "CPU beside": caller_s / pieces + max(0.0, caller_s * (1.0 - 1.0 / pieces) - device_s),
        "PCIe": device.pcie_s(64 * points + list_bytes + 4 * pairs + bytes_down),
        "launches": pieces * (launches * A["launch_s"] + reads * A["read_s"]) +
                    FIRST_DISPATCHES * A["read_s"]})


def direct_of_points(device, pairs, points, visits):
    """Point luminaires, one channel. Light is read once to know whether a ray is worth it, and once more to add it."""
    still, pieces = 1.0 - A["l1_miss"], math.ceil(pairs / PAIRS_PER_PIECE)
    threads = pairs / pieces
    limits = added(
        device.limits([(2 * pairs, "photometry"), (pairs, "point pair")], A["code_lanes"], still,
                      threads=threads, pieces=1),
        device.limits(ray_items(pairs, visits["connections"]), A["rays_lanes"], still,
                      threads=threads, pieces=1),
        device.limits([(pairs, "pair summed")], A["code_lanes"], 0.0, 16 * threads,
                      threads=points / pieces, pieces=1))
    return direct_phase(device, limits, pairs, points, pieces, 8 * points, 14, 2)


def panel_stages(device, points, visits):
    """Seconds by limit of each of the device's stages below PANELS."""
    p, still = PANELS, 1.0 - A["l1_miss"]
    pairs = points * p["count"]
    in_batches = [POINTS_PER_BATCH] * (points // POINTS_PER_BATCH) + [points % POINTS_PER_BATCH]
    pieces = sum(math.ceil(n / (PAIRS_PER_PIECE // p["count"])) for n in in_batches)
    in_piece = dict(pieces=1, threads=pairs / pieces)
    light = dict(pool_bytes=20 * pairs / pieces)
    seen, jobs = p["seen"] * pairs, p["sampled"] * pairs * p["replicates"]
    totals = points * p["channels"] * p["replicates"]
    samples, rest, ray = jobs * p["samples"], totals * p["rest"], visits["connections"]
    more = A["proof_over_ray"]
    return pieces, {
        "proofs": added(
            device.limits([(pairs, "proof"), (p["hidden"] * pairs, "hidden")], A["code_lanes"], still,
                          **in_piece),
            device.limits([*ordered(4 * pairs, ray), (more * ray["nodes"] * seen, "proof node visit"),
                           (more * ray["triangles"] * seen, "proof triangle")], A["rays_lanes"], still,
                          **in_piece)),
        "seen": added(
            device.limits([(seen, "patch"), (p["places"] * seen, "place")], A["code_lanes"] * p["seen"], still,
                          **in_piece),
            device.limits([(pairs * p["channels"], "pair summed")], A["code_lanes"], 0.0,
                          pieces=1, threads=points / pieces, **light)),
        "samples": added(
            device.limits([(jobs, "chunk"), (samples, "opening sample"), (samples, "photometry")],
                          A["code_lanes"], still, pieces=1, threads=jobs / pieces),
            device.limits(ray_items(samples, ray), A["rays_lanes"], still,
                          pieces=1, threads=jobs / pieces)),
        "rest": added(
            device.limits([(totals * p["count"], "luminaire passed")], A["code_lanes"], 0.0,
                          pieces=1, threads=totals / pieces, **light),
            device.limits([(rest, "rest sample"), (rest, "patch"), (rest * p["places"], "place"),
                           (rest, "photometry")], A["rest_lanes"], still,
                          pieces=1, threads=totals / pieces))}


def direct_of_panels(device, points, visits):
    p = PANELS
    pieces, stages = panel_stages(device, points, visits)
    down = 8 * points * (p["replicates"] * (p["channels"] + 1) + p["channels"])
    return direct_phase(device, added(*stages.values()), points * p["count"], points, pieces, down, 20, 3,
                        16 * p["sampled"] * points * p["count"])


def panels_cpu_s(points, threads):
    """predict() of cost_model.cpp"""
    p = PANELS
    pairs = points * p["count"]
    return 1e-9 / threads * (
        CPU_NS["known_opening"] * p["seen"] * pairs +
        CPU_NS["known_rest"] * p["replicates"] * p["channels"] * points +
        CPU_NS["obstructed"] * (p["hidden"] + p["sampled"]) * pairs +
        CPU_NS["direct_ray"] * p["sampled"] * pairs * p["samples"] * p["replicates"])


def choose_items(work):
    """Cuts of all tiles."""
    items = {"node seen": 0.0, "slot looked at": 0.0, "slot compared": 0.0}
    for draws in work.drawn:
        tiles, cut = work.receivers / 32, cut_nodes(draws)
        width = math.ceil(math.log2(cut))
        items["node seen"] += A["seen"] * cut * tiles
        items["slot looked at"] += A["rounds"] * A["slots"] * cut * tiles
        items["slot compared"] += A["sorts"] * width * (width + 1) / 2 * cut / 2 * tiles
    return [(count, kind) for kind, count in items.items()]


def predict(device, work, visits, threads):
    ns = 1e-9 / threads
    phases = {"direct": direct_of_points(device, work.direct_rays, work.points, visits)}

    still = 1.0 - A["l1_miss"]
    limits = added(
        device.limits([(work.light_paths, "path start")], A["code_lanes"], still),
        device.limits([(work.pool_rays, "reflection"),
                       *ordered(work.pool_rays, visits["light_paths"])], A["rays_lanes"], still,
                      threads=65536))
    trips = math.ceil(work.light_paths / 16384)
    phases["light paths"] = phase(limits, {
        "one thread": 1e-9 * BESIDE_NS["path"] * work.light_paths,
        "CPU beside": ns * (BESIDE_NS["path_taken"] * work.light_paths + BESIDE_NS["vertex"] * work.pool_rays),
        "PCIe": device.pcie_s(VERTEX_DOWN * work.pool_rays),
        "launches": trips * (6 * A["launch_s"] + A["read_s"])})

    draws = work.connections / 0.9
    nodes = draws * cut_nodes(work.draws) / work.draws
    per_piece = receivers_per_piece(work.draws, work, threads)
    pieces = {n: math.ceil(work.receivers / receivers_per_piece(n, work, threads)) for n in set(work.drawn)}
    waves = sum(math.ceil(pieces[n] / pieces_together(n, work, threads)) for n in work.drawn)
    pieces = sum(pieces[n] for n in work.drawn)
    together = pieces_together(work.draws, work, threads)
    vertices = work.pool_rays / work.replicates / 2  # of the largest batch
    rays = device.limits(ray_items(work.connections, visits["connections"]), A["rays_lanes"], still,
                         threads=per_piece * work.draws, pieces=together)
    chosen = choose_items(work)
    choice = device.limits(chosen, A["code_lanes"], 0.0, 128 * vertices, threads=2 * per_piece, pieces=together)
    rest = added(
        device.limits([(nodes, "weight"), (nodes, "share")], A["code_lanes"], 0.0,
                      per_piece * cut_nodes(work.draws) * 12),
        rays,
        device.limits([(draws, "draw"), (draws, "sum")], A["code_lanes"], 0.0, 64 * vertices,
                      threads=per_piece * work.draws, pieces=together))
    receivers = work.receivers * work.looks
    rounds_s = waves * A["rounds"] * A["round_s"]
    # Rounds of a wave beside the rays of the one before.
    beside_s = max(max(choice.values()) + rounds_s,
                   max(added(device.limits(chosen, A["code_lanes"], 0.0, 128 * vertices), rest).values()))
    phases["connections"] = phase(added(choice, rest), {
        "CPU beside": ns * BESIDE_NS["receiver"] * receivers,
        # Points go up once for all replicates of a look.
        "PCIe": device.pcie_s(VERTEX_UP * work.pool_rays + receivers * ((64 + 48 / 32) / work.replicates + 32)),
        "rounds": rounds_s,
        "launches": pieces * LAUNCHES_PER_PIECE * A["launch_s"] + waves * A["read_s"]}, beside_s)

    first = work.near_rays / RAYS_PER_SHORT_RAY
    hits = A["lit_share"] * first
    steps = (1.0 + A["later_steps"]) * hits
    light_ns = CPU_NS["near_ray"] * work.near_rays - FIRST_SHORT_RAY_NS * first
    shadow_rays = steps * (A["bounds"] + 1 + 4)
    limits = added(
        device.limits([(first, "short ray"), *ordered(first, visits["near_field"])],
                      A["rays_lanes"], still, threads=1 << 18),
        device.limits([(steps, "hit"), ((A["bounds"] + 1) * steps, "photometry"),
                       *ray_items(shadow_rays, visits["connections"]), *ordered(steps, visits["near_field"])],
                      A["rays_lanes"], still, threads=1 << 16, pieces=1),
        device.limits([(A["hit_nodes"] * steps, "weight"), (A["hit_nodes"] * steps, "share"), (4 * steps, "draw")],
                      A["code_lanes"], 0.0, 64 * vertices, threads=1 << 16, pieces=1))
    casts = math.ceil(first / (A["cast_fill"] * (1 << 18)))  # kShortRaysPerCast
    phases["near field"] = phase(limits, {
        "CPU beside": ns * (A["left"] * light_ns + BESIDE_NS["short_ray"] * first),
        # Up: points, and which of them; down: sums, and one in eight hits.
        "PCIe": device.pcie_s((8 + 80 / work.replicates + 24) * work.receivers * work.looks + 112 / 8 * hits),
        "launches": casts * (LAUNCHES_PER_CAST * A["launch_s"] + 3 * A["read_s"])})
    return phases


def cpu_phases(work, threads):
    ns = 1e-9 / threads
    return {"direct": ns * CPU_NS["direct_ray"] * work.direct_rays,
            "light paths": ns * CPU_NS["pool_ray"] * work.pool_rays,
            "connections": ns * CPU_NS["connection"] * work.connections,
            "near field": ns * CPU_NS["near_ray"] * work.near_rays}


def side_by_side(phases, on_cpu):
    """The whole run, each stage where it is faster, if the device, the thread that owns it and all others never wait
    for each other: whoever has most to do. Rounds of one wave run beside the rays of another."""
    device_s = thread_s = cpu_s = 0.0
    for what, part in phases.items():
        if part.seconds > on_cpu[what]:
            cpu_s += on_cpu[what]
            continue
        device_s += part.beside_s + part.others["PCIe"]
        thread_s += part.others.get("one thread", 0.0) + part.others["launches"]
        cpu_s += part.others.get("CPU beside", 0.0)
    whole = {"device": device_s, "one thread": thread_s, "all threads": cpu_s}
    most = max(whole, key=whole.get)
    return whole[most], most


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
                         *(number(s) for s in on_cpu.values()), number(cpu_s), "", "", ""])
            for name in DEVICES:
                phases = predict(Device(name), work, visits, threads)
                whole = sum(s for s, *_ in phases.values())
                best = sum(min(phases[what][0], on_cpu[what]) for what in phases)
                beside, most = side_by_side(phases, on_cpu)
                rows.append(["", name, *(f"{number(s)} ({why})" for s, why, *_ in phases.values()),
                             number(whole), number(cpu_s / whole), number(cpu_s / best),
                             "{} ({})".format(number(cpu_s / beside), most)])
    return table(["points, error", "by", "direct, s", "light paths, s", "connections, s",
                  "near field, s", "all, s", "CPU / all", "CPU / best stages", "side by side"], rows)


def panel_table(visits, threads):
    rows = []
    for points in (1000, 10000, 100000):
        cpu_s = panels_cpu_s(points, threads)
        rows.append([str(points), f"{threads} threads", number(cpu_s), "", "", "", "", "", ""])
        for name in DEVICES:
            device = Device(name)
            whole, why, limits, *_ = direct_of_panels(device, points, visits)
            _, stages = panel_stages(device, points, visits)
            most = max(limits, key=limits.get)
            rows.append(["", name, f"{number(whole)} ({why})", *(number(s[most]) for s in stages.values()),
                         number(1e-9 * BESIDE_NS["pair"] * points * PANELS["count"]), number(cpu_s / whole)])
    return table(["points", "by", "direct, s", *(f"{s}, s" for s in ("proofs", "seen", "samples", "rest")),
                  "caller, s", "gain"], rows)


WAITS = ("CPU beside", "one thread", "PCIe", "rounds", "launches")


def what_is_left(counts, visits, threads):
    """The largest run, by best stages: what it takes the device, and what the CPU still does."""
    points = max(look["points"] for look in counts["looks"])
    work = Work(best_look(counts["looks"], points), 0.001)
    on_cpu, rows = cpu_phases(work, threads), []
    for name in DEVICES:
        device = Device(name)
        phases = predict(device, work, visits, threads)
        best = {what: min(phases[what][0], on_cpu[what]) for what in phases}
        taken = [phases[what] for what in phases if phases[what][0] <= on_cpu[what]]
        device_s = sum(max(part.limits.values()) for part in taken)
        other = {}
        for part in taken:
            for what, s in part.others.items():
                other[what] = other.get(what, 0.0) + s
        left = sum(on_cpu[what] for what in phases if phases[what][0] > on_cpu[what])
        rows.append([name, number(sum(best.values())), number(device_s),
                     *(number(other.get(what, 0.0)) for what in WAITS),
                     number(left), number(sum(on_cpu.values()) / sum(best.values())),
                     number(sum(on_cpu.values()) / side_by_side(phases, on_cpu)[0])])
    return table(["device", "all, s", "device, s", *(f"{what}, s" for what in WAITS),
                  "stages that stay on the CPU, s", "gain", "side by side"], rows)


def kernel_rates(counts, visits):
    """Of the device alone: items a second of each kind, and what limits them."""
    sizes = sorted({look["points"] for look in counts["looks"]})
    work = Work(best_look(counts["looks"], sizes[len(sizes) // 2]), 0.001)
    rows = []
    for name in DEVICES:
        device, row = Device(name), [name]
        for what in ("light paths", "connections", "near field"):
            limits = predict(device, work, visits, 16)[what].limits
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


def software_check(counts, visits):
    """llvmpipe: the same instructions on vectors, but every word of a buffer is read lane by lane, also
    for lanes that only wait for others."""
    soft = counts.get("llvmpipe")
    if not soft:
        return ["Not measured."]
    draws = soft["draws"]
    nodes = cut_nodes(draws) / draws
    vectors = words = 0.0
    for count, kind in [*ray_items(1.0, visits["connections"]), (1.0, "draw"), (1.0, "sum"),
                        (nodes, "weight"), (nodes, "share")]:
        is_ray = kind in ("ray", "node visit", "triangle test")
        lanes = A["rays_lanes"] if is_ray else A["code_lanes"]
        n32, n64, size = COUNTED[kind]
        vectors += count * (n32 + 2 * n64) / lanes / SOFTWARE["lanes"]
        words += count * (21 if kind == "weight" else size / 4) / lanes
    clocks = vectors / SOFTWARE["per_clock"] + words * SOFTWARE["word_clocks"]
    predicted = 1e9 * clocks / SOFTWARE["clock"]
    measured = soft["ns_per_connection"]
    reads = words * SOFTWARE["word_clocks"] / clocks
    return [f"Predicted {predicted:.0f} ns of processor time for a connection, measured {measured:.0f} "
            f"ns{soft.get('made', '')}: {measured / predicted:.1f} times as much.",
            "Left out: barriers, which llvmpipe makes of switches between coroutines, and groups of 64 "
            f"for 17 draws. {100 * reads:.0f} % of the",
            "prediction are reads lane by lane, which no GPU does: llvmpipe does not check this model "
            "beyond its order of magnitude."]


def all_tables(counts, visits, threads):
    yield from ["## Predicted", ""]
    yield from predictions(counts, visits, threads)
    yield from ["", "## Direct light of 204 panels", "",
                f"First round, {PANELS['replicates']} replicates, {PANELS['channels']} channel; stages by the limit "
                "that is largest in all.", ""]
    yield from panel_table(visits, threads)
    yield from ["", "## What is left", "",
                f"{max(l['points'] for l in counts['looks'])} points to 0.1 %, each stage where it is faster, "
                f"against {threads} threads.", ""]
    yield from what_is_left(counts, visits, threads)
    yield from ["", "## The device alone", ""]
    yield from kernel_rates(counts, visits)
    yield from ["", "## Against the processor, predicted / measured on one thread", ""]
    yield from cpu_check(counts)
    yield from ["", "## Stretching counts to an error", ""]
    yield from stretch_check(counts)
    yield from ["", "## Against llvmpipe", ""]
    yield from software_check(counts, visits)
    yield from ["", "## Inputs", "", "Node visits and triangle tests of a ray: " + counts["visits"].get("made", "counted."), ""]
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
    parser.add_argument("--visits", action="append", default=[], metavar="KIND=NODES,TRIANGLES")
    parser.add_argument("--threads", type=int, default=16, help="of the processor beside the device")
    parser.add_argument("--markdown", action="store_true", help="write gpu_model.md")
    parser.add_argument("--check", action="store_true",
                        help="end with 1 if gpu_model.md holds something else")
    options = parser.parse_args()
    counts = json.loads(options.counts.read_text(encoding="utf-8"))
    visits = {k: dict(v) for k, v in counts["visits"].items() if isinstance(v, dict)}
    for given in options.visits:
        kind, _, values = given.partition("=")
        if kind not in visits:
            parser.error(f"--visits: '{kind}' is none of {', '.join(visits)}")
        visits[kind]["nodes"], visits[kind]["triangles"] = map(float, values.split(","))
    text = "\n".join(all_tables(counts, visits, options.threads)) + "\n"
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
