"""luxgate import from outside: a drawing becomes a project that validates, and its changes are taken over.

    import_dxf.py LUXGATE FOLDER EXAMPLES    FOLDER is made anew

Drawings are written here, and by ezdxf where Debian's python3-ezdxf is installed: in several versions, as text and
binary. Where LUXGATE_SHARED_DATA has real drawings, every one must be listed or refused with a reason.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

PROGRAM, WORK, EXAMPLES = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words):
    return subprocess.run([PROGRAM, *map(str, words)], cwd=WORK, capture_output=True, text=True, check=False)


def pairs(*values):
    return "".join(f"{code:3}\n{value}\n" for code, value in values)


def outline(layer, handle, width, depth):
    corners = [(0, 0), (width, 0), (width, depth), (0, depth)]
    return [(0, "LWPOLYLINE"), (5, handle), (8, layer), (90, 4), (70, 1)] + [
        pair for x, y in corners for pair in ((10, x), (20, y))]


def insert(name, layer, handle, x, y, z, height=None):
    start = [(0, "INSERT"), (5, handle), (8, layer), (66, 0 if height is None else 1), (2, name), (10, x), (20, y), (30, z)]
    if height is None:
        return start
    return start + [(0, "ATTRIB"), (8, "0"), (1, height), (2, "HEIGHT"), (0, "SEQEND"), (8, "0")]


def drawing(lamps, unit=4):
    """lamps: handle -> (x, y, z, height) in millimetres."""
    block = [(0, "BLOCK"), (8, "0"), (2, "LUM"), (10, 0), (20, 0), (0, "LINE"), (8, "0"), (10, -300), (20, 0), (11, 300),
             (21, 0), (0, "ENDBLK")]
    things = outline("A-AREA", "1F", 6000, 4000)
    things += [(0, "TEXT"), (8, "A-AREA-IDEN"), (10, 100), (20, 100), (1, "101 B\\U+00FCro")]
    for handle, (x, y, z, height) in lamps.items():
        things += insert("LUM", "E-LITE", handle, x, y, z, height)
    return pairs((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, unit), (0, "ENDSEC"),
                 (0, "SECTION"), (2, "BLOCKS"), *block, (0, "ENDSEC"),
                 (0, "SECTION"), (2, "ENTITIES"), *things, (0, "ENDSEC"), (0, "EOF"))


MAP = """[[room]]
layer = "A-AREA"
names = "A-AREA-IDEN"
height = 3
reflectances = [0.7, 0.5, 0.2]
[[luminaire]]
type = "LUM*"
photometry = "panel.ies"
height = ["attribute:HEIGHT", "z"]
"""


def the_way_of_a_project():
    lamps = {"A": (1500, 2000, 0, "2800"), "B": (4500, 2000, 2700, None)}
    (WORK / "plan.dxf").write_text(drawing(lamps))
    (WORK / "map.toml").write_text(MAP)
    done = run("import", "plan.dxf", "--map", "map.toml", "-o", "project")
    expect(done.returncode == 0, f"the first import ends with {done.returncode}: {done.stdout}{done.stderr}")
    project = WORK / "project/project.xml"
    text = project.read_text()
    expect('name="101 Büro"' in text, "the room has its name")
    expect('id="L-A" type="panel" position="1.5 2 2.8"' in text, "a height comes from an attribute")
    expect('id="L-B" type="panel" position="4.5 2 2.7"' in text, "a height comes from the drawing")
    expect((WORK / "project/photometry/panel.ies").read_bytes() == (WORK / "panel.ies").read_bytes(), "photometry is copied")
    expect(run("validate", project).returncode == 0, "the project validates")

    again = run("import", "plan.dxf", "--map", "map.toml", "-o", "project")
    expect(again.returncode == 0 and project.read_text() == text, "the same drawing changes nothing")

    mine = text.replace("  </room>", '    <plane id="work" height="0.75"><require quantity="average" at-least="1"/></plane>\n  </room>')
    mine = mine.replace('position="4.5 2 2.7"', 'position="4.4 2 2.7"')
    project.write_text(mine)
    lamps = {"A": (1600, 2000, 0, "2800"), "B": (4600, 2000, 2700, None), "C": (3000, 1000, 2700, None)}
    (WORK / "plan.dxf").write_text(drawing(lamps))
    done = run("import", "plan.dxf", "--map", "map.toml", "-o", "project", "--json")
    expect(done.returncode == 1, f"a change on both sides ends with {done.returncode}")
    report = json.loads(done.stdout)
    expect(any("luminaire L-A, position: 1.5 2 2.8 -> 1.6 2 2.8" in line for line in report["changes"]), "what moved is said")
    expect("came: luminaire L-C" in report["changes"], "what came is said")
    expect(len(report["conflicts"]) == 1 and "L-B" in report["conflicts"][0], "what both changed is said")
    text = project.read_text()
    for part in ('id="work"', 'position="4.4 2 2.7"', 'position="1.6 2 2.8"', 'id="L-C"'):
        expect(part in text, f"after the second import {part} is there")
    done = run("check", project, "--quiet", "--goal", "accuracy", "--tolerance", "0.2")
    expect(done.returncode == 0, f"the project is checked: {done.returncode} {done.stderr}")


def refusals():
    for name, text, words in (("cut", drawing({})[:-40], "it is cut off"), ("dwg", "AC1027\0\0\0", "cannot import 'bad.dxf': it is an AutoCAD drawing (DWG); import reads DXF and IFC. Save it as DXF"),
                              ("obj", "v 0 0 0\nv 1 0 0\n", "it is an OBJ mesh; import reads DXF and IFC. Use it as <room file="),
                              ("words", "words\n", "it is neither DXF nor IFC (line 1: "),
                              ("no unit", drawing({}, 0), "24 m2 in mm"), ("wrong unit", drawing({}, 1), "unlikely")):
        (WORK / "bad.dxf").write_text(text)
        done = run("import", "bad.dxf", "--map", "map.toml", "-o", "bad")
        expect(done.returncode == 2 and words in done.stderr, f"{name}: {done.returncode} {done.stderr}")
        expect(not (WORK / "bad").exists(), f"{name}: nothing is written")
    done = run("import", "plan.dxf")
    expect(done.returncode == 2 and "--map FILE.toml is needed; --suggest-map prints one" in done.stderr, f"no map: {done.stderr}")
    done = run("import", "plan.dxf", "--map", "plan.dxf")
    expect(done.returncode == 2 and "it is an AutoCAD drawing (DXF); TOML is needed here" in done.stderr, f"a map of another kind: {done.stderr}")
    (WORK / "mine").mkdir()
    (WORK / "mine/project.xml").write_text("mine")
    done = run("import", "plan.dxf", "--map", "map.toml", "-o", "mine")
    expect(done.returncode == 2 and "no import made it" in done.stderr, "a project of somebody's own is kept")
    expect((WORK / "mine/project.xml").read_text() == "mine", "and its bytes")
    (WORK / "other.toml").write_text(MAP.replace("panel.ies", "gone.ies"))
    done = run("import", "plan.dxf", "--map", "other.toml")
    expect(done.returncode == 1 and "gone.ies" in done.stdout, f"photometry that is not there: {done.returncode} {done.stderr}")
    suggested = run("import", "plan.dxf", "--suggest-map")
    (WORK / "suggested.toml").write_text(suggested.stdout)
    done = run("import", "plan.dxf", "--map", "suggested.toml")
    expect(suggested.returncode == 0 and "at least one [[room]]" in done.stderr, "a suggested map is read back")


def holes():
    """A room with a rectangular and another column: solids, no light and no points in them."""
    loops = [[(0, 0), (6000, 0), (6000, 4000), (0, 4000)], [(1000, 1000), (2000, 1000), (2000, 2500), (1000, 2500)],
             [(4000, 1000), (5000, 1000), (5000, 3000), (4500, 2000)]]
    hatch = [(0, "HATCH"), (5, "5"), (8, "A-AREA"), (10, 0), (20, 0), (30, 0), (91, len(loops))]
    for loop in loops:
        hatch += [(92, 3), (72, 0), (73, 1), (93, len(loop)), *(pair for x, y in loop for pair in ((10, x), (20, y))), (97, 0)]
    (WORK / "holes.dxf").write_text(pairs((0, "SECTION"), (2, "ENTITIES"), *hatch, (0, "ENDSEC"), (0, "EOF")))
    (WORK / "holes.toml").write_text('unit = "mm"\n' + MAP[:MAP.find("[[luminaire]]")])
    done = run("import", "holes.dxf", "--map", "holes.toml", "-o", "holes")
    expect(done.returncode == 0 and "2 x room: a hole in its outline is written as a solid" in done.stdout,
           f"holes are said: {done.returncode} {done.stdout} {done.stderr}")
    meshes = list((WORK / "holes/holes").glob("*.obj"))
    expect(len(meshes) == 1 and 'size="1 1.5 3"' in (WORK / "holes/project.xml").read_text(), f"a box and a mesh: {meshes}")
    shown = run("geometry", "holes/project.xml").stdout
    expect("watertight yes" in shown and "shells     3 closed" in shown, f"columns are closed: {shown}")
    meshes[0].write_text(meshes[0].read_text() + "# by hand\n")
    done = run("import", "holes.dxf", "--map", "holes.toml", "-o", "holes")
    expect("it was changed by hand: it is kept" in done.stdout and meshes[0].read_text().endswith("hand\n"), "and kept")


def the_way_back():
    """What --format dxf writes is read back: outlines in metres and names in every alphabet."""
    name = "B\u00fcro \u20ac \u0151 \u03a9 \u65e5 50 %"
    (WORK / "back.xml").write_text(f"""<luxgate version="1"><material id="m" reflectance="0.5"/>
<luminaire-type id="p" photometry="panel.ies"/><room id="r" name="{name}" size="5 4 2.8" ceiling="m" walls="m" floor="m">
<luminaire id="L1" type="p" position="2 2 2.7"/></room></luxgate>""", encoding="utf-8")
    done = run("check", "back.xml", "--quiet", "--pictures", "off", "--format", "dxf=back.dxf")
    expect((WORK / "back.dxf").exists(), f"no drawing: {done.stderr}")
    (WORK / "back.toml").write_text("""[[room]]
layer = "LUX_ROOMS"
names = "LUX_ROOM_NAMES"
height = 2.8
reflectances = [0.5, 0.5, 0.5]
""")
    done = run("import", "back.dxf", "--map", "back.toml", "--unit", "m", "--json")
    rooms = json.loads(done.stdout)["room_list"]
    expect([(room["name"], room["area_m2"]) for room in rooms] == [(name, 20.0)], f"the way back: {rooms}")


def the_example():
    """The commands of its README as a reader types them, its bytes, and a drawing that changed."""
    name = "18-from-a-drawing"
    example = WORK / name
    shutil.copytree(EXAMPLES / name, example)
    text = (example / "README.md").read_text()
    blocks = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
    variables = dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}")
    output, count = "", 0
    for line in "".join(block for kind, block in blocks if kind == "sh").splitlines():
        command, _, code = line.partition("    # exit code ")
        done = subprocess.run(["bash", "-c", command], cwd=example, env=variables, capture_output=True, text=True, check=False)
        output += done.stdout
        count += 1
        expect(done.returncode == int(code or 0), f"{name}: {command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    expect(count == 6, f"{name}: {count} commands are in its README")
    for line in "".join(block for kind, block in blocks if kind == "").splitlines():
        expect(line in output.splitlines(), f"{name}: not printed: {line}")
    expect((example / "fresh/project.xml").read_bytes() == (EXAMPLES / name / ".luxgate-import.xml").read_bytes(),
           f"{name}: the import makes other bytes than .luxgate-import.xml has")
    for file in ("project.xml", ".luxgate-import.xml"):
        expect((example / file).read_bytes() == (EXAMPLES / name / file).read_bytes(), f"{name}: the second import changes {file}")
    maker = pathlib.Path(__file__).resolve().parent / "make_example_drawing.py"
    subprocess.run([sys.executable, "-B", maker, WORK / "made.dxf"], check=True)
    plan = (example / "plan.dxf").read_bytes()
    expect(plan == (WORK / "made.dxf").read_bytes(), f"{name}: plan.dxf is not what {maker.name} writes")

    moved = plan.replace(b" 10\r\n9150\r\n 20\r\n5375\r\n", b" 10\r\n9150\r\n 20\r\n5000\r\n")
    (example / "plan.dxf").write_bytes(moved)
    done = run("import", example / "plan.dxf", "--map", example / "map.toml", "-o", example, "--json")
    changes = json.loads(done.stdout)["changes"]
    expect(len(changes) == 1 and "position: 9.15 5.375 2.79 -> 9.15 5 2.79" in changes[0], f"{name}: after a move: {changes}")
    mine = (EXAMPLES / name / "project.xml").read_text().replace("9.15 5.375 2.79", "9.15 5 2.79")
    expect((example / "project.xml").read_text() == mine, f"{name}: a move changes more than one place")


def by_ezdxf():
    try:
        import ezdxf  # pylint: disable=import-outside-toplevel
    except ImportError:
        print("without python3-ezdxf: drawings of other programs are not tried")
        return
    for version in ("R12", "R2000", "R2004", "R2007", "R2010", "R2018"):
        for form in ("asc", "bin"):
            document = ezdxf.new(version)
            document.header["$INSUNITS"] = 4
            block = document.blocks.new("LUM")
            block.add_line((-300, 0), (300, 0))
            space = document.modelspace()
            space.add_polyline2d([(0, 0), (6000, 0), (6000, 4000), (0, 4000)], dxfattribs={"layer": "A-AREA"}).close(True)
            space.add_text("101 Büro", dxfattribs={"layer": "A-AREA-IDEN", "insert": (100, 100)})
            space.add_blockref("LUM", (1500, 2000, 2700), dxfattribs={"rotation": 30})
            space.add_blockref("LUM", (4500, 1000, 2700), dxfattribs={"row_count": 2, "row_spacing": 2000})
            name = f"{version}-{form}.dxf"
            document.saveas(WORK / name, fmt=form)
            done = run("import", name, "--map", "map.toml", "--unit", "mm", "--json")
            if done.returncode != 0:
                problems.append(f"{name}: {done.returncode} {done.stdout}{done.stderr}")
                continue
            report = json.loads(done.stdout)
            expect(abs(report["room_list"][0]["area_m2"] - 24.0) < 1e-9, f"{name}: area")
            expect(report["room_list"][0]["name"] == "101 Büro", f"{name}: name {report['room_list'][0]['name']}")
            expect(report["luminaires"] == {"found": 3, "written": 3}, f"{name}: luminaires {report['luminaires']}")


def curves_by_ezdxf():
    """Areas of rooms with curved sides, against chords of another program."""
    try:
        import ezdxf  # pylint: disable=import-outside-toplevel
    except ImportError:
        return
    corners = [(0, 0, 0), (10, 1, 0), (12, 8, 0), (3, 9, 0), (-2, 5, 0)]

    def ellipse(space):
        arc = space.add_ellipse((3, 4), (5, 0), 0.4, 0.3, 2.5)
        space.add_line(arc.end_point, (0, -2))
        space.add_line((0, -2), arc.start_point)
        return [*arc.flattening(1e-6), (0, -2, 0)]

    def closed(space):
        spline = space.add_spline()
        spline.set_closed(corners)
        return spline.flattening(1e-6)

    def rational(space):
        spline = space.add_spline()
        spline.set_closed_rational(corners, [1, 2, 1, 3, 0.5])
        return spline.flattening(1e-6)

    def hatch(space, is_forward):
        path = space.add_hatch().paths.add_edge_path()
        path.add_ellipse((0, 0), (5, 0), 0.5, 0, 130, ccw=is_forward)
        arc = path.edges[-1]
        ends = (arc.end_point, arc.start_point) if is_forward else (arc.start_point, arc.end_point)
        path.add_line(ends[0], (0, -3))
        path.add_line((0, -3), ends[1])
        turn = arc.end_param - arc.start_param
        return [*arc.construction_tool().vertices([arc.start_param + turn * i / 5000 for i in range(5001)]), (0, -3)]

    (WORK / "curves.toml").write_text('[[room]]\nlayer = "0"\nheight = 3\nreflectances = [0.7, 0.5, 0.2]\n')
    for name, make in (("ellipse", ellipse), ("closed", closed), ("rational", rational),
                       ("hatch", lambda space: hatch(space, True)), ("hatch-clockwise", lambda space: hatch(space, False))):
        document = ezdxf.new("R2010")
        points = list(make(document.modelspace()))
        area = abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1]))) / 2
        document.saveas(WORK / f"{name}.dxf")
        done = run("import", f"{name}.dxf", "--map", "curves.toml", "--unit", "m", "--json")
        rooms = json.loads(done.stdout)["room_list"] if done.stdout else []
        # Chords within 1 mm of at most 50 m.
        expect(len(rooms) == 1 and abs(rooms[0]["area_m2"] - area) < 0.05, f"{name}: {rooms} of {area} m2 {done.stderr}")


def real_drawings():
    folder = pathlib.Path(os.environ.get("LUXGATE_SHARED_DATA", "/nowhere")) / "dxf"
    for path in sorted(folder.glob("*.[dD][xX][fF]")):
        done = run("import", path, "--suggest-map")
        expect(done.returncode in (0, 2) and (done.returncode == 0) == (done.stderr == ""), f"{path.name}: {done.returncode} {done.stderr}")


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
shutil.copy(EXAMPLES / "photometry/lambert_panel_600.ies", WORK / "panel.ies")
the_way_of_a_project()
refusals()
holes()
the_way_back()
the_example()
by_ezdxf()
curves_by_ezdxf()
real_drawings()
if problems:
    sys.exit("\n".join(problems))
print("a drawing is a project, and its changes are taken over")
