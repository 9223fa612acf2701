"""--format xlsx, read by somebody else: the ZIP and XML readers of Python, and openpyxl where it is installed.

    xlsx.py LUXGATE FOLDER EXAMPLES [openpyxl]    FOLDER is made anew

Every sheet is held field by field against the CSV file of the same run; with the last word openpyxl reads all files, too.
"""
import csv
import json
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as tree
import zipfile

import small_designs

PROGRAM, WORK, EXAMPLES = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
SHEETS = ["Overview", "Requirements", "Luminaires", "Positions", "Points", "Notes"]
MAIN = "{http://schemas.openxmlformats.org/spreadsheetml/2006/main}"
LINK = "{http://schemas.openxmlformats.org/officeDocument/2006/relationships}id"
problems = []


def expect(is_so, words):
    if not is_so:
        problems.append(words)


def run(*words, code):
    done = subprocess.run([PROGRAM, *map(str, words)], cwd=WORK, capture_output=True, text=True, check=False)
    if done.returncode != code:
        sys.exit(f"{words}: exit code {done.returncode}, expected {code}\n{done.stderr}")


def column_of(reference):
    number = 0
    for letter in re.match("[A-Z]+", reference).group():
        number = number * 26 + ord(letter) - ord("A") + 1
    return number - 1


def unescaped(text):
    return re.sub("_x([0-9A-Fa-f]{4})_", lambda found: chr(int(found.group(1), 16)), text)


def cells_of(root):
    """Rows of values: str, float or None."""
    rows = []
    for number, row in enumerate(root.iter(MAIN + "row")):
        expect(int(row.get("r")) == number + 1, f"row {row.get('r')} stands at {number + 1}")
        values = []
        for cell in row.iter(MAIN + "c"):
            expect(cell.find(MAIN + "f") is None, "a formula")
            place = column_of(cell.get("r"))
            expect(place >= len(values), f"cell {cell.get('r')} comes twice or too late")
            values += [None] * (place - len(values))
            text = cell.find(f"{MAIN}is/{MAIN}t")
            expect((cell.get("t") == "inlineStr") == (text is not None), f"cell {cell.get('r')} is of another kind than it says")
            values.append(unescaped(text.text) if text is not None else float(cell.find(MAIN + "v").text))
        rows.append(values)
    return rows


def read(file):
    """{sheet: rows}, and the XML of the sheets."""
    with zipfile.ZipFile(file) as book:
        expect(book.testzip() is None, f"{file} is damaged")
        for item in book.infolist():
            expect(item.date_time == (1980, 1, 1, 0, 0, 0), f"{item.filename} has a date: {item.date_time}")
        targets = {link.get("Id"): link.get("Target") for link in tree.fromstring(book.read("xl/_rels/workbook.xml.rels"))}
        roots = {}
        for sheet in tree.fromstring(book.read("xl/workbook.xml")).iter(MAIN + "sheet"):
            roots[sheet.get("name")] = tree.fromstring(book.read("xl/" + targets[sheet.get(LINK)]))
        core = book.read("docProps/core.xml").decode()
    return {name: cells_of(root) for name, root in roots.items()}, roots, core


def without_apostrophe(text):
    """CSV has an apostrophe before what a spreadsheet would take for a formula."""
    return re.sub("(^|;)'(?=[=@+-])", r"\1", text)


def same(of_csv, of_sheet):
    if of_sheet is None:
        return of_csv == ""
    if isinstance(of_sheet, float):
        return of_csv != "" and float(of_csv) == of_sheet
    return without_apostrophe(of_csv) == of_sheet


# Headings for people of columns of the CSV file: the program's own table has them, too, but who reads it must not. All others have the name that they have there.
HEADS = {
    "Requirements": {"unit": "Unit", "value": "Calculated", "low": "Low", "high": "High", "margin": "Margin (% of the limit)",
                     "reason": "Reason", "clause": "Clause", "waiver": "Waived by", "note": "Notes"},
    "Points": {"x_m": "x (m)", "y_m": "y (m)", "z_m": "z (m)", "illuminance_lx": "Illuminance (lx)", "low_lx": "Low (lx)", "high_lx": "High (lx)",
               "direct_lx": "Direct (lx)", "indirect_lx": "Reflected (lx)", "rating": "Rating or ratio", "rating_low": "Low", "rating_high": "High"},
    "Positions": {"mark": "Mark", "id": "Id", "type": "Type", "maker": "Maker", "article": "Article number", "group": "Dimming group",
                  "x_m": "x (m)", "y_m": "y (m)", "z_m": "z (m)", "height_m": "Height above the floor (m)", "tilt_deg": "Tilt (°)",
                  "heading_deg": "Heading (°)", "turn_deg": "Turn (°)", "flux_lm": "Luminous flux, new (lm)", "power_w": "Power (W)",
                  "maintenance_factor": "Maintenance factor", "position": "Pos.", "product": "Product"}}


def place_of(name, sheet, heads):
    if name == "project" and "Project" in heads:
        return heads.index("Project")
    return heads.index(HEADS[sheet].get(name, name))


def hold_against(csv_file, sheet, rows):
    with open(csv_file, newline="", encoding="utf-8") as file:
        lines = list(csv.reader(file))
    expect(len(rows) == len(lines), f"{sheet}: {len(rows)} rows, the CSV file has {len(lines)}")
    places = [place_of(name, sheet, rows[0]) for name in lines[0]]
    for line, row in zip(lines[1:], rows[1:]):
        row = row + [None] * (len(rows[0]) - len(row))
        for name, field, place in zip(lines[0], line, places):
            if not same(field, row[place]):
                expect(False, f"{sheet}: {name} is {field!r} in the CSV file and {row[place]!r} in the sheet")
                return
    return len(lines) - 1


def both(name, *projects, code, options=(), more=()):
    """Runs a check into all of them; the sheets."""
    run("check", *projects, "--pictures", "off", *options, "--format", f"xlsx={name}.xlsx", "--format", f"csv={name}-results.csv", "--format",
        f"points-csv={name}-points.csv", "--format", f"luminaires-csv={name}-luminaires.csv", "--format", f"json={name}.json", code=code)
    sheets, roots, core = read(WORK / f"{name}.xlsx")
    wanted = SHEETS[:1] + (["Projects"] if len(projects) > 1 else []) + SHEETS[1:] + list(more) + ["About"]
    expect(list(sheets) == wanted, f"{name}: sheets {list(sheets)}")
    for kind, sheet in (("results", "Requirements"), ("points", "Points"), ("luminaires", "Positions")):
        expect(hold_against(WORK / f"{name}-{kind}.csv", sheet, sheets[sheet]), f"{name}: nothing was compared in {sheet}")
    for sheet, root in roots.items():
        if sheet in ("Overview", "About", "Revision"):
            continue
        expect(root.find(f"{MAIN}sheetViews/{MAIN}sheetView/{MAIN}pane").get("state") == "frozen", f"{sheet}: the head does not stay")
        reach = root.find(MAIN + "autoFilter").get("ref")
        expect(reach.endswith(str(len(sheets[sheet]))) and reach.startswith("A1:"), f"{sheet}: the filter is of {reach}")
    return sheets, core


def column(rows, head):
    place = rows[0].index(head)
    return [row[place] if place < len(row) else None for row in rows[1:]]


def summary(sheets):
    """Labels and values; in the overview a label has two columns."""
    return [[row[0], (row + [None] * 3)[2] or (row + [None] * 3)[1]] for row in sheets["Overview"] + sheets["About"] if row]


shutil.rmtree(WORK, ignore_errors=True)
WORK.mkdir(parents=True)

# The same words and numbers as CSV; every verdict as a word, whatever its colour.
example = EXAMPLES / "05-failing-corridor" / "project.xml"
sheets, core = both("corridor", example, code=1, options=["--tolerance", "0.1"])
expect("fail" in column(sheets["Requirements"], "Verdict"), "no requirement fails")
expect(["Verdict", "fail"] in summary(sheets), f"the summary has no verdict: {summary(sheets)[:12]}")
expect("dcterms:created" not in core, "a date that nobody asked for")
types = sheets["Luminaires"]
expect(types[-1][1] == "All luminaires" and column(types, "Count")[-1] == len(sheets["Positions"]) - 1, "types do not add up to the luminaires")

# The same again has the same bytes, also from the result; with a date it has that date.
first = (WORK / "corridor.xlsx").read_bytes()
both("corridor", example, code=1, options=["--tolerance", "0.1"])
expect((WORK / "corridor.xlsx").read_bytes() == first, "two runs have not the same bytes")
run("report", "corridor.json", "--format", "xlsx=again.xlsx", code=0)
expect((WORK / "again.xlsx").read_bytes() == first, "'report' has not the same bytes")
_, core = both("dated", example, code=1, options=["--tolerance", "0.1", "--timestamp", "1801396800"])
expect("2027-01-31T12:00:00Z" in core, "the date that was asked for is not in the properties")

# Names that a spreadsheet would calculate, break at or read as an escape.
EVIL = ["=HYPERLINK(\"http://x.invalid\",\"x\")", "+1|cmd!A1", "-1+2", "@SUM(A1)", "_x000D_ <a>&amp;", "\u202egnp \U0001f4a1"]
for number, name in enumerate(EVIL):
    escaped = name.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    design = small_designs.write(WORK / f"evil{number}.xml", room=escaped, name=escaped)
    sheets, _ = both(f"evil{number}", design, code=1, options=["--max-paths", "256"])
    shown = name.replace("\u202e", " ")
    expect(sheets["Overview"][0][0] == shown, f"{shown!r} is not the title of the overview: {sheets['Overview'][0]}")
    expect(shown in column(sheets["Requirements"], "Room"), f"{shown!r} is not in Requirements")

# Longer than a cell may be (results may hold such names, projects not): cut, and said. Longest that fits: whole.
result = json.loads((WORK / "corridor.json").read_text())
for length, is_cut in ((32767, False), (32768, True)):
    result["projects"][0]["name"] = "n" * length
    (WORK / "long.json").write_text(json.dumps(result))
    run("report", "long.json", "--format", "xlsx=long.xlsx", code=0)
    sheets = read(WORK / "long.xlsx")[0]
    told, title = dict(summary(sheets)), sheets["Overview"][0][0]
    expect(len(title) <= 32767 and (title == "n" * length) != is_cut, f"a name of {length} characters has {len(title)} in the sheet")
    expect(("Cut texts" in told) == is_cut, f"cut texts are not told rightly at {length}")

# Doubts: a part of a project, a waiver, a project that cannot be read.
design = small_designs.write(WORK / "doubts.xml", far_waiver=small_designs.WAIVER)
sheets, _ = both("doubts", design, code=0, options=["--max-paths", "256"])
expect("A. Meier" in str(sheets["Requirements"]) and "waived" in column(sheets["Notes"], "Kind"), "the waiver is not told")
expect("no: waived" in column(sheets["Requirements"], "Counts"), "what is waived seems to count")
sheets, _ = both("part", design, code=0, options=["--max-paths", "256", "--plane", "desk"])
expect("--plane desk" in str(dict(summary(sheets)).get("Part of the requirements")), "the summary does not say that a part was judged")
expect("part-selected" in column(sheets["Notes"], "id"), "part-selected is not among the warnings")
(WORK / "broken.xml").write_text("<luxgate")
sheets, _ = both("broken", "broken.xml", design, code=2, options=["--max-paths", "256"])
expect("not judged" in column(sheets["Projects"], "Verdict") and "error" in column(sheets["Notes"], "Kind"), "a broken project looks judged")

# Against an earlier result: what is asked less.
weaker = small_designs.write(WORK / "doubts.xml", far_waiver=small_designs.WAIVER, limit="80")
sheets, _ = both("revised", weaker, code=0, options=["--max-paths", "256", "--baseline", "doubts.json"], more=["Revision"])
expect("requires less" in str(sheets["Revision"]) and "≥ 80 lx" in str(sheets["Revision"]), "the revision is not told")
expect("weaker question" in column(sheets["Requirements"], "Verdict"), "a weaker question is no row")

# Somebody else's reader takes it.
if sys.argv[4:] == ["openpyxl"]:
    import openpyxl
    for file in sorted(WORK.glob("*.xlsx")):
        book = openpyxl.load_workbook(file)
        own = read(file)[0]
        expect(book.sheetnames == list(own), f"openpyxl: {file.name} has the sheets {book.sheetnames}")
        for sheet in book:
            for row, ours in zip(sheet.iter_rows(values_only=True), own[sheet.title], strict=True):
                ours = ours + [None] * (len(row) - len(ours))
                expect(all(a == b or str(a) == str(b) or unescaped(str(a)) == b for a, b in zip(row, ours, strict=True)),
                       f"openpyxl: {file.name}, {sheet.title}: {row} is {ours}")

for words in problems[:20]:
    print(words)
sys.exit(1 if problems else 0)
