"""--format dxf: another reader of DXF (python3-ezdxf) finds no fault, and finds what the result says: places, turns, values, names.

    dxf.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys

try:
    import ezdxf
    from ezdxf.lldxf.encoding import decode_dxf_unicode
except ImportError:
    print("skipped: python3-ezdxf is not installed")
    sys.exit(0)

PROGRAM, WORK = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
EXAMPLES = pathlib.Path(sys.argv[3]).resolve()
MOST_S = 250
SAME_M = 2e-6  # the file has micrometres
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def near(a, b, most=SAME_M):
    return all(abs(x - y) <= most for x, y in zip(a, b))


def luxgate(*words):
    run = subprocess.run([PROGRAM, *words], cwd=WORK, capture_output=True, text=True, timeout=MOST_S, check=False)
    expect(run.returncode in (0, 1, 3), f"{words}: ended with {run.returncode}: {run.stderr}")


# Names that would be groups, control codes or lines if they were written as they are.
EVIL = "r&#10;  0&#10;EOF %%u ^J \\U+000A B\u00fcro \U0001F4A1"
SHOWN = "r   0 EOF % %u ^J \\U+000A B\u00fcro <U+1F4A1>"  # as XML and printing leave it
PROJECT = f"""<luxgate version="1" name="{EVIL}" maintenance-factor="0.8">
<material id="m" reflectance="0.5"/><luminaire-type id="spot" photometry="spot.ies"/>
<room id="r" name="{EVIL}" size="5 4 2.8" ceiling="m" walls="m" floor="m">
<luminaire id="L1" type="spot" position="1.25 1.5 2.7"/>
<luminaire id="L2" type="spot" position="3.25 1.5 2.6" rotation="30"/>
<plane id="desk" name="{EVIL}" origin="1 1 0.8" u="3 0 0" v="0 2 0" count="6 4"><require quantity="average" at-least="1"/></plane>
<plane id="over" origin="1 1 1.2" u="3 0 0" v="0 2 0" count="6 4"><require quantity="average" at-least="100000"/></plane>
<plane id="wall" origin="5 1 0.5" u="0 2 0" v="0 0 1.5" count="4 3"/>
</room></luxgate>
"""
PHOTOMETRY = """IESNA:LM-63-2002
[TEST] none
[MANUFAC] luxgate tests
TILT=NONE
1 -1 1 4 3 1 2 0.2 0.6 0
1 1 30
0 30 60 90
0 45 90
1000 860 480 0
1000 700 380 0
1000 600 280 0
"""
shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
(WORK / "spot.ies").write_text(PHOTOMETRY)
(WORK / "evil.xml").write_text(PROJECT)


def read(path):
    """Read strictly, and examined."""
    drawing = ezdxf.readfile(path)
    expect(drawing.dxfversion == "AC1009", f"{path.name}: version {drawing.dxfversion}")
    expect(drawing.encoding == "cp1252" and drawing.header["$DWGCODEPAGE"] == "ANSI_1252", f"{path.name}: encoding {drawing.encoding}")
    audit = drawing.audit()
    for found in [*audit.errors, *audit.fixes]:
        # It loses the owners of what ends polylines in blocks, in R12 files of AutoCAD, too.
        expect(found.message.startswith("Deleted SEQEND"), f"{path.name}: {found.message}")
    return drawing


def of(drawing, kind, layer):
    return [entity for entity in drawing.modelspace().query(kind) if entity.dxf.layer == layer]


def words(drawing, layer):
    return [decode_dxf_unicode(entity.plain_text()) for entity in of(drawing, "TEXT", layer)]


def value_layers(drawing):
    return [layer.dxf.name for layer in drawing.layers if layer.dxf.name.startswith("LUX_VALUES")]


def is_level(plane):
    grid = plane["grid"]
    u, v = grid["u"], grid["v"]
    return abs(u[0] * v[1] - u[1] * v[0]) > 1 - 1e-6


def is_value(text, value):
    """Whether a text of the drawing is the value, as rounded; a rating below its scale is "< 10"."""
    if text in ("x", "-"):
        return False
    return value < float(text[2:]) if text.startswith("< ") else abs(float(text) - value) <= 0.011 * abs(value) + 0.006


def compare(name, drawing, result):
    rooms = [room for project in result["projects"] for room in project["spaces"]]
    outlines = [[(v.dxf.location.x, v.dxf.location.y) for v in line.vertices] for line in of(drawing, "POLYLINE", "LUX_ROOMS")]
    asked = [room["footprint_m"] for room in rooms if room["footprint_m"]]
    expect(len(outlines) == len(asked), f"{name}: {len(outlines)} outlines of {len(asked)} rooms")
    for drawn, outline in zip(outlines, asked):
        expect(len(drawn) == len(outline) and all(map(near, drawn, outline)), f"{name}: a room has other corners: {drawn}")
    expect(all(line.is_closed for line in of(drawing, "POLYLINE", "LUX_ROOMS")), f"{name}: a room is open")

    inserts = of(drawing, "INSERT", "LUX_LUMINAIRES")
    marks = [(number + 1, mark, room) for room in rooms for number, mark in enumerate(room["luminaires"])]
    expect(len(inserts) == len(marks), f"{name}: {len(inserts)} inserts of {len(marks)} luminaires")
    for insert, (number, mark, room) in zip(inserts, marks):
        said = {attribute.dxf.tag: decode_dxf_unicode(attribute.dxf.text) for attribute in insert.attribs}
        expect(near(insert.dxf.insert, mark["position_m"]), f"{name}: luminaire {number} is at {insert.dxf.insert}")
        if math.hypot(*mark["c0"]) > 0.1:
            turn = math.degrees(math.atan2(mark["c0"][1], mark["c0"][0])) % 360
            expect(min(abs(insert.dxf.rotation - turn), 360 - abs(insert.dxf.rotation - turn)) < 1e-5,
                   f"{name}: luminaire {number} is turned by {insert.dxf.rotation}, not {turn}")
        expect((said["NUMBER"], said["ID"], said["TYPE"], said["GROUP"]) == (str(number), mark["id"], mark["type"], mark["group"]),
               f"{name}: luminaire {number} says {said}")
        block = drawing.blocks.get(insert.dxf.name)
        corners = [insert.matrix44().transform(v.dxf.location) for line in block.query("POLYLINE") for v in line.vertices]
        expect(len(corners) == len(mark["outline_m"]) and all(any(near(a, b, 2e-5) for b in mark["outline_m"]) for a in corners),
               f"{name}: luminaire {number} has another opening: {corners}")
    numbers = words(drawing, "LUX_LUMINAIRE_NUMBERS")
    said = [attribute.dxf.text for insert in inserts for attribute in insert.attribs if attribute.dxf.tag == "MARK"]
    expect(numbers == said, f"{name}: the plan has the marks {numbers}, and blocks {said}")

    # Every value of a level plane is at its point, to the digits that are shown.
    at = {}
    for layer in value_layers(drawing):
        for text in of(drawing, "TEXT", layer):
            place = text.dxf.align_point
            at.setdefault(tuple(round(x, 6) for x in place), []).append(text.dxf.text)
    for room in rooms:
        for plane in room["planes"]:
            if not plane["is_computed"] or not is_level(plane):
                continue
            columns = plane["points"]["columns"]
            value_at = next(i for i, column in enumerate(columns) if column in ("illuminance_lx", "ugr", "modelling", "value") or i == 8)
            for row in plane["points"]["rows"]:
                shown = at.get(tuple(round(x, 6) for x in row[2:5]), [])
                if row[value_at] is None:
                    expect("-" in shown, f"{name}: {plane['id']}: a point without a value shows {shown}")
                    continue
                is_there = any(is_value(text, row[value_at]) for text in shown)
                expect(is_there, f"{name}: {plane['id']}: {row[value_at]} at {row[2:5]} shows {shown}")

    blocks = of(drawing, "INSERT", "LUX_ROOM_DATA")
    said = [{attribute.dxf.tag: attribute.dxf.text for attribute in block.attribs} for block in blocks]
    expect([one["ID"] for one in said] == [room["id"] for room in rooms], f"{name}: blocks of rooms {said}")
    heights = {round(text.dxf.height, 6) for text in drawing.modelspace().query("TEXT")}
    expect(len(heights) == 1, f"{name}: texts have the heights {heights}")
    legend = " ".join(words(drawing, "LUX_LEGEND"))
    frame = [v.dxf.location.y for line in of(drawing, "POLYLINE", "LUX_LEGEND") for v in line.vertices]
    expect(max(frame) - min(frame) <= drawing.header["$EXTMAX"][1] - drawing.header["$EXTMIN"][1] + 1e-6, f"{name}: the legend is taller than the plan")
    for project in result["projects"]:
        for message in project["diagnostics"]:
            expect(f"[{message['id']}]" in legend, f"{name}: the legend does not have {message['id']}")


def check(name, project, *more):
    files = WORK / f"{name}.json", WORK / f"{name}.dxf"
    luxgate("check", project, "--pictures", "off", "--quiet", "--format", f"json={files[0]}", "--format", f"dxf={files[1]}", *more)
    drawing, result = read(files[1]), json.loads(files[0].read_text())
    compare(name, drawing, result)
    luxgate("report", files[0], "--format", f"dxf={WORK / 'again.dxf'}")
    expect((WORK / "again.dxf").read_bytes() == files[1].read_bytes(), f"{name}: the stored result gives other bytes")
    return drawing


evil = check("evil", "evil.xml")
expect(b"B\xfcro" in (WORK / "evil.dxf").read_bytes(), "letters of Western Europe are no bytes of Windows-1252")
shown_names = words(evil, "LUX_ROOM_NAMES") + [decode_dxf_unicode(attribute.dxf.text) for insert in of(evil, "INSERT", "LUX_ROOM_DATA") for attribute in insert.attribs]
expect(SHOWN in shown_names, f"names: {shown_names}")
names = " | ".join(words(evil, "LUX_PLANE_NAMES"))
expect(SHOWN + ": pass" in names and "over: fail" in names, f"planes: {names}")
expect(evil.layers.get("LUX_VALUES_2").is_frozen() and not evil.layers.get("LUX_VALUES").is_frozen(), "values over others are not frozen")
# Nothing is required of the wall, and something of the others.
expect(len(of(evil, "TEXT", "LUX_VALUES_2")) == 24 and len(of(evil, "TEXT", "LUX_VALUES_OTHER")) == 12, "values are missing")
expect(len(of(evil, "TEXT", "LUX_VALUES") + of(evil, "TEXT", "LUX_VALUES_MORE")) >= 24, "values of the desk are missing")
expect(len({insert.dxf.name for insert in of(evil, "INSERT", "LUX_LUMINAIRES")}) == 1, "one type has several blocks")
luxgate("report", "evil.json", "--format", "dxf=inches.dxf", "--dxf-unit", "in", "--dxf-scale", "1:100")
inches = read(WORK / "inches.dxf")
expect(inches.header["$INSUNITS"] == 1, "the unit is not said")
corner = of(inches, "POLYLINE", "LUX_ROOMS")[0].vertices[2].dxf.location
expect(near(corner, (5 / 0.0254, 4 / 0.0254, 0), 1e-5), f"a corner in inches: {corner}")
expect(all(abs(text.dxf.height - 0.25 / 0.0254) < 1e-5 for text in inches.modelspace().query("TEXT")), "texts are not 2.5 mm high at 1:100")
for example in ("01-one-luminaire", "13-escape-route", "17-storey"):
    check(example, EXAMPLES / example / "project.xml", "--tolerance", "0.2")

luxgate("check", "evil.xml", "--pictures", "off", "--format", f"dxf={WORK / 'small.dxf'}", "--quiet")
expect((WORK / "small.dxf").read_bytes() == (WORK / "evil.dxf").read_bytes(), "the same input gives other bytes")

for words_of_problem in problems[:40]:
    print("dxf.py: " + words_of_problem, file=sys.stderr)
sys.exit(1 if problems else 0)
