"""How many luminaires there are, their flux and their power: the same in every output of the same run.

    luminaire_totals.py LUXGATE FOLDER EXAMPLES RESULTS...    FOLDER is made anew

One project of two rooms, a road and a type that nobody uses is checked here; each result.json below the folders RESULTS,
which other tests have written, is told again. The numbers are read from what was written, in each output by itself.
"""
import collections
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as tree
import zipfile

PROGRAM, WORK, EXAMPLES = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
RESULTS = [pathlib.Path(word) for word in sys.argv[4:]]
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
PROJECT = """<luxgate version="1" name="Totals" maintenance-factor="0.8">
<material id="m" reflectance="0.5"/>
<luminaire-type id="panel" photometry="batwing_1200.ies"/>
<luminaire-type id="spare" photometry="batwing_1200.ies"/>
<luminaire-type id="pendant" photometry="pendant_direct_indirect.ldt"/>
<luminaire-type id="pole" photometry="road_lens.ies" power-w="57"/>
<room id="one" name="1.01 Office" size="4 3 2.8" ceiling="m" walls="m" floor="m">
<luminaire-grid id="L" type="panel" origin="0 0 2.79" size="4 3" columns="2" rows="2"/>
<luminaire id="P" type="pendant" position="2 1.5 2.2"/>
<plane id="desk" origin="1 1 0.75" u="2 0 0" v="0 1 0" count="2 2"><require quantity="average" at-least="1"/></plane></room>
<room id="two" name="1.02 Store" origin="10 0 0" size="4 3 2.8" ceiling="m" walls="m" floor="m">
<luminaire id="Q" type="panel" position="2 1.5 2.79"/></room>
<road id="street" name="Street" origin="0 -20 0" width="7" lanes="2" spacing="22" surface="R3">
<luminaire-row id="right" type="pole" side="right" height="7" overhang="0.3"/>
<require quantity="road-luminance" at-least="0.1"/></road>
</luxgate>
"""
Sums = collections.namedtuple("Sums", "count flux_lm power_w")  # power_w: None = not known of all
problems = []


def run(*words, codes=(0,)):
    done = subprocess.run([PROGRAM, *map(str, words)], cwd=WORK, capture_output=True, text=True, check=False)
    if done.returncode not in codes:
        sys.exit(f"{words}: exit code {done.returncode}\n{done.stderr}")


def is_same(a, b, share):
    return (a is None) == (b is None) and (a is None or abs(a - b) <= share * max(abs(a), abs(b)) + 1e-9)


def expect(name, is_, should_be, flux=1e-9, power=1e-9):
    """flux, power: how far a rounded number may be off, as a share."""
    if is_.count != should_be.count or not is_same(is_.power_w, should_be.power_w, power) or (
            is_.flux_lm is not None and not is_same(is_.flux_lm, should_be.flux_lm, flux)):
        problems.append(f"{name}: {is_}, expected {should_be}")


def added(rows):
    """rows: (count, flux of one, power of one or None)."""
    rows = [row for row in rows if row[0] > 0]
    power = None if any(row[2] is None for row in rows) else sum(row[0] * row[2] for row in rows)
    return Sums(sum(row[0] for row in rows), sum(row[0] * row[1] for row in rows), power)


def told_lm(row):
    """As people read it: of a luminaire as in its file what the file states, where its intensities agree within 1 %."""
    calculated, stated = row["flux_lm"] or 0.0, row.get("stated_flux_lm")
    is_of_file = not row.get("package") and calculated == row.get("file_flux_lm")
    return stated if is_of_file and stated and abs(stated - calculated) <= 0.01 * stated else calculated


def of_types(project):
    return added([(row["count"], told_lm(row), row["power_w"]) for row in project["luminaires"]])


def of_marks(project, spaces):
    types = {row["type"]: row for row in project["luminaires"]}
    marks = [types[mark["type"]] for space in spaces for mark in space["luminaires"]]
    return added([(1, told_lm(row), row["power_w"]) for row in marks])


def of_csv(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return rows, added([(1, float(row["flux_lm"]), float(row["power_w"]) if row["power_w"] else None) for row in rows])


def of_xlsx(path):
    """Rows of the sheet 'Luminaires', by the heads of its columns."""
    with zipfile.ZipFile(path) as book:
        sheets = [sheet.get("name") for sheet in tree.fromstring(book.read("xl/workbook.xml")).iter(MAIN + "sheet")]
        root = tree.fromstring(book.read(f"xl/worksheets/sheet{sheets.index('Luminaires') + 1}.xml"))
    rows = []
    for row in root.iter(MAIN + "row"):
        cells = {}
        for cell in row.iter(MAIN + "c"):
            text = "".join(cell.itertext())
            cells[re.match("[A-Z]+", cell.get("r")).group()] = text if cell.get("t") == "inlineStr" else float(text or "nan")
        rows.append(cells)
    heads = rows[0]
    return [{heads[place]: value for place, value in row.items()} for row in rows[1:]]


def number(words):
    """Of a cell of the report: "11 654.0 W"; None: it has none."""
    found = re.fullmatch(r"([\d\u202f\u2009\u00a0 ]+(?:\.\d+)?)(?: ?(?:W|lm))?", words.strip())
    return float(re.sub(r"[^\d.]", "", found.group(1))) if found else None


def tables(html, kind):
    """Rows of all tables of that class: cells without their notes."""
    found = re.findall(rf'<table class="{kind}">(.*?)</table>', html, re.S)
    for table in found:
        table = re.sub(r'<span class="note">.*?</span>', "", table, flags=re.S)
        yield [[re.sub("<[^>]*>", "", cell).strip() for cell in re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.S)]
               for row in re.findall(r"<tr[^>]*>(.*?)</tr>", table, re.S)]


def check(path, name):
    document = json.loads(path.read_text(encoding="utf-8"))
    files = {kind: WORK / f"{name}.{kind}" for kind in ("html", "csv", "xlsx")}
    run("report", path, "--quiet", "--format", f"html={files['html']}", "--format", f"luminaires-csv={files['csv']}",
        "--format", f"xlsx={files['xlsx']}")
    luminaires, _ = of_csv(files["csv"])
    sheet = of_xlsx(files["xlsx"])
    html = files["html"].read_text(encoding="utf-8")
    schedules, energies = list(tables(html, "schedule")), list(tables(html, "energy"))
    is_told = 0
    for project in document["projects"]:
        sums = of_types(project)
        where = f"{name} {project['path']}"
        expect(f"{where}: JSON, luminaires of spaces", of_marks(project, project["spaces"]), sums)
        for space in project["spaces"]:
            own, power = of_marks(project, [space]), space["power"]
            if power.get("of_spacing"):
                continue
            told = Sums(power["luminaires"], None, None if power["without_power"] else power["power_w"])
            expect(f"{where}: JSON, power of {space['id']}", told, own)
        mine = [row for row in luminaires if row["project"] == project["path"]]
        expect(f"{where}: CSV", added([(1, float(row["flux_lm"]), float(row["power_w"]) if row["power_w"] else None)
                                       for row in mine]), sums)
        rows = [row for row in sheet if row.get("Project", row.get("project")) == project["path"]]
        types = [row for row in rows if row.get("Pos.")]
        if project["luminaires"]:
            expect(f"{where}: XLSX, types", added([(row["Count"], row["Luminous flux of one, new (lm)"], row.get("Power of one (W)"))
                                                   for row in types]), sums)
            total = next(row for row in rows if row.get("Type") == "All luminaires" and "Count" in row)
            expect(f"{where}: XLSX, total", Sums(total["Count"], total["Luminous flux of all, new (lm)"],
                                                 total.get("Power of all (W)")), sums)
        if sums.count == 0:
            continue
        is_told += 1
        expect(f"{where}: HTML, schedule", Sums(int(schedules[0][-1][8 - 1]), number(schedules[0][-1][1]), number(schedules[0][-1][2])),
               sums, 2e-3, 2e-3)
        lines = [row for row in schedules.pop(0)[1:-1]]
        if sum(int(row[8]) for row in lines) != sums.count:
            problems.append(f"{where}: HTML, rows of the schedule have {[row[8] for row in lines]}, expected {sums.count}")
        energy = [row for row in energies.pop(0) if not row[0].startswith("Rooms with floor area")]  # a sum of some rows
        rows = energy[1:-1] if len(energy) > 2 and len(project["spaces"]) > 1 else energy[1:]
        powers = [number(row[3]) for row, space in zip(rows, project["spaces"])]
        known = None if any(power is None for power in powers) else sum(powers)
        expect(f"{where}: HTML, rows of energy", Sums(sum(int(row[2]) for row in rows), None, known), sums, power=2e-3)
        if len(project["spaces"]) > 1:
            expect(f"{where}: HTML, energy", Sums(int(energy[-1][2]), None, number(energy[-1][3])), sums, power=2e-3)
    return is_told


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)
for file in ("batwing_1200.ies", "pendant_direct_indirect.ldt", "road_lens.ies"):
    shutil.copy(EXAMPLES / "photometry" / file, WORK / file)
(WORK / "project.xml").write_text(PROJECT, encoding="utf-8")
run("check", "project.xml", "--quiet", "--max-paths", "4096", "--format", "json=own.json", codes=(0, 1, 2, 3, 4))
told = check(WORK / "own.json", "own")
own = json.loads((WORK / "own.json").read_text(encoding="utf-8"))["projects"][0]
street = own["spaces"][2]
if not (street["power"]["of_spacing"] and street["power"]["luminaires"] == 1 and len(street["luminaires"]) > 1):
    problems.append(f"the road is not one: {street['power']}, {len(street['luminaires'])} drawn")
text = re.sub("<[^>]*>", "", (WORK / "own.html").read_text(encoding="utf-8"))
for words in ("not used, therefore not counted: B (spare)", f"Street: the calculation uses the {len(street['luminaires'])} luminaires counted here"):
    if words not in text:
        problems.append(f"the report does not say '{words}'")

found = sorted(path for folder in RESULTS for path in folder.glob("*/result.json"))
# Another test breaks results on purpose: what is no result tells nothing.
found += sorted(path for folder in RESULTS for path in folder.glob("*.json") if path.name not in ("again.json", "changed.json"))
for i, path in enumerate(found):
    told += check(path.resolve(), f"{i}-{path.parent.name}-{path.stem}")
print(f"{len(found)} results of other tests, {told} projects with luminaires")
sys.exit("\n".join(problems) or 0)
