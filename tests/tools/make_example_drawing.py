#!/usr/bin/env python3
"""Writes examples/18-from-a-drawing/plan.dxf: a drawing as CAD programs save it in release 12, in millimetres.

    make_example_drawing.py [FILE]
"""
import pathlib
import sys

LAYERS = {"A-WALL": 7, "A-AREA": 3, "A-AREA-IDEN": 3, "A-FURN": 8, "A-LEGEND": 7, "E-LITE": 1, "E-EGRESS": 5}
# x, y, width, depth
ROOMS = {"1.01 Office": (0, 2000, 6000, 4500), "1.02 Meeting": (6150, 2000, 4000, 4500), "1.03 Corridor": (0, 0, 10150, 1850)}
WALLS = [(-300, -300, 10450, -300), (10450, -300, 10450, 6800), (10450, 6800, -300, 6800), (-300, 6800, -300, -300)]

groups, handles = [], 0x20


def add(*pairs):
    groups.extend(pairs)


def entity(kind, layer):
    global handles
    handles += 1
    add((0, kind), (5, f"{handles:X}"), (8, layer))


def at(x, y, z=0, code=10):
    add((code, x), (code + 10, y), (code + 20, z))


def line(layer, x0, y0, x1, y1):
    entity("LINE", layer)
    at(x0, y0)
    at(x1, y1, 0, 11)


def polyline(layer, corners, is_closed):
    entity("POLYLINE", layer)
    add((66, 1))
    at(0, 0)
    add((70, int(is_closed)))
    for x, y in corners:
        entity("VERTEX", layer)
        at(x, y)
    entity("SEQEND", layer)


def rectangle(layer, x, y, width, depth):
    polyline(layer, [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth)], True)


def text(layer, x, y, words, height=200):
    entity("TEXT", layer)
    at(x, y)
    add((40, height), (1, words))


def block(name, width, depth, tags=()):
    entity("BLOCK", "0")
    add((2, name), (70, 2 if tags else 0))
    at(0, 0)
    add((3, name))
    rectangle("0", -width / 2, -depth / 2, width, depth)
    for tag in tags:
        entity("ATTDEF", "0")
        at(0, 0)
        add((40, 100), (1, ""), (3, tag), (2, tag), (70, 1))
    entity("ENDBLK", "0")


def insert(name, layer, x, y, turn=0, **attributes):
    entity("INSERT", layer)
    if attributes:
        add((66, 1))
    add((2, name))
    at(x, y)
    add((50, turn))
    for tag, value in attributes.items():
        entity("ATTRIB", layer)
        at(x, y)
        add((40, 100), (1, value), (2, tag), (70, 1))
    if attributes:
        entity("SEQEND", layer)


def section(name):
    add((0, "SECTION"), (2, name))


def end():
    add((0, "ENDSEC"))


def tables():
    section("TABLES")
    add((0, "TABLE"), (2, "LTYPE"), (70, 1), (0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (3, "Solid line"), (72, 65), (73, 0), (40, 0),
        (0, "ENDTAB"), (0, "TABLE"), (2, "LAYER"), (70, len(LAYERS) + 1))
    for name, colour in {"0": 7, **LAYERS}.items():
        add((0, "LAYER"), (2, name), (70, 0), (62, colour), (6, "CONTINUOUS"))
    add((0, "ENDTAB"))
    end()


def blocks():
    section("BLOCKS")
    block("PANEL", 600, 600, ["HEIGHT", "GROUP"])
    block("PENDANT", 1200, 200, ["HEIGHT", "GROUP"])
    block("EMERGENCY", 200, 200, ["HEIGHT", "GROUP"])
    block("DESK", 1600, 800)
    block("TABLE", 2400, 1000)
    end()


def drawing():
    for wall in WALLS:
        line("A-WALL", *wall)
    for name, (x, y, width, depth) in ROOMS.items():
        rectangle("A-AREA", x, y, width, depth)
        text("A-AREA-IDEN", x + 200, y + 200, name)
    for x in (1400, 4200):
        for y in (3000, 4250, 5500):
            insert("PENDANT", "E-LITE", x, y, 90, HEIGHT="2300", GROUP="office")
    for x in (7150, 9150):
        for y in (3125, 5375):
            insert("PANEL", "E-LITE", x, y, HEIGHT="2790", GROUP="meeting")
    for x in (1000, 3050, 5075, 7100, 9150):
        insert("PANEL", "E-LITE", x, 925, HEIGHT="2590", GROUP="corridor")
    for x in (1400, 3850, 6300, 8750):
        insert("EMERGENCY", "E-LITE", x, 925, HEIGHT="2500", GROUP="emergency")
    # Under the canopy, before the door: it is not in a room.
    insert("PANEL", "E-LITE", 11200, 925, HEIGHT="2590", GROUP="outside")
    for x in (1400, 4200):
        insert("DESK", "A-FURN", x, 4000)
    insert("TABLE", "A-FURN", 8150, 4250, 90)
    rectangle("A-FURN", 0, 6000, 2000, 450)  # a cupboard
    polyline("E-EGRESS", [(300, 925), (9850, 925)], False)
    # Symbols beside the plan: the map ignores their layer.
    for row, name in enumerate(("PANEL", "PENDANT", "EMERGENCY")):
        insert(name, "A-LEGEND", 12800, 6000 - 900 * row)
        text("A-LEGEND", 13700, 5900 - 900 * row, name)


def header():
    section("HEADER")
    add((9, "$ACADVER"), (1, "AC1009"), (9, "$HANDLING"), (70, 1), (9, "$HANDSEED"), (5, "200"), (9, "$EXTMIN"))
    at(-300, -300)
    add((9, "$EXTMAX"))
    at(15000, 6800)
    end()


header()
tables()
blocks()
section("ENTITIES")
drawing()
end()
add((0, "EOF"))
if handles >= 0x200:
    sys.exit("$HANDSEED is a handle that is taken")

folder = pathlib.Path(__file__).resolve().parent.parent.parent / "examples/18-from-a-drawing"
path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else folder / "plan.dxf"
path.write_bytes("".join(f"{code:3}\r\n{value}\r\n" for code, value in groups).encode("ascii"))
