"""Rooms as users have them, and what they cost: for simulate_cluster.py.

    cluster_rooms.py LUXGATE FOLDER    makes the rooms in FOLDER, measures them and prints MEASURED; minutes

The last number that it prints of a room is what the closing job takes for it, in ms.
"""
import json
import math
import pathlib
import random
import resource
import shutil
import subprocess
import sys
from dataclasses import dataclass

# Of rooms as this program makes them: predicted first look (s), true processor time (s), looks kept, kB kept. One thread; the true time
# is the difference of runs over five such rooms and over one, the better of two. The share of each kind in the batch is assumed.
MEASURED = {
    "small office": [
        (0.0115, 0.0118, 1, 16), (0.0161, 0.0144, 2, 32), (0.0115, 0.0119, 1, 16), (0.0138, 0.0186, 2, 32), (0.0113, 0.0146, 1, 16),
        (0.0115, 0.0102, 1, 16), (0.0105, 0.0170, 1, 16), (0.0114, 0.0183, 1, 16), (0.0104, 0.0177, 1, 16), (0.0102, 0.0148, 1, 16),
        (0.0114, 0.0164, 1, 16), (0.0102, 0.0123, 1, 16), (0.0165, 0.0182, 2, 32), (0.0165, 0.0203, 2, 32), (0.0139, 0.0200, 2, 32),
        (0.0115, 0.0168, 1, 16), (0.0160, 0.0254, 2, 32), (0.0163, 0.0120, 2, 32), (0.0163, 0.0266, 2, 32), (0.0113, 0.0127, 1, 16)],
    "office": [
        (0.0408, 0.0502, 7, 110), (0.0302, 0.0408, 5, 79), (0.0352, 0.0505, 6, 95), (0.0476, 0.0326, 8, 126), (0.0264, 0.2299, 8, 126),
        (0.0309, 0.0455, 5, 79), (0.0264, 0.0367, 4, 63), (0.0447, 0.0444, 8, 126), (0.0354, 0.0486, 6, 95), (0.0431, 0.0399, 7, 110),
        (0.0310, 0.0382, 5, 79), (0.0261, 0.0398, 4, 63), (0.0161, 0.0095, 2, 32), (0.0358, 0.0375, 6, 95), (0.0306, 0.0295, 5, 79),
        (0.0216, 0.0236, 3, 47), (0.0217, 0.0221, 3, 47), (0.0168, 0.0289, 2, 32), (0.0401, 0.0370, 7, 110), (0.0458, 0.0549, 8, 126),
        (0.0465, 0.0473, 8, 126), (0.0306, 0.0339, 5, 79), (0.0253, 0.0391, 4, 63), (0.0157, 0.0419, 2, 32)],
    "corridor": [
        (0.0167, 0.0401, 1, 94), (0.0172, 0.0396, 1, 94), (0.0154, 0.0522, 1, 94), (0.0157, 0.0382, 1, 94), (0.0164, 0.0344, 1, 94),
        (0.0166, 0.0541, 1, 94), (0.0166, 0.0434, 1, 94), (0.0172, 0.0534, 1, 94), (0.0154, 0.0287, 1, 94), (0.0165, 0.0483, 1, 94),
        (0.0157, 0.0408, 1, 94), (0.0169, 0.0334, 1, 94), (0.0165, 0.0531, 1, 94), (0.0172, 0.0372, 1, 94), (0.0168, 0.0321, 1, 94),
        (0.0155, 0.0312, 1, 94)],
    "classroom": [
        (0.0205, 0.0409, 2, 121), (0.0189, 0.0490, 2, 121), (0.0193, 0.0473, 2, 121), (0.0201, 0.0488, 2, 121), (0.0189, 0.0662, 2, 121),
        (0.0199, 0.0508, 2, 121), (0.0187, 0.0618, 2, 121), (0.0224, 0.0393, 2, 121), (0.0217, 0.0293, 2, 121), (0.0210, 0.0428, 2, 121),
        (0.0205, 0.0406, 2, 121), (0.0200, 0.0373, 2, 121)],
    "racks": [
        (0.0595, 0.0698, 3, 156), (0.0973, 0.6375, 13, 573), (0.1142, 0.2760, 11, 476), (0.0890, 0.1519, 7, 393), (0.0912, 0.3621, 11, 423),
        (0.0282, 0.3799, 7, 244), (0.0585, 0.0622, 4, 210), (0.0935, 0.1015, 5, 314), (0.0688, 0.0542, 2, 125), (0.0713, 0.1031, 6, 289),
        (0.0788, 0.4962, 14, 684), (0.0261, 0.0952, 4, 140)],
    "hall": [
        (0.1432, 0.1940, 3, 2228), (0.1317, 0.4553, 5, 3713), (0.1545, 0.1309, 1, 743), (0.1731, 0.1597, 1, 743), (0.1420, 0.1252, 1, 743),
        (0.1493, 0.1972, 4, 2970), (0.1025, 0.1210, 1, 743), (0.1369, 0.1528, 1, 743)],
    "open plan": [
        (0.1397, 0.1100, 24, 378), (0.1929, 0.1919, 34, 536), (0.1155, 0.3793, 28, 441), (0.1627, 0.1506, 29, 457), (0.1577, 0.1585, 28, 441),
        (0.1565, 0.1555, 27, 426)],
    "large hall": [
        (10.4084, 9.4173, 4, 123604)]}
SHARE = {"small office": 0.30, "office": 0.25, "corridor": 0.20, "classroom": 0.12, "racks": 0.08, "hall": 0.025, "open plan": 0.024,
         "large hall": 0.001}

# Measured, processor seconds of one thread. P = twenty copies of users_projects.py's two-hundred-rooms (4,000 rooms, one look each):
START_S = 0.045          # check P --store S --shard 1/1 --units none.json          a list without units
LIST_S = 8.6e-6          # check P --store S --shard 1/1000 --units list.json       a unit of the list: 1e5 units and 2e4
LIST_BYTES = 190         # the same: bytes of a unit in the list
LOAD_S = 0.04e-3         # check P --store S --shard 1/1 --units one-each.json      a room of a project that is read for another room
FIRST_SCENE_S = 0.012    # the same: what the first room of a process costs once
ROOM_BYTES = 525         # a room in a project file
PLAN_S = 0.23e-3         # plan P --units --format json                             a room
CLOSE_ROOM_S, CLOSE_LOOK_S, CLOSE_MB_S = 0.2e-3, 0.084e-3, 0.013  # check --store S --stored-only --pictures off: fitted to this program's rooms
REPORT_S = 1.4e-3        # check P --store S --stored-only --pictures off --format csv=x.csv --format html=x.html --html-split: what a room costs more
WRITE_CALLS, READ_CALLS, PROJECT_CALLS = 8, 4, 8  # strace: calls to the file system that name or ask for a file, for a look, a project
PANEL = "examples/photometry/batwing_1200.ies"


@dataclass
class Batch:
    predicted: list  # by unit: seconds of the first look
    true: list
    looks: list
    bytes: list
    project: list
    rooms_of_project: int


def make_batch(units, rooms_of_project=20, scale=1.0, seed=1):
    """Rooms drawn from those measured, sizes varied a little; projects are mixed."""
    chance = random.Random(seed)
    kinds = chance.choices(list(SHARE), list(SHARE.values()), k=units)
    batch = Batch([], [], [], [], [u // rooms_of_project for u in range(units)], rooms_of_project)
    for kind in kinds:
        predicted, true, looks, kilobytes = chance.choice(MEASURED[kind])
        size = math.exp(chance.gauss(0, 0.2)) * scale
        batch.predicted.append(predicted * size)
        batch.true.append(true * size)
        batch.looks.append(round(looks))
        batch.bytes.append(kilobytes * 1000)
    return batch


def room_text(kind, chance):
    """A room with furniture, planes and limits by chance: limits lie near and far from what will be measured."""
    def uniform(low, high):
        return chance.uniform(low, high)
    (wide, deep, high), step, planes, boxes, points = {
        "small office": ((uniform(2.5, 5), uniform(3, 6), 2.8), 2.4, chance.randint(1, 2), chance.randint(0, 3), (8, 6)),
        "office": ((uniform(6, 14), uniform(5, 9), 3), 2.6, chance.randint(2, 8), chance.randint(4, 14), (8, 6)),
        "corridor": ((uniform(10, 45), uniform(1.5, 2.5), 2.6), 3.5, 1, 0, (60, 5)),
        "classroom": ((uniform(8, 11), uniform(6, 8), 3.2), 2.5, 2, chance.randint(8, 20), (16, 12)),
        "racks": ((uniform(15, 40), uniform(8, 20), uniform(5, 9)), 4.5, chance.randint(1, 5), chance.randint(2, 6), (40, 5)),
        "hall": ((uniform(20, 50), uniform(15, 40), uniform(5, 9)), 4.0, 1, chance.randint(0, 6), (60, 40)),
        "open plan": ((uniform(15, 30), uniform(12, 20), 3), 2.6, chance.randint(20, 40), chance.randint(20, 80), (8, 6)),
        "large hall": ((68, 48, 9), 4.0, 1, 2, (400, 250))}[kind]
    columns, rows = max(1, round(wide / step)), max(1, round(deep / step))
    flux = 5200 if high < 4 else 16000
    lux = columns * rows * flux / (wide * deep) * 0.45 * math.exp(chance.gauss(0, 0.4))
    walls = 0.2 if kind == "racks" else 0.5
    text = (f'<luxgate version="1" name="Room" maintenance-factor="0.8"><material id="white" reflectance="0.7"/>\n'
            f'<material id="wall" reflectance="{walls}"/><material id="floor" reflectance="0.2"/>\n'
            f'<luminaire-type id="panel" photometry="panel.ies" flux-lm="{flux}"/>\n'
            f'<room id="room" size="{wide:.3f} {deep:.3f} {high:.3f}" ceiling="white" walls="wall" floor="floor">\n'
            f'<luminaire-grid id="L" type="panel" origin="0 0 {high - 0.05:.3f}" size="{wide:.3f} {deep:.3f}" columns="{columns}" rows="{rows}"/>\n')
    for k in range(boxes):
        size = (wide * 0.6, 0.8, high * 0.7) if kind == "racks" else (min(1.4, wide / 3), 0.6, 0.7)
        place = uniform(0.1, wide - size[0] - 0.1), uniform(0.1, deep - size[1] - 0.1)
        text += f'<box id="b{k}" size="{size[0]:.3f} {size[1]} {size[2]:.3f}" position="{place[0]:.3f} {place[1]:.3f} 0" material="wall"/>\n'
    for k in range(planes):
        size = (wide - 0.8, deep - 0.8) if planes == 1 else (wide * 0.8, 1.2) if kind == "racks" else (min(1.6, wide / 2), min(1.4, deep / 2))
        place = uniform(0.2, wide - size[0] - 0.2), uniform(0.2, deep - size[1] - 0.2)
        text += (f'<plane id="p{k}" origin="{place[0]:.3f} {place[1]:.3f} 0.75" u="{size[0]:.3f} 0 0" v="0 {size[1]:.3f} 0" '
                 f'count="{points[0]} {points[1]}"><require quantity="average" at-least="{lux:.0f}"/>'
                 f'<require quantity="Uo" at-least="{uniform(0.2, 0.7):.2f}"/></plane>\n')
    return text + "</room></luxgate>\n"


def processor_s(*words):
    """Processor time of a run, and what it printed."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def measure(program, folder):
    """Prints MEASURED anew: processor time of one thread, by the difference of runs with five rooms and with one."""
    chance = random.Random(22)
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    shutil.copy(pathlib.Path(__file__).resolve().parents[2] / PANEL, folder / "panel.ies")
    def shard(projects, *more):
        """Processor time into a new store; and the store."""
        store = folder / "store"
        shutil.rmtree(store, ignore_errors=True)
        return processor_s(program, "check", *projects, "--jobs", 1, "--store", store, "--shard", "1/1", "-q", *more)[0], store

    (folder / "none.json").write_text('{"format": "luxgate-units", "format_version": 1, "units": []}')
    for kind, rooms in MEASURED.items():
        print(f'    "{kind}": [')
        for k in range(len(rooms)):
            text, projects = room_text(kind, chance), []
            for copy in range(2 if kind == "large hall" else 5):  # no two with the same looks
                projects.append(folder / f"{kind.replace(' ', '-')}-{k}-{copy}.xml")
                projects[-1].write_text(text.replace(' 0.75" u=', f' 0.75{copy}" u='))
            if k == 0 and kind == "small office":
                start = min(shard(projects[:1], "--units", folder / "none.json")[0] for _ in range(20))
                print(f"START_S = {start:.3f}")
            unit = json.loads(processor_s(program, "plan", "--units", "--format", "json", "-q", projects[0])[1])["units"]
            light, close = [], []
            for some in (projects[:1], projects):
                runs = [shard(some) for _ in range(2)]
                light.append(min(seconds for seconds, _ in runs))
                close.append(min(processor_s(program, "check", *some, "--jobs", 1, "--store", runs[0][1], "--stored-only",
                                             "--pictures", "off", "-q")[0] for _ in range(3)))
            files, more = [path for path in runs[0][1].glob("??/*")], len(projects) - 1
            print(f"        ({sum(one['first_look_s'] for one in unit):.4f}, {(light[1] - light[0]) / more:.4f}, {len(files) / len(projects):.1f}, "
                  f"{sum(path.stat().st_size for path in files) / len(projects) / 1000:.0f}, {1000 * (close[1] - close[0]) / more:.1f}),", flush=True)
        print("    ],")


if __name__ == "__main__":
    measure(*sys.argv[1:])
